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

template <int D> struct PointState {
  double rho = 0.0;                   // density [mass/length^3]
  double epl = 0.0;                   // effective plastic strain [-]
  Tensor<D> S = Tensor<D>::Zero();    // in-space part of the deviatoric stress [pressure]
  double Szz = 0.0;                   // out-of-plane part, 2d only [pressure]
};

// dv/dx at the middle of the step from dv/dx with respect to the end-of-step
// positions: F'(F - dt/2 F')^-1 with L_end = F' F^-1.  dt [time], L [1/time]

template <int D> inline Tensor<D> midpoint_velocity_gradient(const Tensor<D> &L_end, double dt)
{
  const Tensor<D> A = Tensor<D>::Identity() - 0.5 * dt * L_end;
  return L_end * A.inverse();
}

// Q = (1 - W dt/2)^-1 (1 + W dt/2), W = skew(L): Hughes & Winget (1980), eq. 12

template <int D> inline Tensor<D> spin_rotation(const Tensor<D> &L, double dt)
{
  const Tensor<D> half = 0.25 * dt * (L - L.transpose());
  const Tensor<D> one = Tensor<D>::Identity();
  return (one - half).inverse() * (one + half);
}

// J2 = S:S/2, with the out-of-plane part in plane strain

template <int D> inline double second_invariant(const Tensor<D> &S, double Szz)
{
  const double in_space = S.squaredNorm();
  return 0.5 * (D == 2 ? in_space + Szz * Szz : in_space);
}

// sigma_e = sqrt(3 J2), eq. 17

template <int D> inline double von_mises(const Tensor<D> &S, double Szz)
{
  return std::sqrt(3.0 * second_invariant<D>(S, Szz));
}

inline double yield_stress(const Material &m, double epl)
{
  return m.strength == Strength::LINEAR ? m.Y + m.H * epl : m.Y;
}

// radial return to the von Mises surface; returns plastic work per volume

template <int D> inline double radial_return(const Material &m, PointState<D> &p)
{
  if (m.strength == Strength::ELASTIC) return 0.0;
  const double sigma_e = von_mises<D>(p.S, p.Szz);
  const double Y_old = yield_stress(m, p.epl);
  if (sigma_e <= Y_old) return 0.0;

  // consistency: sigma_e - 3 mu depl = Y(epl + depl)
  const double hardening = m.strength == Strength::LINEAR ? m.H : 0.0;
  const double depl = (sigma_e - Y_old) / (3.0 * m.shear + hardening);
  p.epl += depl;
  const double Y_new = yield_stress(m, p.epl);
  const double f = Y_new / sigma_e;
  p.S *= f;
  p.Szz *= f;
  return Y_new * depl;
}

// advance density, stress and plastic strain by dt with the velocity gradient
// L at the middle of the step; returns plastic work per volume [pressure]

template <int D>
inline double advance(const Material &m, PointState<D> &p, const Tensor<D> &L, double dt)
{
  const double volumetric = L.trace();
  const Tensor<D> strain = 0.5 * (L + L.transpose());
  const Tensor<D> Q = spin_rotation<D>(L, dt);

  // continuity, eq. 3, by the midpoint rule: exact volume ratio in uniaxial strain
  p.rho *= (1.0 - 0.5 * dt * volumetric) / (1.0 + 0.5 * dt * volumetric);

  Tensor<D> half = m.shear * dt * strain;    // of the increment
  half.diagonal().array() -= m.shear * dt * volumetric / 3.0;
  p.S = Q * (p.S + half) * Q.transpose() + half;
  p.Szz -= 2.0 * m.shear * dt * volumetric / 3.0;
  return radial_return<D>(m, p);
}

}    // namespace SPHSolid

#endif
