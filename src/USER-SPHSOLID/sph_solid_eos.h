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

namespace SPHSolid {

struct PressureState {
  double P;     // pressure, compression positive [pressure]
  double c2;    // square of the bulk sound speed dP/drho at constant entropy [velocity^2]
};

// e in energy/mass, zero at (rho_ref, P = 0)

inline PressureState mie_gruneisen(const Material &m, double rho, double rho_ref, double e)
{
  const double eta = rho / rho_ref - 1.0;
  const double s = m.S - 1.0;
  const double a0 = m.rho0 * m.C * m.C;                                // eq. 11
  const double b0 = eta > 0.0 ? a0 * (1.0 + 2.0 * s) : 0.0;            // eq. 12
  const double c0 = eta > 0.0 ? a0 * (2.0 * s + 3.0 * s * s) : 0.0;    // eq. 13

  const double P_H = eta * (a0 + eta * (b0 + eta * c0));    // eq. 9
  const double dP_H = a0 + eta * (2.0 * b0 + eta * 3.0 * c0);
  const double thermal = 1.0 - 0.5 * m.Gamma * eta;

  PressureState out;
  out.P = thermal * P_H + m.Gamma * rho * e;    // eq. 8
  // c^2 = dP/drho|_e + (P/rho^2) dP/de|_rho
  out.c2 = (thermal * dP_H - 0.5 * m.Gamma * P_H) / rho_ref + m.Gamma * e + m.Gamma * out.P / rho;
  return out;
}

// P = K eta, without thermal pressure

inline PressureState linear_eos(const Material &m, double rho, double rho_ref)
{
  return {m.K * (rho / rho_ref - 1.0), m.K / rho_ref};
}

inline PressureState pressure(const Material &m, double rho, double rho_ref, double e)
{
  return m.eos == EOS::LINEAR ? linear_eos(m, rho, rho_ref) : mie_gruneisen(m, rho, rho_ref, e);
}

}    // namespace SPHSolid

#endif
