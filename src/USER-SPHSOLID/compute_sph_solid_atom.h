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

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(sph/solid/atom,ComputeSPHSolidAtom);
// clang-format on
#else

#ifndef LMP_COMPUTE_SPH_SOLID_ATOM_H
#define LMP_COMPUTE_SPH_SOLID_ATOM_H

#include "compute.h"

namespace LAMMPS_NS {

class ComputeSPHSolidAtom : public Compute {
 public:
  ComputeSPHSolidAtom(class LAMMPS *, int, char **);
  ~ComputeSPHSolidAtom() override;
  void init() override;
  void compute_peratom() override;
  double memory_usage() override;

 private:
  class PairSPHSolid *pair;
  int nvalues;
  int *which;    // index of each quantity, in the order asked for
  int nmax;
  double *pending;    // heat of the half step that atom->esph lags behind
  bool needs_pending;

  double value(int quantity, int i, const double *stress) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
