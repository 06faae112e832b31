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
   Artificial viscosity of a pair and the acceleration correction.

   Monaghan's form: Shaw & Reid (2009), eqs 23-24.
   Correction: eqs 27-30 in the reading that conserves momentum and energy.
   With da_i the viscous acceleration of eq. 23 and the weights below, what
   is left of it is

     da_i - dabar_i = 1/2 sum_j w_ij (da_i - da_j),   sum over nearest j != i,

   a high-pass filter: smooth fields keep their kinetic energy, grid-scale
   noise is damped.  "conservative" weights are symmetric times mass, so that
   linear momentum is exact; "shepard" weights are the closest reading of the
   printed eq. 28 and are not.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_VISCOSITY_H
#define LMP_SPH_SOLID_VISCOSITY_H

#include "sph_solid_vector.h"

namespace SPHSolid {

enum class Viscosity { NONE, MONAGHAN, CORRECT, LIMITED, BALSARA, FRONT };
enum class Weights { CONSERVATIVE, SHEPARD, SAFE };
enum class Heating { COMPATIBLE, PRINTED };

// keeps mu finite when two particles meet, eq. 24
static constexpr double MU_EPSILON = 0.01;

// The following take numbers or vectors of them (sph_solid_vector.h) as Real.

// mu_ij/h_ij of eq. 24, zero for a separating pair, and Pi_ij of eq. 23 [pressure/density^2];
// vr = v_ij . r_ij, softened = r_ij^2 + 0.01 h_ij^2, linear = -a1 h_ij (c_i + c_j),
// quadratic = 2 a2 h_ij^2, rho_sum = rho_i + rho_j: of each mean twice what it is.  What is h times
// something is, where all h are alike, a constant.  One division for both, and little to do behind it, for
// which the processor would have to wait

template <class Real> struct PairViscosity {
  Real approach, Pi;
  PairViscosity(Real linear, Real quadratic, Real rho_sum, Real vr, Real softened)
  {
    const Real inverse = 1.0 / (softened * rho_sum);
    approach = (minimum(vr, Real{}) * rho_sum) * inverse;
    Pi = (approach * (softened * inverse)) * multiply_add(approach, quadratic, linear);
  }
};

// share of the linear part of a velocity jump that is taken off before it is
// called a shock: van Leer's limiter of the jumps l_i, l_j that the velocity
// gradients of the two particles predict, 4r/(1+r)^2 with r = l_i/l_j, zero for
// opposite signs (Frontiere, Raskin & Owen 2017, eq. 48)

template <class Real> inline Real van_leer(Real l_i, Real l_j)
{
  const Real product = l_i * l_j, sum = l_i + l_j;
  return where_positive(product, 4.0 * product / (sum * sum), Real{});
}

// what is left of the jump vr = v_ij . x_ij.  Sign clip: never beyond zero and
// never larger than vr, so that every pair dissipates

template <class Real> inline Real clipped_jump(Real vr, Real rest)
{
  const Real clipped = where_positive(vr * vr - rest * rest, rest, vr);
  return where_positive(rest * vr, clipped, Real{});
}

template <class Real> inline Real limited_jump(Real vr, Real l_i, Real l_j)
{
  return clipped_jump(vr, vr - 0.5 * van_leer(l_i, l_j) * (l_i + l_j));
}

// whole in a shock front, where the mean switch of the pair is 1; where it is 0 all of
// the linear part is taken off.  Without the limiter, which is 0 wherever the velocity
// gradient changes its sign, the crests of resolved waves lose nothing either

template <class Real> inline Real front_jump(Real vr, Real l_i, Real l_j, Real front)
{
  return clipped_jump(vr, vr - 0.5 * (1.0 - front) * (l_i + l_j));
}

// what a pair's viscosity acts on: the whole jump, the limited one, the whole one
// times the mean switch of the two particles, or the one of front_jump()

enum class PairForm { NONE, WHOLE, LIMITED, SWITCHED, FRONT };

constexpr PairForm pair_form(Viscosity v)
{
  switch (v) {
    case Viscosity::NONE:
      return PairForm::NONE;
    case Viscosity::LIMITED:
      return PairForm::LIMITED;
    case Viscosity::BALSARA:
      return PairForm::SWITCHED;
    case Viscosity::FRONT:
      return PairForm::FRONT;
    default:
      return PairForm::WHOLE;
  }
}

// does it need the velocity gradients of both particles, a switch of each?

constexpr bool needs_rates(PairForm f)
{
  return f == PairForm::LIMITED || f == PairForm::FRONT;
}
constexpr bool needs_switch(PairForm f)
{
  return f == PairForm::SWITCHED || f == PairForm::FRONT;
}

template <PairForm FORM, class Real> inline Real jump_left(Real vr, Real l_i, Real l_j, Real front)
{
  if (FORM == PairForm::LIMITED) return limited_jump(vr, l_i, l_j);
  if (FORM == PairForm::FRONT) return front_jump(vr, l_i, l_j, front);
  return vr;
}

// n_i = sum_j m_j Wbar_ij over the nearest neighbours, self left out: with it
// the row sum would pass one and the viscosity would change its sign

template <class Real>
inline Real correction_weight(Weights weights, Real m_wbar, Real n_i, Real n_j)
{
  if (weights == Weights::SHEPARD) return m_wbar / n_i;
  return m_wbar / maximum(n_i, n_j);
}

// the same of 1/n, which takes no division of each pair

template <class Real>
inline Real correction_weight_of_inverse(Weights weights, Real m_wbar, Real inv_n_i, Real inv_n_j)
{
  return m_wbar * (weights == Weights::SHEPARD ? inv_n_i : minimum(inv_n_i, inv_n_j));
}

// weights safe: of the pair force that the correction leaves, only the part along the
// line of centers, and nothing where it would not slow the pair down.  ax and vx:
// (da_i - da_j).x_ij and v_ij.x_ij.  Times x_ij; symmetric in i and j

template <class Real> inline Real safe_pull(Real ax, Real vx, Real x2)
{
  return where_positive(-(ax * vx), ax / x2, Real(0.0));
}

// share of the standard viscosity that the time step allows for: half of it, what the filter leaves in two
// dimensions of a wave of two spacings along one axis, when all neighbors along the other one move alike.  (Of a
// checkerboard it leaves nearly all.)  That this is enough follows from runs: doc/fix_sph_solid_dt.rst

static constexpr double CORRECTION_RETAINS = 0.5;

}    // namespace SPHSolid

#endif
