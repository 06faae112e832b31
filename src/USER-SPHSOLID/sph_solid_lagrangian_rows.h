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
   The Lagrangian frame: what neighbors read of a particle, sent to ghosts and
   mirrored to images.  Members of LagrangianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_ROWS_H
#define LMP_SPH_SOLID_LAGRANGIAN_ROWS_H

#include "sph_solid_lagrangian.h"

namespace {

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::pack_kinematics(const Particles &p, const double *const *v)
{
  each_block([&](int block, const Batch &batch, Totals &) {
    Base::pack_places(block, batch, p.x);
    Base::pack_vectors(block, batch, V, v);
    columns.copy_to_rows(block * LANES, X, REFERENCE);
  });
  Base::pack_ghosts(p, v);
  velocities_known = true;
}

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::displace(const double *const *u)
{
  save_power();
  Base::displace(u);
}

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::displace(const Particles &p, const Kick &kick)
{
  save_power();
  Base::displace(p, kick);
}

template <int D, class Precision> void LagrangianSweeps<D, Precision>::mirror_stress()
{
  for (int k = 0; k < images.count(); k++) {
    double sign[3];
    images.signs(k, sign);
    Base::mirror_tensor(T, sign, k);
    for (const int c : {IMPEDANCE, SOUND, DENSITY, LAST}) Base::mirror_component(c, 1.0, k);
    if (keeps_rates()) Base::mirror_rate(at_rate, sign, k);
  }

  // as long as weights are known, so is this
  if (needs_correction() && !weights_known) Base::find_lonely();
  // not sooner, when lists of partners take room as well
  if (this->wants_virial && keeps_central()) central_virial.resize(B.size());
  if (opt.energy && needs_correction() && keeps_pairs()) heated_force.resize(gradient_sum.size());
}

}    // namespace

#endif
