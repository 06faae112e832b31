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

#ifdef ATOM_CLASS
// clang-format off
AtomStyle(sph/solid,AtomVecSPHSolid);
// clang-format on
#else

#ifndef LMP_ATOM_VEC_SPH_SOLID_H
#define LMP_ATOM_VEC_SPH_SOLID_H

#include "atom_vec.h"

namespace LAMMPS_NS {

// per-atom state of a solid that core LAMMPS has no array for

struct SPHSolidArrays {
  double **stress;    // deviatoric Cauchy stress xx yy zz xy xz yz [pressure]
  double *epl;        // effective plastic strain [-]
  // velocity at the last force evaluation, half a step back, once it is kept (PairSPHSolid), by
  // components: one array of rows has a pointer to each besides [velocity]
  double *vhalf[3];
  double *rho_weight;    // density behind the volume weights of that evaluation [density]
  // the internal energy per mass of the other time: half a step back while atom->esph has caught up
  // with velocities (between runs); caught up while a restart file is written during a run, see
  // FixSPHSolid.  Scratch otherwise [energy/mass]
  double *esph_half;
  bool swaps_energies = false;    // for a restart file the two energies change places
};

class AtomVecSPHSolid : virtual public AtomVec {
 public:
  AtomVecSPHSolid(class LAMMPS *);

  void grow_pointers() override;
  void data_atom_post(int) override;
  void pack_restart_pre(int) override;
  void pack_restart_post(int) override;
  int property_atom(const std::string &) override;
  void pack_property_atom(int, double *, int, int) override;

  // the arrays of this Atom instance, nullptr without atom style sph/solid
  static SPHSolidArrays *arrays(class Atom *);

 private:
  SPHSolidArrays *own;
};

}    // namespace LAMMPS_NS

#endif
#endif
