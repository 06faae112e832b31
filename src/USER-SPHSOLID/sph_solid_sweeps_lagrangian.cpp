/* ----------------------------------------------------------------------
   The sweeps of the Lagrangian frame: velocity gradients with the constitutive
   update, and forces; see sph_solid_lagrangian.h.
------------------------------------------------------------------------- */

#include "sph_solid_lagrangian.h"
#include "sph_solid_lagrangian_heat.h"
#include "sph_solid_lagrangian_partners.h"

#include <atomic>

namespace {

/* ----------------------------------------------------------------------
   gradient sweep
------------------------------------------------------------------------- */

template <int D>
template <bool LATE>
void LagrangianSweeps<D>::accumulate(int i, Sums &sums, int lane) const
{
  const double *kall = krow.data();
  const Motion<D> own(kin(i));
  const Pack Xi = load_block(kin(i) + Kin::REFERENCE);
  Several<D> displacement = Several<D>::zero(), velocity = Several<D>::zero();
  LateHeat heat;
  const int start = pairs.first[i], end_nearest = start + pairs.nearest[i];
  if (LATE) {
    heat.drift = Motion<D>::drift_of(this->due.drift);
    heat.viscous = heat.corrected = heat.hourglass = Pack(0.0);
    if (needs_correction()) heat.kick = Motion<D>(&da[i * da_stride]);
  }

  for (int k = start, end = start + pairs.count[i]; k < end; k += LANES) {
    const int *j = &pairs.j[k];
    prefetch_pairs(k);
    if (LATE) prefetch(damp.data() + k + PAIRS_AHEAD, LANES);
    const Spread factor(load(&pairs.factor[k]));
    Motion<D> d[BLOCK];
    for (int m = 0; m < BLOCK; m++) {
      const Addresses kj(kall, j + m, Kin::STRIDE);
      d[m] = Motion<D>(kj) - own;
      const Pack X = Xi - load(kj + Kin::REFERENCE);
      const Several<D> g = spread<D>(X) * factor[m];          // V0_j g_ij
      add_outer(displacement, d[m].expanded_x_plus(X), g);    // x_j - x_i + X_i - X_j = u_j - u_i
      add_outer(velocity, d[m].expanded_v(), g);
    }
    if (LATE) add_late_pairs(j, k, k < end_nearest, d, heat);
  }
  sums.displacement[lane] = displacement;
  sums.velocity[lane] = velocity;
  if (!LATE) return;
  const double half = 0.5 * kin(i)[Kin::VOLUME];
  sums.viscous[lane] = half * Motion<D>::v_dot_x(heat.viscous) -
      0.25 * kin(i)[Kin::MASS] * Motion<D>::v_dot_x(heat.corrected);
  sums.hourglass[lane] = -half * Motion<D>::v_dot_x(heat.hourglass);
}

template <int D>
int LagrangianSweeps<D>::gradient(const Particles &p, const NeighborRows &list, double dt)
{
  std::atomic<int> bad(-1);
  each_batch(list, [&](const typename Base::Batch &batch, int n, typename Base::Totals &totals) {
    const bool late = this->due.factor > 0.0;
    const int unphysical = late ? update<true>(p, batch, n, dt, totals)
                                : update<false>(p, batch, n, dt, totals);
    if (unphysical >= 0) bad = unphysical;
  });
  return bad;
}

// call(batch, particles of it that count, totals of the heat that is due); after it nothing is due

template <int D>
template <class Call>
void LagrangianSweeps<D>::each_batch(const NeighborRows &list, Call call)
{
  double plastic = 0.0, viscous = 0.0, standard = 0.0, hourglass = 0.0;
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads) \
    reduction(+ : plastic, viscous, standard, hourglass)
#endif
  for (int first = 0; first < list.inum; first += LANES) {
    typename Base::Totals t;
    call(typename Base::Batch(list, first), std::min(LANES, list.inum - first), t);
    plastic += t.plastic;
    viscous += t.viscous;
    standard += t.standard;
    hourglass += t.hourglass;
  }
  Base::enter(early_totals, this->due.factor);
  Base::enter({plastic, viscous, standard, hourglass}, this->due.factor);
  early_totals = {};
  this->due = {};
}

// constitutive update of a batch and what their neighbors read; the
// index of one whose state is not physical, or -1

template <int D>
template <bool LATE>
int LagrangianSweeps<D>::update(const Particles &p, const typename Base::Batch &batch, int n,
                                double dt, typename Base::Totals &totals)
{
  Base::prefetch_points(p, batch);
  const std::ptrdiff_t next = (batch.i[0] + LANES) * static_cast<std::ptrdiff_t>(TENSOR);
  prefetch(B.data() + next, LANES * TENSOR);
  Sums sums;
  for (int m = 0; m < LANES; m++) accumulate<LATE>(batch.i[m], sums, m);
  add_blocks<D>(sums.displacement);
  add_blocks<D>(sums.velocity);
  Several<D> own[BLOCK];
  for (int m = 0; m < BLOCK; m++) own[m] = load_tensor<D>(batch.rows(B.data(), m, TENSOR));

  using Tensors = Tensor<D, Pack>;
  const Tensors correction = lanes_of<D>(own);
  const Tensors Fi = Tensors::Identity() + lanes_of<D>(sums.displacement) * correction;
  const Tensors velocity = lanes_of<D>(sums.velocity), rate = velocity * correction;
  if (!viscous()) {
    from_lanes<D>(Fi, own);
    for (int m = 0; m < BLOCK; m++) store_tensor(batch.rows(F.data(), m, TENSOR), own[m]);
  }

  if (LATE) add_late_heat(p, batch, n, velocity, sums, totals);

  Tensors L = Tensors::Zero();
  if (dt > 0.0) L = rate * Tensors(Fi - Pack(0.5 * dt) * rate).inverse();
  const auto points = Base::update_points(p, batch, L, dt);
  totals.plastic += Base::sum_of_first(points.plastic_work, n);

  const Pack rho = points.state.rho, V0 = batch.load(p.vref), J = batch.load(p.mass) / (rho * V0);
  const Tensors inverse = Fi.inverse(), C = J * inverse.transpose() * correction.transpose();
  const Pack h = Base::of_types(p, batch, [&](int t) {
    return types[t].h;
  });
  Pack impedance = 0.0;
  if (keeps_rates(opt)) {
    const Pack shear = Base::of_types(p, batch, [&](int t) {
      return types[t].material.shear;
    });
    impedance =
        rho * h * square_root(maximum(points.eos.c2, Pack(0.0)) + 4.0 * shear / (3.0 * rho));
  }
  Pack last = batch.load(nsum.data());
  if (needs_switch(pair_form(opt.viscosity)))
    last = Base::own_switch(rate * inverse, square_root(maximum(points.eos.c2, Pack(0.0))), h);
  const Tensors T = points.sigma * C;
  if (this->keeps_heat) batch.store(early.data(), V0 * velocity.cwiseProduct(T).sum());
  Base::write_rows(batch, points, T, impedance, last);
  if (viscous()) Base::write_tensors(batch, at_C(), C);
  if (keeps_rates(opt)) Base::write_tensors(batch, at_rate(), rate);
  return Base::unphysical(batch, rho, points.eos.P + points.state.S.sum() + C.sum());
}

template <int D> void LagrangianSweeps<D>::find_switch(const Particles &p, const NeighborRows &list)
{
  Base::sum_switch(p, list, at_rate(), [&](int i, int k, const Motion<D> &) {
    const Addresses Xj(krow.data() + Kin::REFERENCE, &pairs.j[k], Kin::STRIDE);
    return spread<D>(load_block(kin(i) + Kin::REFERENCE) - load(Xj));
  });
}

/* ----------------------------------------------------------------------
   force sweep
------------------------------------------------------------------------- */

template <int D> void LagrangianSweeps<D>::force(const Particles &p, const NeighborRows &list)
{
  with_form(pair_form(opt.viscosity), [&](auto form) {
    if (opt.hourglass > 0.0)
      force_rows<form(), true>(p, list);
    else
      force_rows<form(), false>(p, list);
  });
}

template <int D>
template <PairForm FORM, bool HOURGLASS>
void LagrangianSweeps<D>::force_rows(const Particles &p, const NeighborRows &list)
{
  const bool heat = this->keeps_heat, viscous_heat = Base::heats_pairs();
  double viscous = 0.0, hourglass = 0.0;
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads) reduction(+ : viscous, hourglass)
#endif
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    const typename Base::Power power = force_row<FORM, HOURGLASS>(p, i);
    if (FORM != PairForm::NONE && lonely) Base::lonely_pairs(p, i);
    if (!heat) continue;
    if (needs_correction())
      for (int a = 0; a < D; a++) da[i * da_stride + VECTOR + a] = kin(i)[Kin::V + a];
    const double q = viscous_heat ? power.viscous : 0.0;
    early[i] += q + power.hourglass;
    viscous += q;
    hourglass += power.hourglass;
  }
  early_totals.viscous += viscous;
  early_totals.hourglass += hourglass;
}

// f_i = V0_i sum_j V0_j [(T_i + T_j) g_ij - Pi_ij G_ij x_ij] + hourglass.
// viscosity: central, Pi = rho mu (a2 mu - a1 c) with eq. 24's mu at the
// reference distance, G = min(0, x.(C_i+C_j)g/2)/x^2 the kernel gradient along x.
// hourglass: c rho c_L h w_ij nu_ij with nu_ij the part along x_ij of
// v_ij - (F'_i+F'_j)/2 X_ij, which no linear field contains, and
// w_ij = -g_ij.X_ij/X_ij^2

template <int D>
template <PairForm FORM, bool HOURGLASS>
typename SweepsBase<D, LagrangianRow<D>>::Power LagrangianSweeps<D>::force_row(const Particles &p,
                                                                               int i)
{
  constexpr bool VISCOUS = FORM != PairForm::NONE, BOTH = needs_rates(FORM),
                 RATES = BOTH || HOURGLASS;
  constexpr int C_AT = extra(0), R_AT = extra(VISCOUS ? 1 : 0),
                STRIDE = extra((VISCOUS ? 1 : 0) + (RATES ? 1 : 0));    // of a stress row
  const double *kall = krow.data(), *sall = srow.data(), *si = sall + std::ptrdiff_t(i) * STRIDE;
  const double *near = nearness.data(), *factors = pairs.factor.data();
  double *damping = damp.data(), *pulls = pull.data();
  const Motion<D> own(kin(i));
  const Pack Xi = load_block(kin(i) + Kin::REFERENCE);
  const Several<D> T = load_tensor<D>(si), C = load_tensor<D>(VISCOUS ? si + C_AT : si),
                   rate = load_tensor<D>(RATES ? si + R_AT : si);
  const bool keep = keeps_pairs(), correct = needs_correction();
  // in a correction, pairs that touch a particle without nearest neighbors
  // are left to lonely_pairs()
  const Pack zero(0.0), ok_i(!correct || si[Str::NSUM] > 0.0 ? 1.0 : 0.0);
  const double a1 = opt.a1, a2 = opt.a2, damping_share = 0.5 * opt.hourglass;
  Pack stress = zero, viscous[D], hourglass[D], mu_least = zero;
  Pack viscous_power = zero, hourglass_power = zero;
  for (int a = 0; a < D; a++) viscous[a] = hourglass[a] = zero;

  for (int k = pairs.first[i], end = k + pairs.count[i]; k < end; k += LANES) {
    const int *j = &pairs.j[k];
    Motion<D> d[BLOCK];
    Pack along[BLOCK], l_i[BLOCK], l_j[BLOCK], state[BLOCK];    // lanes yet to be summed
    prefetch_pairs(k);
    if (VISCOUS) prefetch(near + k + PAIRS_AHEAD, LANES);
    if (HOURGLASS) prefetch(damping + k + PAIRS_AHEAD, LANES);
    const Pack F = load(factors + k);
    const Spread factor(F);
    for (int m = 0; m < BLOCK; m++) {
      const Addresses kj(kall, j + m, Kin::STRIDE), sj(sall, j + m, STRIDE);
      const Several<D> X = spread<D>(Xi - load(kj + Kin::REFERENCE));
      stress = multiply_add(factor[m], times(T + load_tensor<D>(sj), X), stress);
      if (!VISCOUS && !HOURGLASS) continue;
      d[m] = own - Motion<D>(kj);
      const Pack x = d[m].expanded_x();
      state[m] = load(sj + Str::K);
      if (VISCOUS) along[m] = x * times(C + load_tensor<D>(sj + C_AT), X);
      if (BOTH) {
        l_i[m] = x * times(rate, X);
        l_j[m] = x * times(load_tensor<D>(sj + R_AT), X);
      } else if (RATES)
        l_i[m] = x * times(rate + load_tensor<D>(sj + R_AT), X);
    }
    if (!VISCOUS && !HOURGLASS) continue;

    const Components<D> apart = Motion<D>::components(d);
    const Pack r2 = apart.x_dot_x(), vr = apart.v_dot_x(), inv_r2 = 1.0 / r2;
    transpose(state[0], state[1], state[2], state[3]);    // K, rho, c, nsum or switch
    Pack li = zero, lj = zero;    // their sum counts, and for some viscosities each of them
    if (RATES) li = sums(l_i[0], l_i[1], l_i[2], l_i[3]);
    if (BOTH) lj = sums(l_j[0], l_j[1], l_j[2], l_j[3]);
    if (HOURGLASS) {
      const Pack impedance = damping_share * (si[Str::K] + state[0]);
      const Pack s = impedance * F * (vr - 0.5 * (li + lj)) * inv_r2;
      store(damping + k, s);
      hourglass_power = multiply_add(s, vr, hourglass_power);
      apart.add_to(hourglass, s);
    }
    if (VISCOUS) {
      const Pack on = needs_switch(FORM) ? 0.5 * (si[Str::SWITCH] + state[3]) : Pack(1.0);
      const Pack jump = jump_left<FORM>(vr, li, lj, on);
      const Pack mu = minimum(jump, zero) * load(near + k) * square_root(r2) * inv_r2;
      const Pack rho = 0.5 * (si[Str::RHO] + state[1]), c = 0.5 * (si[Str::C] + state[2]);
      Pack Pi = rho * mu * (a2 * mu - a1 * c);
      if (FORM == PairForm::SWITCHED) Pi *= on;
      const Pack G = 0.5 * F * sums(along[0], along[1], along[2], along[3]);
      Pack s = Pi * minimum(G, zero) * inv_r2;    // V0_j Pi G
      if (keep) {
        store(pulls + k, s);
        viscous_power = multiply_add(s, vr, viscous_power);
      }
      if (correct) s = where_positive(state[3], ok_i * s, zero);
      apart.add_to(viscous, -s);
      mu_least = minimum(mu_least, mu);
    }
  }

  const double V0 = kin(i)[Kin::VOLUME], per_mass = V0 / kin(i)[Kin::MASS];
  stress = sum_of_blocks(stress);
  const Pack viscous_sum = sums_of<D>(viscous), hourglass_sum = sums_of<D>(hourglass);
  for (int a = 0; a < D; a++) {
    p.f[i][a] += V0 * (folded<D>(stress, a) + hourglass_sum[a]);
    if (VISCOUS && correct)
      da[i * da_stride + a] = per_mass * viscous_sum[a];
    else if (VISCOUS)
      p.f[i][a] += V0 * viscous_sum[a];
  }
  mu_max[i] = -least(mu_least);
  return {0.0, 0.5 * V0 * sum(viscous_power), -0.5 * V0 * sum(hourglass_power)};
}

}    // namespace

/* ---------------------------------------------------------------------- */

template <int D>
std::unique_ptr<Sweeps> SPHSolid::lagrangian_sweeps(const Options &o,
                                                    const std::vector<TypeData> &t)
{
  return std::make_unique<LagrangianSweeps<D>>(o, t);
}

template std::unique_ptr<Sweeps> SPHSolid::lagrangian_sweeps<2>(const Options &,
                                                                const std::vector<TypeData> &);
template std::unique_ptr<Sweeps> SPHSolid::lagrangian_sweeps<3>(const Options &,
                                                                const std::vector<TypeData> &);
