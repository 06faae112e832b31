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
   The Eulerian frame: what neighbors read of a particle, sent to ghosts and
   mirrored to images.  Members of EulerianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EULERIAN_ROWS_H
#define LMP_SPH_SOLID_EULERIAN_ROWS_H

#include "sph_solid_eulerian.h"

namespace {

template <int D, class Precision>
void EulerianSweeps<D, Precision>::pack_kinematics(const Particles &p, const double *const *v)
{
  each_block([&](int block, const Batch &batch, Totals &) {
    this->pack_places(block, batch, p.x);
    this->pack_vectors(block, batch, V, v);
    columns.store(block * LANES, VOLUME,
                  unit_factor * batch.load(p.mass) / batch.load(p.rho_weight));
    columns.copy_to_rows(block * LANES, X, MASS);
  });
  this->pack_ghosts(p, v);
  for (int i = p.nlocal; i < p.nall; i++)
    if (column_of[i] >= 0)    // to the same bits as of own particles
      columns.set(column_of[i], VOLUME,
                  Number(unit_factor) * Number(p.mass[i]) / Number(p.rho_weight[i]));
  for (int k = 0; k < images.count(); k++) this->mirror_component(VOLUME, 1.0, k);
}

template <int D, class Precision>
void EulerianSweeps<D, Precision>::unpack(Message what, const Particles &p, int i, const double *in)
{
  Base::unpack(what, p, i, in);
  if (what == Message::STRESS && column_of[i] >= 0) p.rho[i] = in[RHO - T];
}

template <int D, class Precision> void EulerianSweeps<D, Precision>::mirror_stress()
{
  for (int k = 0; k < images.count(); k++) {
    double sign[3];
    images.signs(k, sign);
    this->mirror_tensor(T, sign, k);
    for (const int c : {K, RHO, SOUND, LAST}) this->mirror_component(c, 1.0, k);
    if (opt.tensile) this->mirror_tensor(at_tension, sign, k);
    if (at_rate < at_da) this->mirror_rate(at_rate, sign, k);
  }
  if (needs_correction()) this->find_lonely();
  if (keeps_pairs()) make_room(pairs.pull, pairs.factor.size());
}

template <int D, class Precision>
double EulerianSweeps<D, Precision>::time_step_limit(const Particles &p, const NeighborRows &) const
{
  return Base::least_of(blocks(), NO_LIMIT, [&](int first, int end) {
    double limit = NO_LIMIT;
    for (int block = first; block < end; block++) {
      const Batch batch = this->batch(block);
      const Number *i = columns.at(block * LANES);
      limit = std::min(limit,
                       least(Base::step_limit(Base::smoothing_lengths(p, batch),
                                              Base::shear_moduli(p, batch), component(i, RHO),
                                              component(i, SOUND), load(&mu_max[block * LANES]))));
    }
    return limit;
  });
}

}    // namespace

#endif
