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

/* ----------------------------------------------------------------------
   Numbers for output that follow from a Cauchy stress, whose deviator is in LAMMPS'
   order xx, yy, zz, xy, xz, yz [pressure].  No LAMMPS include here.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_INVARIANTS_H
#define LMP_SPH_SOLID_INVARIANTS_H

#include "sph_solid_material.h"

#include <cmath>

namespace SPHSolid {

// J2 = S:S/2

inline double second_invariant(const double *deviator)
{
  const double *s = deviator;
  return 0.5 * (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]) +
      (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
}

// equivalent stress sqrt(3 J2), eq. 17

inline double von_mises(const double *deviator)
{
  return std::sqrt(3.0 * second_invariant(deviator));
}

// stored elastic energy per present volume, small strains: distortion J2/(2 mu), and change of
// volume P^2/(2K), which is sigma:eps/2 of Hooke's law

inline double elastic_energy_density(const Material &m, const double *deviator, double P)
{
  return second_invariant(deviator) / (2.0 * m.shear) + P * P / (2.0 * m.bulk_modulus());
}

}    // namespace SPHSolid

#endif
