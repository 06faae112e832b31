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

// that of "front": the velocity gradient R of a particle predicts the jump x_ij.R x_ij of a pair

template <int D> void EulerianSweeps<D>::find_switch(const Particles &p, const NeighborRows &)
{
  each_block([&](int block, const Batch &batch, Totals &) {
    const double *i = columns.at(block * LANES);
    const Pack h = Base::smoothing_lengths(p, batch);
    const Pack least = MU_EPSILON * h * h;    // particles may meet
    Pack rest2 = 0.0, linear2 = 0.0;
    Neighbors neighbors(*this, block, X, at_da);
    for (int s = pairs.first[block]; s < pairs.first[block] + pairs.count[block]; s++) {
      const double *j = neighbors(pairs.further[s]);
      const Components<D> d = motion(i, j);
      const Pack li = this->stretching(i, at_rate, d.x), lj = this->stretching(j, at_rate, d.x);
      const Pack rest = d.v_dot_x() - 0.5 * (li + lj);
      const Pack weight = -load(&pairs.factor[s * std::size_t(LANES)]) * component(j, VOLUME);
      const Pack w = weight / (d.x_dot_x() + least);
      rest2 += w * rest * rest;
      linear2 += 0.5 * w * (li * li + lj * lj);
    }
    columns.store(block * LANES, LAST, component(i, LAST) * unresolved_share(rest2, linear2));
  });
}

/* ----------------------------------------------------------------------
   correction sweep: replaces the viscous acceleration by its grid-scale part
------------------------------------------------------------------------- */

template <int D> void EulerianSweeps<D>::correction(const Particles &p, const NeighborRows &)
{
  this->mirror_vectors(at_da);
  each_block([&](int block, const Batch &batch, Totals &) {
    if (safe()) safe_pulls(block);
    const std::ptrdiff_t at = along() * std::ptrdiff_t(NEXT);
    const double *i = columns.at(block * LANES), *factors = near_factors(block);
    const int *near = pairs.near.data() + pairs.near_first[block];
    Pack own_along[D], f[D];
    for (int a = 0; a < D; a++) {
      own_along[a] = component(i + at, a);
      f[a] = 0.0;
    }
    Neighbors neighbors(*this, block, along(), along() + D);
    for (int n = 0; n < pairs.near_count[block]; n++) {
      const double *j = neighbors(pairs.further[near[n]]) + at;
      const Pack w = load(factors + n * LANES);
      for (int a = 0; a < D; a++) f[a] = multiply_add(w, own_along[a] - component(j, a), f[a]);
    }
    const Pack half_mass = 0.5 * batch.load(p.mass);
    for (int a = 0; a < D; a++) f[a] *= half_mass;
    this->add_forces(p, batch, f);
  });
}

// weights safe

template <int D> void EulerianSweeps<D>::safe_pulls(int block)
{
  const double *i = columns.at(block * LANES);
  const int *near = pairs.near.data() + pairs.near_first[block];
  const std::size_t first = pairs.near_first[block] * std::size_t(LANES);
  Neighbors neighbors(*this, block, X, V + D, at_da, at_da + D);
  for (int n = 0; n < pairs.near_count[block]; n++) {
    const double *j = neighbors(pairs.further[near[n]]);
    const Components<D> d = motion(i, j);
    Pack a[D];
    difference(i, j, at_da, a);
    const std::size_t k = first + n * LANES;
    store(&pairs.near_pull[k], load(&pairs.near_weight[k]) *
              safe_pull(dot<D>(a, d.x), d.v_dot_x(), d.x_dot_x()));
  }
}

// of the pairs that the correction must not touch since one of the two has no nearest neighbor,
// the whole viscous force: what is left of a pair's pull there, 0 elsewhere

template <int D>
Pack EulerianSweeps<D>::whole_pull(const double *i, const double *j, Pack pull) const
{
  if (!needs_correction()) return pull;
  const Pack zero(0.0);
  const Pack both = where_positive(component(i, LAST), component(j, LAST), zero);
  return where_positive(both, zero, pull);
}

}    // namespace

#endif
