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
   Switches of a particle, numbers in [0,1] that the artificial viscosity of its
   pairs depends on.  L is the velocity gradient [1/time]; the functions take
   numbers or vectors of them (sph_solid_vector.h) as Real.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_SWITCH_H
#define LMP_SPH_SOLID_SWITCH_H

#include "sph_solid_tensor.h"

namespace SPHSolid {

// Balsara's |div v|/(|div v| + |curl v| + 1e-4 c/h): near 0 in shear, near 1 in
// compression: Balsara, J. Comput. Phys. 121 (1995) 357

template <int D, class Real> inline Real balsara_switch(const Tensor<D, Real> &L, Real c, Real h)
{
  const Real div = L.trace(), rate = maximum(div, -div);
  const Real z = L(1, 0) - L(0, 1);
  Real curl2 = z * z;
  if (D == 3) {
    const Real x = L(D - 1, 1) - L(1, D - 1), y = L(0, D - 1) - L(D - 1, 0);
    curl2 += x * x + y * y;
  }
  // at rest it is 0 where the pressure has c^2 < 0
  const Real all = rate + square_root(curl2) + 1.0e-4 * c / h;
  return where_positive(all, rate / all, Real(0.0));
}

// how much of a deformation is compression: (div v)^2/(D:D), at most 1, D = (L + L^T)/2;
// 1 in a plane shock, 0 in plastic flow and in expansion

template <int D, class Real> inline Real compression_share(const Tensor<D, Real> &L)
{
  const Real div = L.trace();
  Real d2 = Real(0.0);
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) {
      const Real d = 0.5 * (L(a, b) + L(b, a));
      d2 += d * d;
    }
  // squares of what is nearly at rest may be 0
  return where_positive(minimum(-div, d2), minimum(Real(1.0), div * div / d2), Real(0.0));
}

// how much of the motion around a particle is not resolved: of the mean squares of the
// velocity jumps that velocity gradients do not predict (rest2) and do (linear2), with
// e = UNRESOLVED the value rest2/(rest2 + e^2 linear2).  On a lattice sqrt(rest2/linear2)
// is e for waves of 14 spacings with h = 1 spacing and of 18 to 19 with h = 1.3, and falls with the
// square of the wave number: whole viscosity for what is shorter, none for what is longer

static constexpr double UNRESOLVED = 0.05;

template <class Real> inline Real unresolved_share(Real rest2, Real linear2)
{
  const Real share = rest2 / (rest2 + UNRESOLVED * UNRESOLVED * linear2);
  return where_positive(rest2, share, Real(0.0));
}

}    // namespace SPHSolid

#endif
