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
   Pressure and bulk sound speed from density and internal energy.

   Mie-Grueneisen after Shaw & Reid (2009), eqs 8-13, with the tension branch
   of eq. 9 read as P_H = a0 eta: as printed (c0 eta^3) the material has no
   bulk stiffness at all in tension.
   eta = rho/rho_ref - 1, where rho_ref is the density of this particle at
   rest, mass/volume: rho0 of the card unless the user gave it another mass
   (a tip mass smeared over a few particles keeps the stiffness of the card).
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EOS_H
#define LMP_SPH_SOLID_EOS_H

#include "sph_solid_material.h"
#include "sph_solid_vector.h"

namespace SPHSolid {

template <class Real = double> struct PressureState {
  Real P;     // pressure, compression positive [pressure]
  Real c2;    // square of the bulk sound speed dP/drho at constant entropy [velocity^2]
};

// coefficients of eqs 11-13; the linear form P = K eta, without thermal pressure,
// is the one with a0 = K and nothing else

template <class Real = double> struct EosConstants {
  Real a0, b0, c0;    // of the powers of eta [pressure]
  Real Gamma;
};

inline EosConstants<> eos_constants(const Material &m)
{
  if (m.eos == EOS::LINEAR) return {m.K, 0.0, 0.0, 0.0};
  const double s = m.S - 1.0, a0 = m.rho0 * m.C * m.C;
  return {a0, a0 * (1.0 + 2.0 * s), a0 * (2.0 * s + 3.0 * s * s), m.Gamma};
}

// density of now and of the reference, and the inverse of both with one division

template <class Real> struct Densities {
  Real rho, rho_ref, inv_rho, inv_rho_ref;
  Densities(Real now, Real ref) : rho(now), rho_ref(ref)
  {
    const Real inverse = 1.0 / (rho * rho_ref);
    inv_rho = inverse * rho_ref;
    inv_rho_ref = inverse * rho;
  }
};

// e in energy/mass, zero at (rho_ref, P = 0)

template <class Real>
inline PressureState<Real> pressure(const EosConstants<Real> &k, const Densities<Real> &of, Real e)
{
  const Real eta = (of.rho - of.rho_ref) * of.inv_rho_ref;
  const Real b0 = where_positive(eta, k.b0, Real(0.0));
  const Real c0 = where_positive(eta, k.c0, Real(0.0));

  const Real P_H = eta * (k.a0 + eta * (b0 + eta * c0));    // eq. 9
  const Real dP_H = k.a0 + eta * (2.0 * b0 + eta * 3.0 * c0);
  const Real thermal = 1.0 - 0.5 * k.Gamma * eta;

  PressureState<Real> out;
  out.P = thermal * P_H + k.Gamma * of.rho * e;    // eq. 8
  // c^2 = dP/drho|_e + (P/rho^2) dP/de|_rho, of eqs 8 and 9, since de = P/rho^2 drho at constant entropy
  out.c2 =
      (thermal * dP_H - 0.5 * k.Gamma * P_H) * of.inv_rho_ref + k.Gamma * (e + out.P * of.inv_rho);
  return out;
}

inline PressureState<> pressure(const Material &m, double rho, double rho_ref, double e)
{
  return pressure(eos_constants(m), Densities<double>(rho, rho_ref), e);
}

}    // namespace SPHSolid

#endif
