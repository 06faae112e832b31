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
   The heat of viscosity and hourglass damping is the work of pair forces f_ij on displacements.
   Forces come from velocities v, and what is known of particle i is half the work of its pairs
   on these, P_i = -1/2 sum f_ij.(v_i - v_j), and the sum of the forces, F_i.  For displacements u in a
   time t it takes
     t P_i - F_i.(u_i - t v_i),
   which is linear in u and adds up to -sum F_i.u_i, the loss of kinetic energy.  So does
   -1/2 sum f_ij.(u_i - u_j), from which it differs by what neighbors exchange,
   1/4 sum f_ij.(w_i + w_j) with w = u - t v, in a step the change of velocity.  Nothing need be kept of
   pairs but a number of either particle, 2 P_i + F_i.v_i.
------------------------------------------------------------------------- */

// of a force on a block, on velocities or displacements in V

template <int D, class Precision>
typename LagrangianSweeps<D, Precision>::Pack
LagrangianSweeps<D, Precision>::power_of(const Number *force, int block) const
{
  const Number *i = columns.at(block * LANES);
  Pack power = 0.0;
  for (int a = 0; a < D; a++)
    power = multiply_add(load(force + a * LANES), component(i, V + a), power);
  return power;
}

// -F_i.u_i of these forces

template <int D, class Precision>
typename LagrangianSweeps<D, Precision>::Powers
LagrangianSweeps<D, Precision>::powers_of_forces(int block) const
{
  Powers of;
  if (opt.hourglass > 0.0) of.hourglass -= power_of(accounts.at(block, accounts.hourglass), block);
  if (!needs_correction()) {
    if (keeps_pairs()) of.viscous -= power_of(accounts.at(block, Accounts::VISCOUS), block);
  } else {
    if (keeps_pairs()) of.viscous -= power_of(&heated_force[vector_at(block)], block);
    if (Base::heats_evenly())
      of.corrected -= power_of(accounts.at(block, Accounts::VISCOUS), block);
  }
  return of;
}

// the same, entered into the totals

template <int D, class Precision>
typename LagrangianSweeps<D, Precision>::Pack
LagrangianSweeps<D, Precision>::power_of_forces(int block, const Batch &batch, Pack mass,
                                                Totals &totals) const
{
  const Powers of = powers_of_forces(block);
  totals.viscous += Base::sum_of_first(of.viscous + of.corrected, batch.n);
  totals.standard +=
      Base::sum_of_first(of.viscous + standard_power(columns.at(block * LANES), mass), batch.n);
  totals.hourglass += Base::sum_of_first(of.hourglass, batch.n);
  return of.all();
}

// of sum V0_j (u_j - u_i) (x) g; of each pair the half with sigma_i

template <int D, class Precision>
typename LagrangianSweeps<D, Precision>::Pack
LagrangianSweeps<D, Precision>::power_of_stress(int block, const Tensors &displaced) const
{
  return own_volume(block) * displaced.cwiseProduct(tensor(columns.at(block * LANES), T)).sum();
}

// F_i.v_i, before displacements take the place of these velocities

template <int D, class Precision> void LagrangianSweeps<D, Precision>::save_power()
{
  if (!velocities_known || !opt.energy || !dissipates()) return;
  velocities_known = false;
  power_then.resize(end_of_own);
  each_block([&](int block, const Batch &, Totals &) {
    store(&power_then[block * LANES], -powers_of_forces(block).all());
  });
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
    Tensors velocity = accumulate(block).velocity;
    if (batch.n < LANES) Base::repeat_last(velocity, batch.n);
    add_late_heat(p, block, batch, velocity, t);
  });
  enter_due(totals);
}

template <int D, class Precision> void LagrangianSweeps<D, Precision>::enter_due(const Totals &late)
{
  Base::enter(early_totals, this->due);
  Base::enter(late, this->due);
  early_totals = {};
  this->due = 0.0;
}

// what the last evaluation's forces do to the particles of a block,
// with the velocities of that evaluation, known since, plus these

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::add_late_heat(const Particles &p, int block,
                                                   const Batch &batch, const Tensors &velocity,
                                                   Totals &totals) const
{
  const Pack mass = batch.load(p.mass);
  Pack heat = power_of_stress(block, velocity) + load(accounts.at(block, accounts.stress));
  if (dissipates())
    heat += power_of_forces(block, batch, mass, totals) + load(accounts.at(block, accounts.pairs));
  this->add_heat(p, batch, mass, this->due * heat);
}

/* ----------------------------------------------------------------------
   heat of a sweep of its own
------------------------------------------------------------------------- */

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::heat(const Particles &p, const NeighborRows &, double time,
                                          double *heat)
{
  mirror_vectors(V);
  const Totals totals = each_block([&](int block, const Batch &batch, Totals &t) {
    const Pack mass = batch.load(p.mass);
    Pack of_block = power_of_stress(block, accumulate(block).velocity);
    if (dissipates()) {
      const Pack pairs = load(accounts.at(block, accounts.pairs)),    // 2 P + F.v
          then = load(&power_then[block * LANES]);
      of_block += power_of_forces(block, batch, mass, t) + (0.5 * time) * (pairs + then);
      if (needs_correction() && !Base::heats_evenly()) {
        const Pack uneven = uneven_heat(block, mass);
        t.viscous += Base::sum_of_first(uneven, batch.n);
        of_block += uneven;
      }
    }
    this->give_heat(p, batch, mass, heat, of_block);
  });
  if (heat) return;
  Base::enter(totals, 1.0);
  early_totals = {};    // of the same forces
}

// of the correction with weights or a heating that are not the same from both sides

template <int D, class Precision>
typename LagrangianSweeps<D, Precision>::Pack
LagrangianSweeps<D, Precision>::uneven_heat(int block, Pack mass) const
{
  const auto near = near_factors(block);
  const typename Base::template CorrectionHeat<false> heat(*this, columns.at(block * LANES), at_da);
  Neighbors neighbors(*this, block, T, at_da);
  Pack sum = 0.0;
  for (int n = 0; n < slots.nearest(block); n++)
    sum = multiply_add(load(near.of(n)), heat.of(neighbors(slots.first[block] + n)), sum);
  return -0.25 * mass * sum;
}

/* ----------------------------------------------------------------------
   virial: of a block sum f_ij (x) x_ij.  Central forces have added theirs while they were found
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
    const int n = s - slots.first[block];
    const Number *j = neighbors(s);
    const Parts d = own.from(j);
    Pack reference[D], f[D];
    own_reference.apart(j, REFERENCE, reference);
    for (int a = 0; a < D; a++) {
      Pack t = 0.0;
      for (int b = 0; b < D; b++)
        t += (component(i, T + D * a + b) + component(j, T + D * a + b)) * reference[b];
      f[a] = V0 * (factor(s, j) * t);
    }
    if (n < slots.nearest(block)) {
      Pack along[D];
      of_pair.from(j, along);
      for (int a = 0; a < D; a++) f[a] += half_mass * load(near.of(n)) * along[a];
    }
    sum.add(f, d.x);
  }
  if (!keeps_central()) return sum.tensor();
  return sum.tensor() + load_symmetric(&central_virial[symmetric_at(block)]);
}

}    // namespace

#endif
