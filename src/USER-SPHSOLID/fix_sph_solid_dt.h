/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(sph/solid/dt,FixSPHSolidDt);
// clang-format on
#else

#ifndef LMP_FIX_SPH_SOLID_DT_H
#define LMP_FIX_SPH_SOLID_DT_H

#include "fix.h"

namespace LAMMPS_NS {

class FixSPHSolidDt : public Fix {
 public:
  FixSPHSolidDt(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  double compute_scalar() override;

 private:
  class PairSPHSolid *pair;
  double cfl;               // 0: what the pair style's frame takes usually
  double dt_max, dt_min;    // 0: no limit
  bool warned, warned_cfl;

  void take(double);
};

}    // namespace LAMMPS_NS

#endif
#endif
