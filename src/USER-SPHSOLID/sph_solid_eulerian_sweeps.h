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
   The sweeps of the Eulerian frame: velocity gradients with the constitutive
   update, and forces; see sph_solid_eulerian.h.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EULERIAN_SWEEPS_H
#define LMP_SPH_SOLID_EULERIAN_SWEEPS_H

#include "sph_solid_eulerian.h"
#include "sph_solid_eulerian_candidates.h"
#include "sph_solid_eulerian_heat.h"
#include "sph_solid_eulerian_rows.h"
#include "sph_solid_eulerian_viscous.h"
#include "sph_solid_tensile.h"

#include <atomic>

namespace {

// who sees too little of its surroundings to correct anything has B = 1, beyond_share().  Corners and edges
// have 0.40 or more, up to h = 2 spacings, and turn without being strained, but of two or three layers of half
// cells (doc/theory.rst); with 0.1 fragments of a torn foot are corrected, too, until a step changes their density
// by more than it is
constexpr double LEAST_ROUNDNESS = 0.4;

// and so has who is about to lose its neighbors, which the correction would hold on to until the end of
// the kernel: the mean of M's diagonal is 1 inside a body and 2^-D in a corner of half cells.  It goes with the
// volumes of neighbors: a bar of 2 x 2 half cells has no correction at all
template <int D> constexpr double LEAST_MOMENT = 0.8 / (1 << D);

/* ----------------------------------------------------------------------
   gradient sweep
------------------------------------------------------------------------- */

// of a thread: where the next block's slots with pairs begin; of the pairs of a block r^2, r/h and,
// where they differ, smoothing lengths

template <int D, class Precision> struct EulerianSweeps<D, Precision>::Finding {
  int slot, near;
  Numbers distance2, length;
  SingleRows q;
  Finding(const Candidates &of, int first, int end, bool uniform) :
      slot(of.first[first]), near(of.first[first])
  {
    int most = 0;
    for (int block = first; block < end; block++)
      most = std::max(most, of.first[block + 1] - of.first[block]);
    distance2.resize(most * std::size_t(LANES));
    q.resize(distance2.size());
    if (!uniform) length.resize(distance2.size());
  }
};

// slots of candidates that have a pair: r^2 of each, and in lanes without a pair what is beyond any

template <int D, class Precision>
template <bool UNIFORM>
void EulerianSweeps<D, Precision>::find_pairs(int block, Finding &found)
{
  // what has no pair gets a distance by so much beyond the range of the kernel, where its factor is 0
  constexpr double BEYOND = 1.001;
  const Number *i = columns.at(block * LANES);
  const int first = candidates.first[block], end = candidates.first[block + 1];
  const int *further = candidates.further.data();
  Neighbors neighbors(*this, block, X, X + D, at_h, components());
  neighbors.ask_ahead(further + first, end - first);
  if (asks_for_block(block)) {
    const int from = candidates.first[block + 2], n = candidates.first[block + 3] - from;
    prefetch_list(candidates.further.data() + from, n);
    prefetch_list(candidates.lanes.data() + from, n);
    prefetch_list(candidates.mirrored.data() + from, n);
  }
  const Pack own_near = near_of<UNIFORM>(i);
  auto range_of = [&](Pack h, Pack near_of_other) {
    const Pack range = maximum(Precision::SUPPORT * h, 0.5 * (own_near + near_of_other));
    return range * range;
  };
  const Bits *lanes = candidates.lanes.data();
  const char *mirrored = candidates.mirrored.data();
  int *to_further = pairs.further.data();
  Bits *to_lanes = pairs.lanes.data();
  Number *distance2 = found.distance2.data(), *length = found.length.data();
  const Pack common_range2 = range_of(Pack(common_h), Pack(common_near));
  const typename Base::Places own(*this, i, X);
  int n = found.slot;
  for (int c = first; c < end; c++) {
    const Number *j = neighbors(further[c]);
    Pack x[D];
    own.apart(j, X, x);
    const Pack r2 = dot<D>(x, x);
    const Pack h = mean_h<UNIFORM>(i, j);
    const Pack range2 = UNIFORM ? common_range2 : range_of(h, near_of<UNIFORM>(j));
    unsigned inside = larger_lanes(range2, r2) & lanes[c];
    if (mirrored[c]) inside &= larger_lanes(r2, 4.0 * ON_PLANE * ON_PLANE * h * h);    // not itself
    if (!inside) continue;
    store(distance2, where_lanes(inside, r2, BEYOND * range2));
    distance2 += LANES;
    if (!UNIFORM) {
      store(length, h);
      length += LANES;
    }
    to_further[n] = further[c];
    to_lanes[n] = static_cast<Bits>(inside);
    n++;
  }
  pairs.first[block] = found.slot;
  pairs.count[block] = n - found.slot;
  found.slot = n;
}

// r/h and kernel gradients of the pairs of a block: grad_i W = F (x_i - x_j), stored is F h0^(D+2).
// In single precision, as it is stored: rounding is the same from both sides.  A short loop of its
// own, so that the processor has many roots and divisions on the way

template <int D, class Precision>
template <bool UNIFORM>
void EulerianSweeps<D, Precision>::find_factors(int block, Finding &found)
{
  using Kernel = CubicSpline<D>;
  constexpr double LEAST_Q2 = 1.0e-30;    // of particles that meet
  const double per_unit = 1.0 / unit_factor;
  const Pack common_inverse(1.0 / common_h);
  const Single common_scale = rounded(per_unit * Kernel::gradient_scale(common_inverse));
  float *factors = pairs.factor.data() + pairs.first[block] * std::size_t(LANES);
  float *to_q = found.q.data();
  const Number *distance2 = found.distance2.data(), *length = found.length.data();
  const std::ptrdiff_t next = kernel_gradients_ahead(block);
  for (int k = 0; k < pairs.count[block] * LANES; k += LANES) {
    const Pack hinv = UNIFORM ? common_inverse : 1.0 / load(length + k);
    const Single q =
        square_root(rounded(maximum(load(distance2 + k) * (hinv * hinv), Pack(LEAST_Q2))));
    const Single scale = UNIFORM ? common_scale : rounded(per_unit * Kernel::gradient_scale(hinv));
    prefetch(factors + k + next, LANES);
    store(factors + k, scale * Kernel::gradient_shape(q, 1.0 / q));
    store(to_q + k, q);
  }
}

// sums over the pairs of a block

template <int D, class Precision>
template <bool UNIFORM>
typename EulerianSweeps<D, Precision>::Sums EulerianSweeps<D, Precision>::accumulate(int block,
                                                                                     Finding &found)
{
  const Number *i = columns.at(block * LANES), *length = found.length.data();
  const float *of_q = found.q.data();
  const int first = pairs.first[block], count = pairs.count[block];
  const int *further = pairs.further.data() + first;
  Neighbors neighbors(*this, block, X, T, at_h, components());
  neighbors.ask_ahead(further, count);
  const float *factors = pairs.factor.data() + first * std::size_t(LANES);
  const bool correct = needs_correction();
  int *nearest = pairs.near.data() + (correct ? found.near : 0);
  float *kernels = pairs.near_kernel.data() + (correct ? found.near * std::size_t(LANES) : 0);
  const int *const first_nearest = nearest;
  const Motion own(*this, i);
  const Pack own_near = near_of<UNIFORM>(i);
  const double per_h = 1.0 / common_h;
  const Single same_support(per_h * common_near);
  TensorSums<D, Pack> moment, velocity;
  Pack nsum = 0.0;
  for (int s = 0; s < count; s++) {
    const Number *j = neighbors(further[s]);
    const Parts d = own.from(j);
    const Pack w = Precision::load(factors + s * LANES) * component(j, VOLUME);    // negative
    Pack g[D];
    for (int a = 0; a < D; a++) g[a] = w * d.x[a];
    moment.add_symmetric(d.x, g);
    velocity.add(d.v, g);
    if (!correct) continue;
    // both over the largest h
    Single r = Precision::load_single(of_q + s * LANES), support = same_support;
    if (!UNIFORM) {
      r *= rounded(per_h * load(length + s * LANES));
      support = rounded((0.5 * per_h) * (own_near + near_of<UNIFORM>(j)));
    }
    if (!larger_lanes(support, r)) continue;
    const Single kernel = CubicSpline<D>::w_of_inverse(r, 2.0 / support);
    store(kernels, kernel);
    kernels += LANES;
    *nearest++ = first + s;
    nsum = multiply_add(component(j, MASS), widened(kernel), nsum);
  }
  if (correct) {
    pairs.near_first[block] = found.near;
    pairs.near_count[block] = static_cast<int>(nearest - first_nearest);
    found.near += pairs.near_count[block];
  }
  return {-moment.symmetric_tensor(), -velocity.tensor(), nsum};
}

template <int D, class Precision>
int EulerianSweeps<D, Precision>::gradient(const Particles &p, const NeighborRows &, double dt)
{
  std::atomic<int> bad(-1);
  auto of_share = [&](int first, int end) {
    Totals totals;
    Finding found(candidates, first, end, uniform);
    auto sums_of_block = [&](int block, auto same) {
      constexpr bool UNIFORM = decltype(same)::value;
      find_pairs<UNIFORM>(block, found);
      find_factors<UNIFORM>(block, found);
      return accumulate<UNIFORM>(block, found);
    };
    for (int block = first; block < end; block++) {
      const Batch batch = this->batch(block);
      Sums sums = uniform ? sums_of_block(block, std::true_type())
                          : sums_of_block(block, std::false_type());
      const int unphysical = update(p, block, batch, sums, dt, totals);
      if (unphysical >= 0) bad = unphysical;
    }
    return totals;
  };
  const Totals totals = join_shares(nthreads, blocks(), Totals(), of_share, Totals::add);
  this->ledger.plastic_work += totals.plastic;
  nuncorrected = totals.uncorrected;
  return bad;
}

// constitutive update of a block and what their neighbors
// read; the index of one whose state is not physical, or -1

template <int D, class Precision>
int EulerianSweeps<D, Precision>::update(const Particles &p, int block, const Batch &batch,
                                         Sums &sums, double dt, Totals &totals)
{
  this->ask_points_ahead(p, block, batch, T, at_da);
  const PairForm form = pair_form(opt.viscosity);
  const int column = block * LANES;
  if (batch.n < LANES) {
    this->repeat_last(sums.moment, batch.n);
    this->repeat_last(sums.velocity, batch.n);
    this->repeat_last(sums.nsum, batch.n);
  }
  const Tensors &moment = sums.moment;
  Tensors B = Tensors::Identity(), exact = B;    // exact: for linear fields
  if (opt.corrected || needs_rates(form) || needs_switch(form)) {
    const Pack enough = minimum(beyond_share<D>(moment, LEAST_ROUNDNESS),
                                moment.trace() * (1.0 / D) - Pack(LEAST_MOMENT<D>));
    const Tensors inverse = moment.inverse();
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) exact(a, b) = where_positive(enough, inverse(a, b), exact(a, b));
    if (opt.corrected)
      totals.uncorrected += count_lanes(
          larger_lanes(moment.trace(), Pack(0.0)) & ~larger_lanes(enough, Pack(0.0)), batch.n);
  }
  if (opt.corrected) B = exact;
  // what tells a linear field from a jump needs the exact one, with gradient plain too
  const Tensors rate = sums.velocity * exact;
  Tensors L = Tensors::Zero();
  if (dt > 0.0) L = midpoint_velocity_gradient<D, Pack>(opt.corrected ? rate : sums.velocity, dt);
  const auto points = Base::update_points(p, batch, L, dt);
  totals.plastic += Base::sum_of_first(points.plastic_work, batch.n);

  const Pack rho = points.state.rho;
  const Pack c = square_root(maximum(points.eos.c2, Pack(0.0))), mass = batch.load(p.mass);
  auto weighted = [&](const Tensors &sigma) {
    return opt.corrected ? Tensors(sigma * B.transpose())
                         : Tensors(sigma * Pack(points.inv_rho * points.inv_rho));
  };
  Pack last = where_positive(sums.nsum, 1.0 / sums.nsum, Pack(0.0));
  if (needs_switch(form)) last = Base::own_switch(rate, c, Base::smoothing_lengths(p, batch));
  this->store_tensor(column, T, weighted(points.sigma));
  const Pack state[] = {opt.corrected ? mass * points.inv_rho : mass, rho, c, last};
  columns.store(column, K, state, 4);
  if (needs_rates(form)) this->store_rate(column, at_rate, rate);
  if (opt.tensile) this->store_tensor(column, at_tension, weighted(tension_stress(points.sigma)));
  columns.copy_to_rows(column, T, at_da);
  return Base::unphysical(batch, rho, points.eos.P + points.state.S.sum() + moment.sum());
}

// artificial stress of a block, one particle after the other: eigenvalues

template <int D, class Precision>
typename EulerianSweeps<D, Precision>::Tensors
EulerianSweeps<D, Precision>::tension_stress(const Tensors &sigma) const
{
  Tensor<D> R[LANES];
  for (int m = 0; m < LANES; m++)
    R[m] = artificial_stress<D>(of_lane<D>(sigma, m), opt.tensile_eps);
  Tensors out;
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++)
      out(a, b) = pack_of<Pack>([&](int m) {
        return R[m](a, b);
      });
  return out;
}

/* ----------------------------------------------------------------------
   force sweep
------------------------------------------------------------------------- */

template <int D, class Precision>
void EulerianSweeps<D, Precision>::force(const Particles &p, const NeighborRows &)
{
  with_form(pair_form(opt.viscosity), [&](auto form) {
    force_blocks<form()>(p);
  });
}

template <int D, class Precision>
template <PairForm FORM>
void EulerianSweeps<D, Precision>::force_blocks(const Particles &p)
{
  with_flag(opt.tensile, [&](auto tensile) {
    with_flag(uniform, [&](auto same) {
      each_block([&](int block, const Batch &batch, Totals &) {
        constexpr bool TENSILE = decltype(tensile)::value, UNIFORM = decltype(same)::value;
        add_forces_of_pairs<FORM, TENSILE>(p, block, batch,
                                           sum_pairs<FORM, TENSILE, UNIFORM>(block));
      });
    });
  });
}

// f_i = K_i sum_j K_j (T_i + T_j) g_ij - m_i sum_j m_j Pi_ij g_ij, g = F x_ij; T_i sum K_j g_ij comes last

template <int D, class Precision>
template <PairForm FORM, bool TENSILE, bool UNIFORM>
typename EulerianSweeps<D, Precision>::PairForces EulerianSweeps<D, Precision>::sum_pairs(int block)
{
  constexpr bool VISCOUS = FORM != PairForm::NONE, RATES = needs_rates(FORM);
  const Number *i = columns.at(block * LANES);
  const int first = pairs.first[block], count = pairs.count[block];
  const std::size_t first_pair = first * std::size_t(LANES);
  const int *further = pairs.further.data() + first;
  Neighbors neighbors(*this, block, 0, at_da, at_h, components());
  neighbors.ask_ahead(further, count);
  ask_for_slots(block);
  const std::ptrdiff_t next = kernel_gradients_ahead(block);
  const float *factors = pairs.factor.data() + first_pair;
  Number *pulls = pairs.pull.data() + first_pair, *crowds = pairs.crowd.data() + first_pair;
  const bool keep = keeps_pairs(), correct = needs_correction(), alone = correct && lonely,
             limits = this->limits_step, besides = keep || alone || limits;
  // of viscosity what is a constant where h is
  const double minus_a1 = -opt.a1 * (UNIFORM ? common_h : 1.0),
               twice_a2 = 2.0 * opt.a2 * (UNIFORM ? common_h * common_h : 1.0);
  const Motion own(*this, i);
  const Pack zero(0.0), one(1.0), same_softening(MU_EPSILON * common_h * common_h),
      rho = component(i, RHO), own_linear = minus_a1 * component(i, SOUND);
  Pack stress[D], g[D], crowded_g[D], pulled[D], whole[D], mu_least = zero;    // sums over pairs
  each_index<D>([&](auto a) {
    stress[a] = g[a] = crowded_g[a] = pulled[a] = whole[a] = zero;
  });

  for (int s = 0; s < count; s++) {
    const int k = s * LANES;
    const Number *j = neighbors(further[s]);
    prefetch(factors + k + next, LANES);
    const Parts d = own.from(j);
    const Pack F = Precision::load(factors + k), h = mean_h<UNIFORM>(i, j), h2 = h * h;
    Pack fn = zero;
    if (TENSILE) {
      const Pack spacing = (0.5 / opt.hbar) * (near_of<UNIFORM>(i) + near_of<UNIFORM>(j));
      fn = crowding<D>(square_root(d.x_dot_x()), h, spacing, opt.tensile_n);
      store(crowds + k, fn);
    }
    const Pack KF = component(j, K) * F, crowded_KF = fn * KF;
    each_index<D>([&](auto a) {
      Pack t = component(j, T + D * a) * d.x[0], r = zero;
      if (TENSILE) r = component(j, at_tension + D * a) * d.x[0];
      for (int b = 1; b < D; b++) {
        t = multiply_add(component(j, T + D * a + b), d.x[b], t);
        if (TENSILE) r = multiply_add(component(j, at_tension + D * a + b), d.x[b], r);
      }
      stress[a] = multiply_add(KF, t, stress[a]);
      g[a] = multiply_add(KF, d.x[a], g[a]);
      if (!TENSILE) return;
      stress[a] = multiply_add(crowded_KF, r, stress[a]);
      crowded_g[a] = multiply_add(crowded_KF, d.x[a], crowded_g[a]);
    });
    if (!VISCOUS) continue;

    const Pack on = needs_switch(FORM) ? 0.5 * (component(i, LAST) + component(j, LAST)) : one;
    Pack vr = d.v_dot_x();
    if (RATES)
      vr = jump_left<FORM>(vr, this->stretching(i, at_rate, d.x), this->stretching(j, at_rate, d.x),
                           on);
    const Pack softened = add_dot<D>(UNIFORM ? same_softening : MU_EPSILON * h2, d.x, d.x);
    Pack linear = multiply_add(component(j, SOUND), Pack(minus_a1), own_linear);
    if (!UNIFORM) linear *= h;
    const PairViscosity<Pack> viscosity(linear, UNIFORM ? Pack(twice_a2) : twice_a2 * h2,
                                        rho + component(j, RHO), vr, softened);
    Pack q = component(j, MASS) * F * viscosity.Pi;
    if (FORM == PairForm::SWITCHED) q *= on;
    if (besides) {
      if (keep) store(pulls + k, q);    // m_j Pi_ij F_ij h0^(D+2)
      if (alone) {
        const Pack left = Base::whole_pull(i, j, LAST, q);
        d.add_to(whole, left);
        q -= left;
      }
      if (limits) mu_least = minimum(mu_least, where_positive(-F, h * viscosity.approach, zero));
    }
    d.add_to(pulled, q);
  }

  PairForces sums;    // a copy: what has an address is kept in memory
  each_index<D>([&](auto a) {
    sums.stress[a] = stress[a];
    sums.g[a] = g[a];
    sums.crowded_g[a] = crowded_g[a];
    sums.pulled[a] = pulled[a];
    sums.whole[a] = whole[a];
  });
  sums.mu_least = mu_least;
  return sums;
}

// what is the particles' own: T_i, K_i, masses

template <int D, class Precision>
template <PairForm FORM, bool TENSILE>
void EulerianSweeps<D, Precision>::add_forces_of_pairs(const Particles &p, int block,
                                                       const Batch &batch, const PairForces &sums)
{
  const bool viscous = FORM != PairForm::NONE, correct = viscous && needs_correction();
  const Number *i = columns.at(block * LANES);
  this->ask_for(p.mass, batch);
  const Pack of_stress = unit_factor * component(i, K), of_mass = unit_factor * batch.load(p.mass);
  Pack f[D], acceleration[D];
  for (int a = 0; a < D; a++) {
    f[a] = sums.stress[a];
    for (int b = 0; b < D; b++) {
      f[a] = multiply_add(component(i, T + D * a + b), sums.g[b], f[a]);
      if (TENSILE)
        f[a] = multiply_add(component(i, at_tension + D * a + b), sums.crowded_g[b], f[a]);
    }
    f[a] *= of_stress;
    if (viscous) f[a] -= of_mass * (correct ? sums.whole[a] : sums.pulled[a]);
    acceleration[a] = -unit_factor * sums.pulled[a];
  }
  this->add_forces(p, batch, f);
  if (correct) {
    columns.store(block * LANES, at_da, acceleration, D);
    columns.copy_to_rows(block * LANES, at_da, at_da + D);
  }
  if (this->limits_step) store(&mu_max[block * LANES], -sums.mu_least);
}

}    // namespace

template <int D, class Precision>
std::unique_ptr<Sweeps> SPHSolid::eulerian_sweeps(const Options &o, const std::vector<TypeData> &t)
{
  return std::make_unique<EulerianSweeps<D, Precision>>(o, t);
}

#endif
