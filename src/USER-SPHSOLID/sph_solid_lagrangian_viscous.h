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
   The Lagrangian frame: switch of a viscosity, acceleration correction.  Members of
   LagrangianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_VISCOUS_H
#define LMP_SPH_SOLID_LAGRANGIAN_VISCOUS_H

#include "sph_solid_lagrangian.h"

namespace {

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::find_switch(const Particles &p, const NeighborRows &)
{
  each_block([&](int block, const Batch &batch, Totals &) {
    const Number *i = columns.at(block * LANES);
    typename Base::Jumps jumps(*this, i, Base::smoothing_lengths(p, batch));
    Neighbors neighbors(*this, block, at_da);
    for (int s = slots.first[block]; s < slots.first[block + 1]; s++) {
      const Number *j = neighbors(s);
      jumps.add(j, at_rate, -factor(s, j));
    }
    columns.store(block * LANES, LAST, component(i, LAST) * jumps.unresolved());
    columns.copy_to_rows(block * LANES, LAST, FIXED);
  });
}

/* ----------------------------------------------------------------------
   correction sweep: replaces the viscous acceleration by its grid-scale part
------------------------------------------------------------------------- */

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::correction(const Particles &p, const NeighborRows &)
{
  mirror_vectors(at_da);
  if (!weights_known) find_weights();
  const Totals totals = each_block([&](int block, const Batch &batch, Totals &t) {
    if (safe()) safe_pulls(block);
    if (opt.energy && Base::heats_evenly())
      correct_block<true>(p, block, batch, t);
    else
      correct_block<false>(p, block, batch, t);
  });
  Totals::add(early_totals, totals);
}

// forces and, where their heat is the same from both sides, what is known of it

template <int D, class Precision>
template <bool HEATS>
void LagrangianSweeps<D, Precision>::correct_block(const Particles &p, int block,
                                                   const Batch &batch, Totals &totals)
{
  if (asks_for_block(block)) {
    ask_for_accounts(block);
    Base::ask_for(p.mass, batch);
  }
  const Number *i = columns.at(block * LANES);
  const int first = slots.first[block], end = first + slots.nearest(block);
  const auto near = near_factors(block);
  const Pack mass = batch.load(p.mass);
  // what is the particle's own out of the loop, a tenth of its instructions
  const typename Base::template Along<!HEATS> of_pair(*this, i, at_da);
  Pack v[D], sum[D], power = 0.0;
  for (int a = 0; a < D; a++) {
    v[a] = component(i, V + a);
    sum[a] = 0.0;
  }
  Neighbors neighbors(*this, block, T, at_da);
  for (int s = first; s < end; s++) {
    const Number *j = neighbors(s);
    neighbors.template prefetch_vectors_ahead<6>(s, j, V, at_da);
    const Pack w = load(near.of(s - first));
    Pack along[D], heat = 0.0;
    of_pair.from(j, along);
    for (int a = 0; a < D; a++) sum[a] = multiply_add(w, along[a], sum[a]);
    if (!HEATS) continue;
    for (int a = 0; a < D; a++) heat = multiply_add(v[a] - component(j, V + a), along[a], heat);
    power = multiply_add(w, heat, power);
  }
  Number *const waiting = accounts.at(block, Accounts::VISCOUS);
  Pack f[D], all[D];
  for (int a = 0; a < D; a++) {
    f[a] = 0.5 * mass * sum[a];
    all[a] = f[a] + load(waiting + a * LANES);
  }
  Base::add_forces(p, batch, all);
  if (!HEATS) return;
  store_vector(waiting, f);
  const Pack heat = -0.25 * mass * power;
  Number *const pairs = accounts.at(block, accounts.pairs);
  store(pairs, load(pairs) + 2.0 * heat + dot<D>(f, v));
  if (!this->keeps_heat) return;
  totals.viscous += Base::sum_of_first(heat, batch.n);
  totals.standard += Base::sum_of_first(standard_power(i, mass), batch.n);
}

// m_j Wbar of the nearest partners becomes a weight: constant until the partners have new indices

template <int D, class Precision> void LagrangianSweeps<D, Precision>::find_weights()
{
  NearWeights weights;
  weights.begin(slots.near_first.back());
  each_block([&](int block, const Batch &, Totals &) {
    const Number *i = columns.at(block * LANES);
    const int first = slots.first[block];
    const auto near = near_weight.from(slots.near_first[block]);
    Numbers of_block(slots.nearest(block) * LANES);
    Neighbors neighbors(*this, block, FIXED);
    for (int k = 0; k < slots.nearest(block); k++) {
      const Number *j = neighbors(first + k);
      const Pack m_wbar = load(near.of(k));
      const Pack w = correction_weight(opt.weights, m_wbar, component(i, LAST), component(j, LAST));
      store(&of_block[k * LANES], where_positive(m_wbar, w, Pack(0.0)));
    }
    const std::lock_guard<std::mutex> alone(mutex);
    weights.enter(slots.near_first[block], of_block);
  });
  weights.end();
  near_weight = std::move(weights);
  weights_known = true;
}

// weights safe

template <int D, class Precision> void LagrangianSweeps<D, Precision>::safe_pulls(int block)
{
  const Number *i = columns.at(block * LANES);
  const auto near = near_weight.from(slots.near_first[block]);
  Number *pulls = near_pull.data() + slots.near_first[block] * std::size_t(LANES);
  Neighbors neighbors(*this, block, T, at_da);
  for (int n = 0; n < slots.nearest(block); n++, pulls += LANES) {
    const Number *j = neighbors(slots.first[block] + n);
    store(pulls, load(near.of(n)) * Base::safe_pull_of(i, j, at_da));
  }
}

}    // namespace

#endif
