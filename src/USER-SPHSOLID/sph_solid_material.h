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
   What one material is: numbers only, in the units of the run.

   The names follow the cards in potentials/ (see the pair_style page).
   No LAMMPS include here; reading and checking is in
   sph_solid_material_card.cpp.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_MATERIAL_H
#define LMP_SPH_SOLID_MATERIAL_H

#include <cmath>

namespace SPHSolid {

enum class EOS { NONE, MIE_GRUNEISEN, LINEAR };
enum class Strength { NONE, ELASTIC, PERFECT, LINEAR };

struct Material {
  double rho0 = 0.0;    // reference density [mass/length^3]

  EOS eos = EOS::NONE;
  double C = 0.0;        // shock speed at zero particle speed [velocity]
  double S = 0.0;        // slope of U = C + S u [-]
  double Gamma = 0.0;    // Grueneisen parameter [-]
  double K = 0.0;        // bulk modulus of the linear form [pressure]

  double shear = 0.0;    // shear modulus mu [pressure]
  double young = 0.0;    // Young's modulus the source states, for a check only [pressure]

  Strength strength = Strength::NONE;
  double Y = 0.0;    // initial yield stress in uniaxial tension [pressure]
  double H = 0.0;    // hardening modulus dY/d(plastic strain) [pressure]

  double h = 0.0;    // smoothing length of this type [length]; 0: that of pair_style

  // elastic constants at the reference state

  double bulk_modulus() const { return eos == EOS::LINEAR ? K : rho0 * C * C; }
  double youngs_modulus() const
  {
    const double k = bulk_modulus();
    return 9.0 * k * shear / (3.0 * k + shear);
  }
  double poisson_ratio() const
  {
    const double k = bulk_modulus();
    return (3.0 * k - 2.0 * shear) / (2.0 * (3.0 * k + shear));
  }
  double bulk_sound_speed() const { return std::sqrt(bulk_modulus() / rho0); }
  double longitudinal_modulus() const { return bulk_modulus() + 4.0 * shear / 3.0; }
  double longitudinal_speed() const { return std::sqrt(longitudinal_modulus() / rho0); }
};

}    // namespace SPHSolid

#endif
