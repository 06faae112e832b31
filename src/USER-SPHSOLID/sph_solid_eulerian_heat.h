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
   The Eulerian frame: heat and virial.  Members of EulerianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EULERIAN_HEAT_H
#define LMP_SPH_SOLID_EULERIAN_HEAT_H

#include "sph_solid_eulerian.h"

namespace {

/* ----------------------------------------------------------------------
   heat: compatible with the pair forces, so that kinetic plus internal
   energy is constant to rounding for any displacement that the kick makes
------------------------------------------------------------------------- */

template <int D, class Precision>
void EulerianSweeps<D, Precision>::heat(const Particles &p, const NeighborRows &, double,
                                        double *heat)
{
  this->mirror_vectors(V);
  Totals totals;
  with_flag(keeps_pairs(), [&](auto pull) {
    with_flag(opt.tensile, [&](auto tensile) {
      totals = each_block([&](int block, const Batch &batch, Totals &t) {
        const Pack mass = batch.load(p.mass);
        if (!heat) this->ask_for(p.e, batch);
        Pack stress = 0.0, viscous = 0.0;
        add_power<decltype(pull)::value, decltype(tensile)::value>(block, stress, viscous);
        viscous *= 0.5 * unit_factor * mass;
        // what the standard viscosity would heat: here is all of it for eq. 30, else the pairs
        // that no correction touches
        const Pack standard = Base::standard_power(columns.at(block * LANES), mass);
        t.standard += Base::sum_of_first(viscous + standard, batch.n);
        if (needs_correction())
          with_flag(Base::heats_evenly(), [&](auto evenly) {
            viscous -= 0.25 * mass * corrected_power<decltype(evenly)::value>(block);
          });
        t.viscous += Base::sum_of_first(viscous, batch.n);
        this->give_heat(p, batch, mass, heat, stress + viscous);
      });
    });
  });
  if (!heat) Base::enter(totals, 1.0);
}

// what the forces of pairs give to i while particles move by u.  Stress: K_i T_i : sum_j
// K_j (u_j - u_i) (x) g, the sigma_i half of eq. 20, exact adjoint of the force, and the same of the
// artificial stress; of the viscosity half of each pair's, without its factors

template <int D, class Precision>
template <bool PULL, bool TENSILE>
void EulerianSweeps<D, Precision>::add_power(int block, Pack &stress, Pack &viscous) const
{
  const Number *i = columns.at(block * LANES);
  const int first = pairs.first[block], count = pairs.count[block];
  const int *further = pairs.further.data() + first;
  const std::size_t first_pair = first * std::size_t(LANES);
  const float *factors = pairs.factor.data() + first_pair;
  const Number *pulls = pairs.pull.data() + first_pair, *crowds = pairs.crowd.data() + first_pair;
  Neighbors neighbors(*this, block, X, V + D, K, PULL ? FIXED : K + 1);
  neighbors.ask_ahead(further, count);
  ask_for_slots(block);
  const std::ptrdiff_t next = kernel_gradients_ahead(block);
  const Motion own(*this, i);
  TensorSums<D, Pack> moved, crowded;
  Pack pulled = 0.0;
  for (int s = 0; s < count; s++) {
    const Number *j = neighbors(further[s]);
    prefetch(factors + s * LANES + next, LANES);
    const Parts d = own.from(j);
    const Pack KF = Precision::load(factors + s * LANES) * component(j, K);
    Pack g[D];
    for (int a = 0; a < D; a++) g[a] = KF * d.x[a];
    moved.add(d.v, g);
    if (TENSILE) {
      const Pack crowd = load(crowds + s * LANES);
      for (int a = 0; a < D; a++) g[a] *= crowd;
      crowded.add(d.v, g);
    }
    if (PULL)
      pulled =
          multiply_add(Base::heated_pull(i, j, LAST, load(pulls + s * LANES)), d.v_dot_x(), pulled);
  }
  Pack sum = moved.tensor().cwiseProduct(tensor(i, T)).sum();
  if (TENSILE) sum += crowded.tensor().cwiseProduct(tensor(i, at_tension)).sum();
  stress = -unit_factor * component(i, K) * sum;
  viscous = pulled;
}

// of a block -4/m_i of what the correction heats

template <int D, class Precision>
template <bool EVENLY>
typename EulerianSweeps<D, Precision>::Pack
EulerianSweeps<D, Precision>::corrected_power(int block) const
{
  const Number *i = columns.at(block * LANES);
  const Nearest near = nearest(block);
  Neighbors neighbors(*this, block, X, MASS + 1, LAST, at_da + D);
  const int *further = pairs.further.data();
  neighbors.ask_ahead(further, near);
  const NearFactors<EVENLY> factor(*this, near, i);
  const typename Base::template CorrectionHeat<EVENLY> heat(*this, i, at_da);
  Pack power = 0.0;
  for (int n = 0; n < near.count; n++) {
    const Number *j = neighbors(further[near.slot[n]]);
    power = multiply_add(factor(n, j), heat.of(j), power);
  }
  return power;
}

/* ----------------------------------------------------------------------
   virial: of a block sum f_ij (x) x_ij
------------------------------------------------------------------------- */

template <int D, class Precision>
typename EulerianSweeps<D, Precision>::Tensors
EulerianSweeps<D, Precision>::block_virial(const Particles &p, int block, const Batch &batch) const
{
  const Number *i = columns.at(block * LANES);
  const Nearest near = nearest(block);
  const NearFactors<false> factor(*this, near, i);
  const Pack mass = batch.load(p.mass), own_K = component(i, K);
  TensorSums<D, Pack> sum;
  const Motion own(*this, i);
  const typename Base::template Along<true> of_pair(*this, i, needs_correction() ? at_da : V);
  Neighbors neighbors(*this, block, X, components());
  int n = 0;    // of the nearest ones
  for (int s = pairs.first[block]; s < pairs.first[block] + pairs.count[block]; s++) {
    const std::size_t k = s * std::size_t(LANES);
    const Number *j = neighbors(pairs.further[s]);
    const Parts d = own.from(j);
    const Pack KF = own_K * component(j, K) * Precision::load(&pairs.factor[k]);
    Pack f[D], central = 0.0;
    if (keeps_pairs()) central = mass * Base::whole_pull(i, j, LAST, load(&pairs.pull[k]));
    for (int a = 0; a < D; a++) {
      Pack t = 0.0;
      for (int b = 0; b < D; b++) {
        const int c = D * a + b;
        Pack of_both = component(i, T + c) + component(j, T + c);
        if (opt.tensile)
          of_both +=
              load(&pairs.crowd[k]) * (component(i, at_tension + c) + component(j, at_tension + c));
        t += of_both * d.x[b];
      }
      f[a] = unit_factor * (KF * t - central * d.x[a]);
    }
    if (needs_correction() && n < near.count && near.slot[n] == s) {
      const Pack w = 0.5 * mass * factor(n++, j);
      Pack along[D];
      of_pair.from(j, along);
      for (int a = 0; a < D; a++) f[a] += w * along[a];
    }
    sum.add(f, d.x);
  }
  return sum.tensor();
}

}    // namespace

#endif
