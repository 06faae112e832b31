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
   Heat and virial of the Lagrangian frame.  Members of LagrangianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_HEAT_H
#define LMP_SPH_SOLID_LAGRANGIAN_HEAT_H

#include "sph_solid_lagrangian.h"

namespace {

/* ----------------------------------------------------------------------
   what the forces of pairs give to i while particles move, up to factors of i: half
   of each pair's of viscosity and hourglass damping
------------------------------------------------------------------------- */

template <int D, class Precision>
template <typename LagrangianSweeps<D, Precision>::Work WORK>
inline void LagrangianSweeps<D, Precision>::add_work(const Kept &kept, int s, const Number *i,
                                                     const Number *j, const Parts &d,
                                                     PairWork &work) const
{
  const std::size_t k = s * std::size_t(LANES);
  Pack along = 0.0;    // velocities along distances when the forces were found
  for (int a = 0; a < D; a++) {
    const Pack x = WORK == Work::DUE ? d.x[a] - kept.drift * d.v[a] : d.x[a];
    along = multiply_add(d.v[a], x, along);
  }
  if (kept.damping)
    work.hourglass = multiply_add(component(j, WEIGHT) * Precision::load(kept.damping + k), along,
                                  work.hourglass);
  if (kept.pulls)
    work.viscous =
        multiply_add(Base::heated_pull(i, j, LAST, load(kept.pulls + k)), along, work.viscous);
}

/* ----------------------------------------------------------------------
   heat on the way: the share of the velocities that come after the forces
------------------------------------------------------------------------- */

template <int D, class Precision> bool LagrangianSweeps<D, Precision>::can_keep_heat() const
{
  if (!opt.energy) return false;
  return !needs_correction() || Base::heats_evenly();
}

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::add_due_heat(const Particles &p, const NeighborRows &)
{
  const Totals totals = each_block([&](int block, const Batch &batch, Totals &t) {
    Sums sums = accumulate<Work::DUE>(block);
    if (batch.n < LANES) repeat_last(sums, batch.n);
    add_late_heat(p, block, batch, sums, t);
  });
  enter_due(totals);
}

template <int D, class Precision> void LagrangianSweeps<D, Precision>::enter_due(const Totals &late)
{
  Base::enter(early_totals, this->due.factor);
  Base::enter(late, this->due.factor);
  early_totals = {};
  this->due = {};
}

// the work of forces on the particles of a block; of the stress the half with sigma_i

template <int D, class Precision>
typename LagrangianSweeps<D, Precision>::Power
LagrangianSweeps<D, Precision>::power(int block, Pack mass, const Sums &sums) const
{
  const Pack V0 = own_volume(block);
  const Tensors sigma_C = tensor(columns.at(block * LANES), T);
  return {V0 * sums.velocity.cwiseProduct(sigma_C).sum(), 0.5 * V0 * sums.work.viscous,
          -0.25 * mass * sums.work.corrected, (-0.5 * damping_unit) * V0 * sums.work.hourglass};
}

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::enter_block(int block, Pack mass, int n, const Power &power,
                                                 Totals &totals) const
{
  const Pack standard = standard_power(columns.at(block * LANES), mass);
  totals.viscous += Base::sum_of_first(power.viscous + power.corrected, n);
  totals.standard += Base::sum_of_first(power.viscous + standard, n);
  totals.hourglass += Base::sum_of_first(power.hourglass, n);
}

// what the last evaluation's forces do to the particles of a block,
// with the velocities of that evaluation, known since, plus these

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::add_late_heat(const Particles &p, int block,
                                                   const Batch &batch, const Sums &sums,
                                                   Totals &totals) const
{
  const Pack mass = batch.load(p.mass);
  const Power late = power(block, mass, sums);
  enter_block(block, mass, batch.n, late, totals);
  const Pack heat = load(&early[block * LANES]) + late.sum();
  this->add_heat(p, batch, mass, this->due.factor * heat);
}

/* ----------------------------------------------------------------------
   heat of a sweep of its own
------------------------------------------------------------------------- */

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::heat(const Particles &p, const NeighborRows &, double *heat)
{
  mirror_vectors(V);
  const Totals totals = each_block([&](int block, const Batch &batch, Totals &t) {
    const Sums sums = accumulate<Work::WHOLE>(block);
    const Pack mass = batch.load(p.mass);
    const Power of_block = power(block, mass, sums);
    enter_block(block, mass, batch.n, of_block, t);
    this->give_heat(p, batch, mass, heat, of_block.sum());
  });
  if (heat) return;
  Base::enter(totals, 1.0);
  early_totals = {};    // of the same forces
}

/* ----------------------------------------------------------------------
   virial: of a block sum f_ij (x) x_ij
------------------------------------------------------------------------- */

template <int D, class Precision>
typename LagrangianSweeps<D, Precision>::Tensors
LagrangianSweeps<D, Precision>::block_virial(const Particles &p, int block,
                                             const Batch &batch) const
{
  const Number *i = columns.at(block * LANES);
  const Pack V0 = own_volume(block), half_mass = 0.5 * batch.load(p.mass);
  const auto near = near_factors(block);
  TensorSums<D, Pack> sum;
  const Motion own(*this, i);
  const typename Base::template Along<true> of_pair(*this, i, needs_correction() ? at_da : V);
  const Places own_reference(*this, i, REFERENCE);
  Neighbors neighbors(*this, block, at_da, at_da);
  for (int s = slots.first[block]; s < slots.first[block + 1]; s++) {
    const std::size_t k = s * std::size_t(LANES);
    const int n = s - slots.first[block];
    const Number *j = neighbors(s);
    const Parts d = own.from(j);
    Pack reference[D], f[D], central = 0.0;
    own_reference.apart(j, REFERENCE, reference);
    if (opt.hourglass > 0.0)
      central += damping_unit * component(j, WEIGHT) * Precision::load(&damp[k]);
    if (keeps_pairs()) central -= Base::whole_pull(i, j, LAST, load(&pull[k]));
    for (int a = 0; a < D; a++) {
      Pack t = 0.0;
      for (int b = 0; b < D; b++)
        t += (component(i, T + D * a + b) + component(j, T + D * a + b)) * reference[b];
      f[a] = V0 * (factor(s, j) * t + central * d.x[a]);
    }
    if (n < slots.nearest(block)) {
      Pack along[D];
      of_pair.from(j, along);
      for (int a = 0; a < D; a++) f[a] += half_mass * load(near.of(n)) * along[a];
    }
    sum.add(f, d.x);
  }
  return sum.tensor();
}

}    // namespace

#endif
