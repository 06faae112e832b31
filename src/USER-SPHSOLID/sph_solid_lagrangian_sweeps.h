/* ----------------------------------------------------------------------
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
   The sweeps of the Lagrangian frame: velocity gradients with the constitutive
   update, and forces; see sph_solid_lagrangian.h.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_SWEEPS_H
#define LMP_SPH_SOLID_LAGRANGIAN_SWEEPS_H

#include "sph_solid_lagrangian.h"
#include "sph_solid_lagrangian_elastic.h"
#include "sph_solid_lagrangian_heat.h"
#include "sph_solid_lagrangian_limits.h"
#include "sph_solid_lagrangian_partners.h"
#include "sph_solid_lagrangian_rows.h"
#include "sph_solid_lagrangian_viscous.h"

#include <atomic>

namespace {

/* ----------------------------------------------------------------------
   gradient sweep
------------------------------------------------------------------------- */

template <int D, class Precision>
typename LagrangianSweeps<D, Precision>::Sums
LagrangianSweeps<D, Precision>::accumulate(int block) const
{
  const Number *i = columns.at(block * LANES);
  const int first = slots.first[block], end = slots.first[block + 1];
  const auto constants = slots.constants.from(first);
  if (asks_for_block(block)) ask_for_slots(block);
  TensorSums<D, Pack> displaced, velocity;
  const Motion own(*this, i);
  Neighbors neighbors(*this, block, T);
  for (int s = first; s < end; s++) {
    const Number *j = neighbors(s);
    neighbors.template prefetch_ahead<4, T>(s, j);
    const Parts d = own.from(j);
    Pack u[D], g[D];
    displacement(i, j, d.x, -factor(constants.of(s - first), j), u, g);
    displaced.add(u, g);
    velocity.add(d.v, g);
  }
  return {displaced.tensor(), velocity.tensor()};
}

template <int D, class Precision>
int LagrangianSweeps<D, Precision>::gradient(const Particles &p, const NeighborRows &, double dt)
{
  std::atomic<int> bad(-1);
  const bool late = this->due > 0.0;
  const Totals totals = each_block([&](int block, const Batch &batch, Totals &t) {
    const int unphysical = late ? update<true>(p, block, batch, dt, t)
                                : update<false>(p, block, batch, dt, t);
    if (unphysical >= 0) bad = unphysical;
  });
  enter_due(totals);
  return bad;
}

// behind the last particle the last one again

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::repeat_last(Sums &sums, int n)
{
  for (Tensors *of : {&sums.displacement, &sums.velocity}) Base::repeat_last(*of, n);
}

// constitutive update of a block and what their neighbors read; the
// index of one whose state is not physical, or -1

template <int D, class Precision>
template <bool LATE>
int LagrangianSweeps<D, Precision>::update(const Particles &p, int block, const Batch &batch,
                                           double dt, Totals &totals)
{
  if (Base::ask_points_ahead(p, block, batch, T, at_da)) {
    prefetch(correction_of(block + 2), SYMMETRIC * LANES);
    ask_for_accounts(block);
  }
  Sums sums = accumulate(block);
  if (batch.n < LANES) repeat_last(sums, batch.n);
  const Tensors correction = load_correction(block);
  const Tensors Fi = Tensors::Identity() + sums.displacement * correction;
  const Tensors rate = sums.velocity * correction;
  if (LATE) add_late_heat(p, block, batch, sums.velocity, totals);

  Tensors L = Tensors::Zero();
  if (dt > 0.0) L = rate * Tensors(Fi - Pack(0.5 * dt) * rate).inverse();
  const auto points = Base::update_points(p, batch, L, dt);
  totals.plastic += Base::sum_of_first(points.plastic_work, batch.n);

  const Pack rho = points.state.rho, c = square_root(maximum(points.eos.c2, Pack(0.0)));
  const Pack V0 = own_volume(block), J = batch.load(p.mass) / (rho * V0);
  const Tensors inverse = Fi.inverse(), C = J * inverse.transpose() * correction.transpose();
  const Tensors sigma_C = points.sigma * C;
  if (this->keeps_heat)
    store(accounts.at(block, accounts.stress), V0 * sums.velocity.cwiseProduct(sigma_C).sum());

  const int column = block * LANES;
  const Pack h = Base::smoothing_lengths(p, batch);
  store_tensor(column, T, sigma_C);
  columns.store(column, SOUND, c);
  if (opt.hourglass > 0.0) {
    const Pack c_l = Base::longitudinal_speed(c, Base::shear_moduli(p, batch), points.inv_rho);
    columns.store(column, IMPEDANCE, (0.5 * opt.hourglass / damping_unit) * (rho * h * c_l));
  }
  const bool switched = needs_switch(pair_form(opt.viscosity));
  if (keeps_rates() || switched) {
    const Tensors present = rate * inverse;    // velocity gradient at the end of the step
    if (keeps_rates()) Base::store_rate(column, at_rate, present);
    if (switched) columns.store(column, LAST, Base::own_switch(present, c, h));
  }
  columns.copy_to_rows(column, T, at_da);
  return Base::unphysical(batch, rho, points.eos.P + points.state.S.sum() + C.sum());
}

/* ----------------------------------------------------------------------
   force sweep
------------------------------------------------------------------------- */

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::force(const Particles &p, const NeighborRows &)
{
  with_form(pair_form(opt.viscosity), [&](auto form) {
    if (opt.hourglass > 0.0)
      force_blocks<form(), true>(p);
    else
      force_blocks<form(), false>(p);
  });
}

template <int D, class Precision>
template <PairForm FORM, bool HOURGLASS>
void LagrangianSweeps<D, Precision>::force_blocks(const Particles &p)
{
  constexpr bool MEANS = FORM != PairForm::NONE || HOURGLASS;
  if (MEANS && this->unlike)
    force_each<FORM, HOURGLASS, MEANS>(p);
  else
    force_each<FORM, HOURGLASS, false>(p);
}

template <int D, class Precision>
template <PairForm FORM, bool HOURGLASS, bool UNLIKE>
void LagrangianSweeps<D, Precision>::force_each(const Particles &p)
{
  const Totals totals = each_block([&](int block, const Batch &batch, Totals &t) {
    force_block<FORM, HOURGLASS, UNLIKE>(p, block, batch, t);
  });
  Totals::add(early_totals, totals);
}

// what it reads and writes of the block after the next one

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::ask_for_force(const Particles &p, int block,
                                                   const Batch &batch) const
{
  ask_for_slots(block);
  ask_for_accounts(block);
  prefetch(&gradient_sum[vector_at(block + 2)], D * LANES);
  Base::prefetch_components(columns.at((block + 2) * LANES), at_da, at_rho);
  Base::ask_for(p.mass, batch);
}

// f_i = V0_i sum_j V0_j [(T_i + T_j) g_ij - Pi_ij G_ij x_ij] + hourglass; T_i sum V0_j g_ij, which is
// constant, comes last.
// viscosity: central, Pi = rho0 mu (a2 mu - a1 c) with eq. 24's mu at the
// reference distance, G = g.X/x^2 the kernel gradient along x: of the deformed body it is
// J F^-T g, and (J F^-T g).x = J g.X where x = F X, whatever F is; rho J is rho0.
// hourglass: c rho c_L h w_ij nu_ij with nu_ij the part along x_ij of
// v_ij - (D_i+D_j)/2 x_ij, which no linear field contains, and
// w_ij = -g_ij.X_ij/X_ij^2.
// of both particles, tr B/D is the arithmetic mean, rho0 and rho c_L h the harmonic one, 2ab/(a+b).  Where
// all are alike at rest (UNLIKE is false) it is the arithmetic mean, too: for rho0 the same, for rho c_L h
// more by a share of (a-b)^2/(a+b)^2

template <int D, class Precision>
template <PairForm FORM, bool HOURGLASS, bool UNLIKE>
void LagrangianSweeps<D, Precision>::force_block(const Particles &p, int block, const Batch &batch,
                                                 Totals &totals)
{
  constexpr bool VISCOUS = FORM != PairForm::NONE, BOTH = needs_rates(FORM),
                 RATES = BOTH || HOURGLASS;
  if (asks_for_block(block)) ask_for_force(p, block, batch);
  const Number *i = columns.at(block * LANES);
  const int first = slots.first[block], end = slots.first[block + 1];
  const auto constants = slots.constants.from(first);
  TensorSums<D, Pack> virial, *const of_virial = this->wants_virial ? &virial : nullptr;
  const bool keep = keeps_pairs(), correct = needs_correction(), alone = correct && lonely;
  const double minus_a1 = -0.25 * opt.a1, a2 = 0.5 * opt.a2;    // of the sums of both particles
  const int rho0 = at_rho;
  // of lanes without a partner, which may lie on what they read, and particles that land on their image:
  // find_overload() will say so.  Its inverse times 0 is 0
  const Pack least_r2 = ruler.least_r2();
  const Pack zero(0.0), one(1.0);
  const Motion own(*this, i);
  const Places own_reference(*this, i, REFERENCE);
  const Pack own_linear = minus_a1 * component(i, SOUND), own_density = component(i, DENSITY),
             own_impedance = component(i, IMPEDANCE);
  Pack stress[D], damped[D], whole[D], replaced[D];    // sums over pairs
  Pack mu_least = zero, viscous_power = zero, hourglass_power = zero;
  each_index<D>([&](auto a) {
    stress[a] = damped[a] = whole[a] = replaced[a] = zero;
  });
  Neighbors neighbors(*this, block, at_da, at_rho);

  for (int s = first; s < end; s++) {
    const Number *j = neighbors(s);
    neighbors.template prefetch_ahead<2, at_rate + (RATES ? SYMMETRIC : 0)>(s, j);
    const float *constant = constants.of(s - first);
    const Pack kernel = Precision::load(constant + Slots::FACTOR), weight = component(j, WEIGHT),
               F = kernel * weight;
    Pack X[D];
    own_reference.apart(j, REFERENCE, X);
    each_index<D>([&](auto a) {
      Pack t = component(j, T + D * a) * X[0];
      for (int b = 1; b < D; b++) t = multiply_add(component(j, T + D * a + b), X[b], t);
      stress[a] = multiply_add(F, t, stress[a]);
    });
    if (!VISCOUS && !HOURGLASS) continue;

    const Parts d = own.from(j);
    const Pack r2 = add_dot<D>(least_r2, d.x, d.x), vr = d.v_dot_x();
    // sums of both, and with one division 1/x^2 and 1 over the sums
    Pack rhos = one, impedances = one;
    if (UNLIKE && VISCOUS) rhos = component(i, rho0) + component(j, rho0);
    if (HOURGLASS) impedances = own_impedance + component(j, IMPEDANCE);
    const Pack sums = HOURGLASS ? rhos * impedances : rhos;
    const Pack inverse = 1.0 / (UNLIKE ? r2 * sums : r2);
    const Pack inv_r2 = UNLIKE ? inverse * sums : inverse, per_r2 = kernel * inv_r2;
    Pack li = zero, lj = zero;    // their sum counts, and for some viscosities each of them
    if (BOTH) {
      li = stretching(i, at_rate, d.x);
      lj = stretching(j, at_rate, d.x);
    } else if (RATES)
      li = stretching(i, j, at_rate, d.x);
    if (HOURGLASS) {
      Pack impedance = impedances;
      if (UNLIKE) impedance = 4.0 * own_impedance * component(j, IMPEDANCE) * (inverse * r2 * rhos);
      const Pack rest = multiply_add(BOTH ? li + lj : li, Pack(-0.5), vr);
      const Pack q = weight * (impedance * rest * per_r2);
      hourglass_power = multiply_add(q, vr, hourglass_power);
      d.add_to(damped, q);
      if (of_virial) add_central(*of_virial, damping_unit * q, d.x);
    }
    if (VISCOUS) {
      const Pack on = needs_switch(FORM) ? 0.5 * (component(i, LAST) + component(j, LAST)) : one;
      const Pack jump = jump_left<FORM>(vr, li, lj, on);
      const Pack mu = minimum(jump, zero) * Precision::load(constant + Slots::NEARNESS) *
          square_root(r2) * inv_r2;
      Pack rho = own_density + component(j, DENSITY);    // twice the mean, with tr B/D
      if (UNLIKE)
        rho = 2.0 * (inverse * r2 * impedances) *
            (component(i, rho0) * component(j, DENSITY) + component(j, rho0) * own_density);
      const Pack linear = multiply_add(component(j, SOUND), Pack(minus_a1), own_linear);
      Pack Pi = rho * mu * multiply_add(mu, Pack(a2), linear);
      if (FORM == PairForm::SWITCHED) Pi *= on;
      const Pack q = Pi * (dot<D>(X, X) * (weight * per_r2));    // V0_j Pi G
      if (keep) {
        viscous_power = multiply_add(Base::heated_pull(i, j, LAST, q), vr, viscous_power);
        if (of_virial) add_central(*of_virial, -Base::whole_pull(i, j, LAST, q), d.x);
      }
      if (alone) {
        const Pack stays = Base::whole_pull(i, j, LAST, q);
        d.add_to(whole, stays);
        d.add_to(replaced, q - stays);
      } else
        d.add_to(replaced, q);
      mu_least = minimum(mu_least, mu);
    }
  }

  const Pack V0 = own_volume(block);
  const Number *own_sum = &gradient_sum[vector_at(block)];
  // not the sums, which would be kept in memory if one took their address
  Pack force[D], damping[D], acceleration[D];
  each_index<D>([&](auto a) {
    force[a] = stress[a];
    for (int b = 0; b < D; b++)
      force[a] = multiply_add(component(i, T + D * a + b), load(own_sum + b * LANES), force[a]);
    damping[a] = damping_unit * V0 * damped[a];
    force[a] = multiply_add(V0, force[a], damping[a]);
    if (VISCOUS) force[a] -= V0 * (correct ? whole[a] : replaced[a]);
  });
  if (VISCOUS && correct) {
    const Pack per_mass = V0 / batch.load(p.mass);
    each_index<D>([&](auto a) {
      acceleration[a] = -(per_mass * replaced[a]);
    });
    columns.store(block * LANES, at_da, acceleration, D);
    store_vector(accounts.at(block, Accounts::VISCOUS), force);
  } else
    Base::add_forces(p, batch, force);
  columns.copy_to_rows(block * LANES, at_da, columns.components());
  if (this->limits_step) store(&mu_max[block * LANES], -mu_least);
  if ((VISCOUS || HOURGLASS) && of_virial && keeps_central())
    store_symmetric(&central_virial[symmetric_at(block)], V0 * virial.symmetric_tensor());
  if (!(VISCOUS || HOURGLASS) || !opt.energy) return;

  // for heat, see sph_solid_lagrangian_heat.h
  const Pack viscous_heat = 0.5 * V0 * viscous_power,
             hourglass_heat = (-0.5 * damping_unit) * V0 * hourglass_power;
  Pack own_power = zero;
  if (HOURGLASS) {
    store_vector(accounts.at(block, accounts.hourglass), damping);
    own_power = dot<D>(damping, own.v);
  }
  if (keep) {
    const bool all = !correct || opt.heating == Heating::PRINTED;
    each_index<D>([&](auto a) {
      force[a] = -(V0 * (all ? whole[a] + replaced[a] : whole[a]));
    });
    store_vector(correct ? &heated_force[vector_at(block)] : accounts.at(block, Accounts::VISCOUS),
                 force);
    own_power += dot<D>(force, own.v);
  }
  store(accounts.at(block, accounts.pairs), 2.0 * (viscous_heat + hourglass_heat) + own_power);
  if (!this->keeps_heat) return;
  const double viscous = Base::sum_of_first(viscous_heat, batch.n);
  totals.viscous += viscous;
  totals.standard += viscous;
  totals.hourglass += Base::sum_of_first(hourglass_heat, batch.n);
}

}    // namespace

template <int D, class Precision>
std::unique_ptr<Sweeps> SPHSolid::lagrangian_sweeps(const Options &o,
                                                    const std::vector<TypeData> &t)
{
  return std::make_unique<LagrangianSweeps<D, Precision>>(o, t);
}

#endif
