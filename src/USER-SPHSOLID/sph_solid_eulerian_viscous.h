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
   The Eulerian frame: switch of a viscosity, acceleration correction.
   Members of EulerianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EULERIAN_VISCOUS_H
#define LMP_SPH_SOLID_EULERIAN_VISCOUS_H

#include "sph_solid_eulerian.h"

namespace {

template <int D, class Precision>
void EulerianSweeps<D, Precision>::find_switch(const Particles &p, const NeighborRows &)
{
  each_block([&](int block, const Batch &batch, Totals &) {
    const Number *i = columns.at(block * LANES);
    typename Base::Jumps jumps(*this, i, Base::smoothing_lengths(p, batch));
    Neighbors neighbors(*this, block, X, at_da);
    for (int s = pairs.first[block]; s < pairs.first[block] + pairs.count[block]; s++) {
      const Number *j = neighbors(pairs.further[s]);
      const Pack V_F =
          Precision::load(&pairs.factor[s * std::size_t(LANES)]) * component(j, VOLUME);
      jumps.add(j, at_rate, -V_F);
    }
    columns.store(block * LANES, LAST, component(i, LAST) * jumps.unresolved());
    columns.copy_to_rows(block * LANES, LAST, FIXED);
  });
}

/* ----------------------------------------------------------------------
   correction sweep: replaces the viscous acceleration by its grid-scale part
------------------------------------------------------------------------- */

template <int D, class Precision>
void EulerianSweeps<D, Precision>::correction(const Particles &p, const NeighborRows &)
{
  this->mirror_vectors(at_da);
  with_flag(opt.weights == Weights::CONSERVATIVE, [&](auto conservative) {
    each_block([&](int block, const Batch &batch, Totals &) {
      if (safe()) safe_pulls(block);
      correct_block<decltype(conservative)::value>(p, block, batch);
    });
  });
}

template <int D, class Precision>
template <bool CONSERVATIVE>
void EulerianSweeps<D, Precision>::correct_block(const Particles &p, int block, const Batch &batch)
{
  const Number *i = columns.at(block * LANES);
  const Nearest near = nearest(block);
  Neighbors neighbors(*this, block, safe() ? X : MASS, MASS + 1, LAST, at_da + D);
  const int *further = pairs.further.data();
  neighbors.ask_ahead(further, near);
  const NearFactors<CONSERVATIVE> factor(*this, near, i);
  const typename Base::template Along<!CONSERVATIVE> of_pair(*this, i, at_da);
  Pack f[D];
  for (int a = 0; a < D; a++) f[a] = 0.0;
  for (int n = 0; n < near.count; n++) {
    const Number *j = neighbors(further[near.slot[n]]);
    const Pack w = factor(n, j);
    Pack along[D];
    of_pair.from(j, along);
    for (int a = 0; a < D; a++) f[a] = multiply_add(w, along[a], f[a]);
  }
  const Pack half_mass = 0.5 * batch.load(p.mass);
  for (int a = 0; a < D; a++) f[a] *= half_mass;
  this->add_forces(p, batch, f);
}

// weights safe

template <int D, class Precision> void EulerianSweeps<D, Precision>::safe_pulls(int block)
{
  const Number *i = columns.at(block * LANES);
  const Nearest near = nearest(block);
  const NearFactors<false> factor(*this, near, i);
  Neighbors neighbors(*this, block, X, MASS + 1, LAST, at_da + D);
  for (int n = 0; n < near.count; n++) {
    const Number *j = neighbors(pairs.further[near.slot[n]]);
    store(&pairs.near_pull[near.pair + n * LANES],
          factor.weight(n, j) * Base::safe_pull_of(i, j, at_da));
  }
}

}    // namespace

#endif
