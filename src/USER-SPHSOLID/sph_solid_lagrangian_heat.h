/* ----------------------------------------------------------------------
   Heat and virial of the Lagrangian frame.  Members of LagrangianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_HEAT_H
#define LMP_SPH_SOLID_LAGRANGIAN_HEAT_H

#include "sph_solid_lagrangian.h"

namespace {

/* ----------------------------------------------------------------------
   heat on the way: the share of the velocities that come after the forces
------------------------------------------------------------------------- */

// pairs k to k + LANES - 1, d: motion of j less that of i

template <int D>
inline void LagrangianSweeps<D>::add_late_pairs(const int *j, int k, bool nearest,
                                                const Motion<D> *d, LateHeat &heat) const
{
  if (opt.hourglass > 0.0) {
    const Spread damped(load(&damp[k]));
    for (int m = 0; m < BLOCK; m++)
      heat.hourglass = multiply_add(damped[m], d[m].before(heat.drift).products(), heat.hourglass);
  }
  if (Base::heats_pairs()) {
    const Spread pulled(load(&pull[k]));
    for (int m = 0; m < BLOCK; m++)
      heat.viscous = multiply_add(pulled[m], d[m].before(heat.drift).products(), heat.viscous);
  }
  if (needs_correction() && nearest) {    // w_ij (da_i - da_j).(v_i - v_j + v'_i - v'_j)
    const Spread weight(load(&near_weight[k]));
    for (int m = 0; m < BLOCK; m++) {
      const Motion<D> kick = heat.kick - Motion<D>(Addresses(da.data(), j + m, da_stride));
      heat.corrected = multiply_add(weight[m], kick.products_less(d[m]), heat.corrected);
    }
  }
}

template <int D>
void LagrangianSweeps<D>::add_due_heat(const Particles &p, const NeighborRows &list)
{
  each_batch(list, [&](const typename Base::Batch &batch, int n, typename Base::Totals &totals) {
    Sums sums;
    for (int m = 0; m < LANES; m++) accumulate<true>(batch.i[m], sums, m);
    add_blocks<D>(sums.velocity);
    add_late_heat(p, batch, n, lanes_of<D>(sums.velocity), sums, totals);
  });
}

// what the last evaluation's forces do to the particles of a batch, of whom n count in totals,
// with the velocities of that evaluation plus these

template <int D>
void LagrangianSweeps<D>::add_late_heat(const Particles &p, const typename Base::Batch &batch,
                                        int n, const Tensor<D, Pack> &velocity, Sums &sums,
                                        typename Base::Totals &totals) const
{
  for (int m = 0; m < n; m++) {
    const int i = batch.i[m];
    if (needs_correction()) {
      const double lone = Base::lonely_power(
          i,
          [&](int j, int a) {
            return early_v(i)[a] - early_v(j)[a] + (u(i)[a] - u(j)[a]);
          },
          [&](int j, int a) {
            return kin(i)[a] - kin(j)[a] - this->due.drift * (u(i)[a] - u(j)[a]);
          });
      totals.standard += lone + Base::standard_power(i, early_v(i)) + Base::standard_power(i, u(i));
      sums.viscous[m] += lone;
    }
    totals.viscous += sums.viscous[m];
    totals.hourglass += sums.hourglass[m];
  }
  for (int m = n; m < LANES; m++) {    // the last one again
    sums.viscous[m] = sums.viscous[n - 1];
    sums.hourglass[m] = sums.hourglass[n - 1];
  }
  Several<D> rows[BLOCK];
  for (int m = 0; m < BLOCK; m++)
    rows[m] = load_tensor<D>(batch.rows(srow.data(), m, stress_stride) + Str::T);
  const Pack V0 = batch.load(p.vref);
  const Pack power = batch.load(early.data()) +
      V0 * velocity.cwiseProduct(lanes_of<D>(rows)).sum() + load(sums.viscous) +
      load(sums.hourglass);
  batch.store(p.e, batch.load(p.e) + this->due.factor * power / batch.load(p.mass));
}

/* ----------------------------------------------------------------------
   heat of a sweep of its own
------------------------------------------------------------------------- */

// stress: V0_i T_i : sum_j V0_j (u_j - u_i) (x) g, exact adjoint of the force

template <int D>
void LagrangianSweeps<D>::heat(const Particles &, const NeighborRows &list, double *heat, bool book)
{
  with_flags(Base::heats_pairs(), opt.hourglass > 0.0, [&](auto pull, auto damp) {
    Base::sum_heat(list, heat, book, [this](int i) {
      return pair_power<decltype(pull)::value, decltype(damp)::value>(i);
    });
  });
}

template <int D>
template <bool PULL, bool DAMP>
typename SweepsBase<D, LagrangianRow<D>>::Power LagrangianSweeps<D>::pair_power(int i) const
{
  const double *kall = krow.data();
  const Motion<D> own(kin(i));
  const Pack Xi = load_block(kin(i) + Kin::REFERENCE);
  Several<D> gradient = Several<D>::zero();
  Pack viscous(0.0), hourglass(0.0);
  for (int k = pairs.first[i], end = k + pairs.count[i]; k < end; k += LANES) {
    const int *j = &pairs.j[k];
    prefetch_pairs(k);
    if (DAMP) prefetch(damp.data() + k + PAIRS_AHEAD, LANES);
    const Pack F = load(&pairs.factor[k]);
    const Spread factor(F), pulled(PULL ? load(&pull[k]) : F), damped(DAMP ? -load(&damp[k]) : F);
    for (int m = 0; m < BLOCK; m++) {
      const Addresses kj(kall, j + m, Kin::STRIDE);
      const Motion<D> d = Motion<D>(kj) - own;
      const Pack X = Xi - load(kj + Kin::REFERENCE);
      add_outer(gradient, d.expanded_v(), spread<D>(X) * factor[m]);
      if (PULL) viscous = multiply_add(pulled[m], d.products(), viscous);
      if (DAMP) hourglass = multiply_add(damped[m], d.products(), hourglass);
    }
  }
  const double V0 = kin(i)[Kin::VOLUME];
  return {V0 * contract(gradient, load_tensor<D>(str(i))), 0.5 * V0 * Motion<D>::v_dot_x(viscous),
          0.5 * V0 * Motion<D>::v_dot_x(hourglass)};
}

template <int D>
void LagrangianSweeps<D>::virial(const Particles &, const NeighborRows &list, double *six)
{
  const double *sall = srow.data(), *Xall = krow.data() + Kin::REFERENCE;
  const double *factor = pairs.factor.data();
  const double *damping = opt.hourglass > 0.0 ? damp.data() : nullptr;
  const int *neighbor = pairs.j.data(), stride = stress_stride;
  const bool pulls = keeps_pairs();
  Base::sum_virial(list, six, [=](int i) {
    const double V0 = kin(i)[Kin::VOLUME];
    const Several<D> T = load_tensor<D>(str(i));
    const Pack Xi = load_block(kin(i) + Kin::REFERENCE);
    return [=](int k, const Motion<D> &d) {
      const double *sj = sall + static_cast<std::int64_t>(neighbor[k]) * stride;
      const Pack X = Xi - load_block(Xall + static_cast<std::int64_t>(neighbor[k]) * Kin::STRIDE);
      const Several<D> g = spread<D>(X) * Pack(V0 * factor[k]);
      const double central = (damping ? V0 * damping[k] : 0.0) - (pulls ? whole_pull(i, k) : 0.0);
      return expanded<D>(times(T + load_tensor<D>(sj), g)) + Pack(central) * d.expanded_x();
    };
  });
}

}    // namespace

#endif
