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
   Deviatoric stress of one material point over one time step.

   S is the deviator of the Cauchy stress, tension positive; in 2d (plane
   strain) its zz component is a state variable of its own.

   Source: Shaw & Reid (2009), eqs 14-17, corrected: the rate is
   S' = 2 mu dev(D) + W S - S W (printed without the 2), the effective
   stress is sqrt(3 J2) with J2 = S:S/2 (printed sqrt(3 S:S)).
   The step is Hughes & Winget (1980): velocity gradient at the middle of the
   step, rotation by the Cayley transform of the spin.  A rigid rotation of
   any size leaves |S| and the principal directions exact.  Half of
   the increment 2 mu dev(D) dt turns along: without that the update is of first
   order only.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_STRENGTH_H
#define LMP_SPH_SOLID_STRENGTH_H

#include "sph_solid_material.h"
#include "sph_solid_tensor.h"

#include <cmath>

namespace SPHSolid {

// what one material point remembers

template <int D, class Real = double> struct PointState {
  Real rho = 0.0;    // density [mass/length^3]
  Real epl = 0.0;    // effective plastic strain [-]
  // in-space part of the deviatoric stress [pressure]
  Tensor<D, Real> S = Tensor<D, Real>::Zero();
  Real Szz = 0.0;    // out-of-plane part, 2d only [pressure]
};

// the constants of a material that are used here

template <class Real = double> struct StrengthConstants {
  Real shear;    // shear modulus mu [pressure]
  Real Y, H;     // yield stress Y + H epl [pressure]; elastic: Y larger than any stress
};

inline StrengthConstants<> strength_constants(const Material &m)
{
  if (m.strength == Strength::ELASTIC) return {m.shear, 1.0e300, 0.0};
  return {m.shear, m.Y, m.strength == Strength::LINEAR ? m.H : 0.0};
}

// dv/dx at the middle of the step from dv/dx with respect to the end-of-step
// positions: F'(F - dt/2 F')^-1 with L_end = F' F^-1.  dt [time], L [1/time]

template <int D, class Real = double>
inline Tensor<D, Real> midpoint_velocity_gradient(const Tensor<D, Real> &L_end, Real dt)
{
  const Tensor<D, Real> A = Tensor<D, Real>::Identity() - Real(0.5) * dt * L_end;
  return L_end * A.inverse();
}

// Q = (1 - A)^-1 (1 + A), A = W dt/2, W = skew(L): Hughes & Winget (1980), eq. 12.  Since
// A^3 = -a^2 A with a^2 = A:A/2, this is 1 + 2 (A + A^2)/(1 + a^2)

template <int D, class Real = double>
inline Tensor<D, Real> spin_rotation(const Tensor<D, Real> &L, Real dt)
{
  const Tensor<D, Real> A = Real(0.25) * dt * (L - L.transpose());
  const Real a2 = 0.5 * A.cwiseProduct(A).sum(), share = 2.0 / (1.0 + a2);
  return Tensor<D, Real>::Identity() + share * Tensor<D, Real>(A + A * A);
}

// J2 = S:S/2, with the out-of-plane part in plane strain

template <int D, class Real = double>
inline Real second_invariant(const Tensor<D, Real> &S, Real Szz)
{
  const Real in_space = S.cwiseProduct(S).sum();
  return 0.5 * (D == 2 ? in_space + Szz * Szz : in_space);
}

// square of sigma_e = sqrt(3 J2), eq. 17

template <int D, class Real = double>
inline Real von_mises_squared(const Tensor<D, Real> &S, Real Szz)
{
  return 3.0 * second_invariant<D, Real>(S, Szz);
}

// radial return to the von Mises surface; returns plastic work per volume.  Where no lane yields, which
// squares tell, there is no root to wait for and no division

template <int D, class Real>
inline Real radial_return(const StrengthConstants<Real> &m, PointState<D, Real> &p)
{
  const Real yield = m.Y + m.H * p.epl, yield2 = yield * yield;
  const Real sigma_e2 = von_mises_squared<D, Real>(p.S, p.Szz);
  if (!larger_lanes(sigma_e2, yield2)) return Real(0.0);
  const Real sigma_e = square_root(sigma_e2);
  const Real over = where_positive(sigma_e2 - yield2, sigma_e - yield, Real(0.0));

  // consistency: sigma_e - 3 mu depl = Y(epl + depl)
  const Real depl = where_positive(over, over / (3.0 * m.shear + m.H), Real(0.0));
  p.epl += depl;
  const Real Y_new = m.Y + m.H * p.epl;
  const Real f = where_positive(over, Y_new / sigma_e, Real(1.0));
  p.S *= f;
  p.Szz *= f;
  return where_positive(over, Y_new * depl, Real(0.0));
}

// advance density, stress and plastic strain by dt with the velocity gradient
// L at the middle of the step; returns plastic work per volume [pressure]

template <int D, class Real>
inline Real advance(const StrengthConstants<Real> &m, PointState<D, Real> &p,
                    const Tensor<D, Real> &L, Real dt)
{
  const Real volumetric = L.trace();
  const Tensor<D, Real> strain = Real(0.5) * (L + L.transpose());
  const Tensor<D, Real> Q = spin_rotation<D, Real>(L, dt);

  // continuity, eq. 3, by the midpoint rule: exact volume ratio in uniaxial strain
  p.rho *= (1.0 - 0.5 * dt * volumetric) / (1.0 + 0.5 * dt * volumetric);

  Tensor<D, Real> half = m.shear * dt * strain;    // of the increment
  const Real mean = (1.0 / 3.0) * m.shear * dt * volumetric;
  half.diagonal().array() -= mean;
  p.S = Q * Tensor<D, Real>(p.S + half) * Q.transpose() + half;
  p.Szz -= 2.0 * mean;
  return radial_return<D, Real>(m, p);
}

// the same for one particle

template <int D> inline Tensor<D> midpoint_velocity_gradient(const Tensor<D> &L_end, double dt)
{
  return midpoint_velocity_gradient<D, double>(L_end, dt);
}

template <int D> inline double von_mises_squared(const Tensor<D> &S, double Szz)
{
  return von_mises_squared<D, double>(S, Szz);
}

template <int D> inline double radial_return(const Material &m, PointState<D> &p)
{
  return radial_return<D, double>(strength_constants(m), p);
}

template <int D>
inline double advance(const Material &m, PointState<D> &p, const Tensor<D> &L, double dt)
{
  return advance<D, double>(strength_constants(m), p, L, dt);
}

}    // namespace SPHSolid

#endif
