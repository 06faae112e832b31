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
   Cubic B-spline kernel W(r,h), support 2h (Shaw & Reid 2009, eq. 22).

   W in 1/length^D, dW/dr in 1/length^(D+1).  The sweeps want the gradient
   as  grad_i W(x_i - x_j) = F x_ij  with  F = (dW/dr)/r, which is finite at
   r = 0, so that a particle and its mirror image may coincide.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_KERNEL_H
#define LMP_SPH_SOLID_KERNEL_H

#include "sph_solid_vector.h"

namespace SPHSolid {

static constexpr double PI_SPH = 3.14159265358979323846;

// reach of the kernel in units of h, a little inside its edge: of neighbors that lie on
// it, as on a square lattice with h = 1 spacing, rounding would take some and not others,
// and all that they add is zero to rounding
static constexpr double SUPPORT = 2.0 * (1.0 - 1.0e-8);

// and of partners in the reference, which has a gradient B that makes up for what is left out.
// Where q = 1.98 the kernel's gradient is 4e-4 of that where q = 1, and a slot costs
// as much as any other: a lattice that is not quite square has whole rows of such pairs.  A
// little less than a round number, for the reason above: seen from i and from j a pair is one

static constexpr double PARTNER_SUPPORT = 1.98 * (1.0 - 1.0e-8);

template <int D> struct CubicSpline {
  static_assert(D == 2 || D == 3, "plane strain or three dimensions");

  // alpha_D h^D: 10/(7 pi) in 2d, 1/pi in 3d
  static constexpr double NORM = (D == 2) ? 10.0 / (7.0 * PI_SPH) : 1.0 / PI_SPH;

  // Real: a number, or a vector of them

  // hinv^D
  template <class Real> static inline Real power(Real hinv)
  {
    return (D == 2) ? hinv * hinv : hinv * hinv * hinv;
  }

  template <class Real> static inline Real w(Real r, Real h) { return w_of_inverse(r, 1.0 / h); }
  template <class Real> static inline Real w_of_inverse(Real r, Real hinv)
  {
    const Real q = r * hinv;
    const Real s = maximum(2.0 - q, Real(0.0));
    const Real t = maximum(1.0 - q, Real(0.0));
    // (2-q)^3/4 - (1-q)^3 is eq. 22 with both branches in one line
    return NORM * power(hinv) * (0.25 * s * s * s - t * t * t);
  }

  // F = (dW/dr)/r, negative inside the support

  template <class Real> static inline Real gradient_factor(Real r, Real h)
  {
    // one division for 1/h and, outside q = 1, for 1/q
    const Real far = maximum(r, h), inverse = 1.0 / (h * far);
    const Real hinv = inverse * far;
    return gradient_scale(hinv) * gradient_shape(r * hinv, h * h * inverse);
  }

  // the same in two parts: what depends on h, and on q = r/h and 1/q (where q < 1 any number)

  template <class Real> static inline Real gradient_scale(Real hinv)
  {
    return NORM * power(hinv) * hinv * hinv;
  }
  template <class Real> static inline Real gradient_shape(Real q, Real inverse_q)
  {
    const Real s = 2.0 - q;
    const Real inner = -3.0 + 2.25 * q, outer = -0.75 * s * s * inverse_q;
    return where_positive(s, where_positive(1.0 - q, inner, outer), Real(0.0));
  }
};

}    // namespace SPHSolid

#endif
