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

#include "sph_solid_eulerian.h"
#include "sph_solid_eulerian_heat.h"
#include "sph_solid_eulerian_rows.h"
#include "sph_solid_eulerian_viscous.h"
#include "sph_solid_tensile.h"

#include <atomic>

namespace {

// who sees too little of its surroundings to correct anything has B = 1, beyond_share().  Corners, edges
// and bars of two particles have 0.41 or more, up to h = 2 spacings, and turn without being strained; with
// 0.1 fragments of a torn foot are corrected, too, until a step changes their density by more than it is
constexpr double LEAST_ROUNDNESS = 0.4;

// and so has who is about to lose its neighbors, which the correction would hold on to until the end of
// the kernel: the mean of M's diagonal is 1 inside a body and 2^-D in a corner of half cells
template <int D> constexpr double LEAST_MOMENT = 0.8 / (1 << D);

/* ----------------------------------------------------------------------
   gradient sweep
------------------------------------------------------------------------- */

// neighbors inside the kernel: the nearest ones, in their row, and the others; distances of all
// pairs of a batch, and where smoothing lengths differ these, too; where the next row begins

template <int D> struct EulerianSweeps<D>::Scratch {
  struct Found {
    int *j;
    double *r2, *h;    // h: of pairs; not where there is one for all
    int n;
    void add(int neighbor, double r2_of, double h_of, bool uniform)
    {
      j[n] = neighbor;
      r2[n] = r2_of;
      if (!uniform) h[n] = h_of;
      n++;
    }
    // some of as many as there are lanes; room for as many more behind the last one
    void add(const int *neighbors, Pack r2_of, Pack wanted)
    {
      n += collect_positive(wanted, neighbors, r2_of, j + n, r2 + n);
    }
    void add(const Found &others, bool uniform)
    {
      for (int k = 0; k < others.n; k++) j[n + k] = others.j[k];
      for (int k = 0; k < others.n; k++) r2[n + k] = others.r2[k];
      for (int k = 0; !uniform && k < others.n; k++) h[n + k] = others.h[k];
      n += others.n;
    }
  };
  Found near, far;
  int first, near_first, first_of_batch;
  Rows distance, length;    // of a batch: r^2, then r; h

  // room: of the largest batch
  Scratch(int begin, int room, bool uniform) :
      first(begin), near_first(begin), first_of_batch(begin), distance(room),
      length(uniform ? 0 : room), far_j(room), far_r2(room), far_h(uniform ? 0 : room)
  {
  }
  void begin(int *j)
  {
    const int at = first - first_of_batch;
    near = {j + first, distance.data() + at, length.data() + at, 0};
    far = {far_j.data(), far_r2.data(), far_h.data(), 0};
  }

 private:
  std::vector<int> far_j;
  std::vector<double> far_r2, far_h;
};

// of a pair with so large a sum of smoothing lengths

inline double reach_of(double sum_of_h)
{
  return 0.5 * SUPPORT * sum_of_h;
}

// append those of a candidate list that are inside the kernel

template <int D>
template <bool UNIFORM, bool IMAGES>
void EulerianSweeps<D>::gather(int i, int n, const int *list, Scratch &s) const
{
  const double *kall = krow.data(), *ri = kin(i);
  // copies, which the compiler need not read again after each store
  typename Scratch::Found near = s.near, far = s.far;
  const double own_h = h_of<UNIFORM>(ri), own_near = near_of<UNIFORM>(ri);
  double x[D];
  std::copy(ri + Kin::X, ri + Kin::X + D, x);
  int jj = 0;
  if constexpr (COLLECTS_LANES && D == 3 && UNIFORM && !IMAGES) {    // rows are long
    const Pack own = load_block(ri), reach2(reach_of(2.0 * own_h) * reach_of(2.0 * own_h)),
               support2(own_near * own_near);
    for (; jj + LANES <= n; jj += LANES) {
      int j[LANES];
      for (int m = 0; m < LANES; m++) j[m] = list[jj + m] & INDEX_MASK;
      Pack d[BLOCK];
      for (int m = 0; m < BLOCK; m++)
        d[m] = own - load(Addresses(kall, j + m, stride_of<UNIFORM>()));
      transpose(d[0], d[1], d[2], d[3]);
      Pack r2 = d[0] * d[0];
      for (int a = 1; a < D; a++) r2 = multiply_add(d[a], d[a], r2);
      near.add(j, r2, support2 - r2);
      far.add(j, r2, where_positive(support2 - r2, Pack(-1.0), reach2 - r2));
    }
  }
  for (; jj < n; jj++) {
    const int j = list[jj] & INDEX_MASK;
    const double *rj = kall + static_cast<std::ptrdiff_t>(j) * stride_of<UNIFORM>();
    double r2 = (x[0] - rj[0]) * (x[0] - rj[0]);
    for (int a = 1; a < D; a++) r2 = multiply_add(x[a] - rj[a], x[a] - rj[a], r2);
    const double two_h = own_h + (UNIFORM ? own_h : rj[Kin::H]), reach = reach_of(two_h);
    const double support = 0.5 * (own_near + (UNIFORM ? own_near : rj[Kin::NEAR]));
    if (IMAGES && r2 < COINCIDE * COINCIDE * two_h * two_h) continue;    // itself
    if (r2 < support * support)
      near.add(j, r2, 0.5 * two_h, UNIFORM);
    else if (r2 < reach * reach)
      far.add(j, r2, 0.5 * two_h, UNIFORM);
  }
  s.near = near;
  s.far = far;
}

// the pairs of one particle, nearest ones first

template <int D>
template <bool UNIFORM>
void EulerianSweeps<D>::find_pairs(int i, const NeighborRows &list, Scratch &s)
{
  const int of_images = images_of(i);
  s.begin(pairs.j.data());
  gather<UNIFORM, false>(i, list.numneigh[i], list.firstneigh[i], s);
  if (of_images > 0) gather<UNIFORM, true>(i, of_images, &image_j[image_first[i]], s);

  const int nearest = s.near.n;
  s.near.add(s.far, UNIFORM);
  pairs.first[i] = s.first;
  pairs.near_first[i] = needs_correction() ? s.near_first : 0;
  pairs.count[i] = s.near.n;
  pairs.nearest[i] = needs_correction() ? nearest : 0;
  s.first += s.near.n;
  s.near_first += whole_vectors(pairs.nearest[i]);
}

// kernel gradients of the pairs of a batch, and r in place of r^2: grad_i W = F (x_i - x_j), stored is
// F h0^(D+2).  A short loop of its own, so that the processor has many roots and divisions on the way

template <int D> template <bool UNIFORM> void EulerianSweeps<D>::find_factors(Scratch &s)
{
  const double per_unit = 1.0 / unit_factor;
  const Pack same_h(common_h);
  float *factors = pairs.factor.data() + s.first_of_batch;
  double *distance = s.distance.data();
  const double *length = s.length.data();
  for (int k = 0; k < s.first - s.first_of_batch; k += LANES) {
    const Pack r = square_root(load(distance + k)), h = UNIFORM ? same_h : load(length + k);
    store_rounded(factors + k, per_unit * CubicSpline<D>::gradient_factor(r, h));
    store(distance + k, r);
  }
}

// sums over the pairs of one particle

template <int D>
template <bool UNIFORM>
void EulerianSweeps<D>::accumulate(int i, const Scratch &s, Sums &sums, int lane)
{
  const double *kall = krow.data(), *ki = kin(i);
  const Motion<D> own(ki);
  const int start = pairs.first[i], count = pairs.count[i], nearest = pairs.nearest[i];
  const int *neighbors = pairs.j.data() + start;
  const float *factors = pairs.factor.data() + start;
  const double *distance = s.distance.data() + (start - s.first_of_batch);
  double *weights = near_weight.data() + pairs.near_first[i];
  TensorSums<D> moment, velocity;
  const Pack own_near(near_of<UNIFORM>(ki));
  Pack nsum = 0.0;

  for (int k = 0; k < count; k += LANES) {
    const int *j = neighbors + k;
    Motion<D> d[BLOCK];
    Pack inertia[BLOCK];
    for (int m = 0; m < BLOCK; m++) {
      const Addresses kj(kall, j + m, stride_of<UNIFORM>());
      d[m] = own - Motion<D>(kj);
      if (D == 2 || !UNIFORM) inertia[m] = load(kj + Kin::LENGTHS);
    }
    if (D == 2 || !UNIFORM) transpose(inertia[0], inertia[1], inertia[2], inertia[3]);
    const Components<D> apart = Motion<D>::components(d);
    const Pack near = UNIFORM ? own_near : inertia[Kin::H_LANE + 1];
    const Pack mass = D == 2 ? inertia[0] : -apart.free[1];
    const Pack F = load(factors + k) * first_lanes(count - k);
    const Pack w = (D == 2 ? -inertia[1] : apart.free[0]) * F;
    Pack g[D];
    for (int a = 0; a < D; a++) g[a] = w * apart.x[a];
    moment.add_symmetric(apart.x, g);
    velocity.add(apart.v, g);
    if (k < nearest) {
      const Pack m_wbar =
          Base::wbar_mass(load(distance + k), mass, own_near, near) * first_lanes(nearest - k);
      store(weights + k, m_wbar);
      nsum += m_wbar;
    }
  }
  sums.moment[lane] = moment.symmetric_blocks();
  sums.velocity[lane] = velocity.blocks();
  sums.nsum[lane] = sum(nsum);
}

// of a batch

template <int D>
template <bool UNIFORM>
void EulerianSweeps<D>::find_sums(const Batch &batch, const NeighborRows &list, Scratch &s,
                                  Sums &sums)
{
  s.first_of_batch = s.first;
  for (int m = 0; m < batch.n; m++) find_pairs<UNIFORM>(batch.i[m], list, s);
  find_factors<UNIFORM>(s);
  // what the last vector of the last row reads behind it
  std::fill_n(&pairs.j[s.first], LANES, batch.i[0]);
  std::fill_n(&pairs.factor[s.first], LANES, 0.0f);
  for (int m = 0; m < LANES; m++) accumulate<UNIFORM>(batch.i[m], s, sums, m);
}

template <int D>
int EulerianSweeps<D>::gradient(const Particles &p, const NeighborRows &list, double dt)
{
  std::atomic<int> bad(-1);
  auto of_share = [&](int first, int end) {
    double plastic = 0.0;
    Scratch s(first < end ? pairs.begin[first] : 0, pairs.most, uniform);
    for (int at = first * LANES; at < end * LANES; at += LANES) {
      const Batch batch(list, at);
      prefetch_points(p, batch);
      Sums sums;
      if (uniform)
        find_sums<true>(batch, list, s, sums);
      else
        find_sums<false>(batch, list, s, sums);
      const int unphysical = update(p, batch, sums, dt, plastic);
      if (unphysical >= 0) bad = unphysical;
    }
    return plastic;
  };
  const int batches = whole_vectors(list.inum) / LANES;
  this->ledger.plastic_work +=
      join_shares(nthreads, batches, 0.0, of_share, [](double &sum, double share) {
        sum += share;
      });
  return bad;
}

// constitutive update of a batch and what their neighbors
// read; the index of one whose state is not physical, or -1

template <int D>
int EulerianSweeps<D>::update(const Particles &p, const Batch &batch, Sums &sums, double dt,
                              double &plastic)
{
  using Tensors = Tensor<D, Pack>;
  const PairForm form = pair_form(opt.viscosity);
  add_blocks<D>(sums.moment);
  add_blocks<D>(sums.velocity);
  const Tensors moment = lanes_of<D>(sums.moment), velocity = lanes_of<D>(sums.velocity);
  Tensors B = Tensors::Identity(), exact = B;    // exact: for linear fields
  if (opt.corrected || needs_rates(form) || needs_switch(form)) {
    const Pack enough = minimum(beyond_share<D>(moment, LEAST_ROUNDNESS),
                                moment.trace() * (1.0 / D) - Pack(LEAST_MOMENT<D>));
    const Tensors inverse = moment.inverse();
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) exact(a, b) = where_positive(enough, inverse(a, b), exact(a, b));
  }
  if (opt.corrected) B = exact;
  // what tells a linear field from a jump needs the exact one, with gradient plain too
  const Tensors rate = velocity * exact;
  Tensors L = Tensors::Zero();
  if (dt > 0.0) L = midpoint_velocity_gradient<D, Pack>(opt.corrected ? rate : velocity, dt);
  const auto points = Base::update_points(p, batch, L, dt);
  plastic += Base::sum_of_first(points.plastic_work, batch.n);

  const Pack rho = points.state.rho, inv_rho2 = 1.0 / (rho * rho);
  const Pack mass = batch.load(p.mass);
  auto weighted = [&](const Tensors &sigma) {
    return opt.corrected ? Tensors(sigma * B.transpose()) : Tensors(sigma * inv_rho2);
  };
  Pack last = load(sums.nsum);
  if (needs_switch(form))
    last = Base::own_switch(rate, square_root(maximum(points.eos.c2, Pack(0.0))),
                            Base::smoothing_lengths(p, batch));
  write_rows(batch, points, weighted(points.sigma), opt.corrected ? mass / rho : mass, last);
  if (needs_rates(form)) write_tensors(batch, at_rate(), rate);
  if (opt.tensile) write_tensors(batch, extra(0), weighted(tension_stress(points.sigma)));
  return Base::unphysical(batch, rho, points.eos.P + points.state.S.sum() + moment.sum());
}

// artificial stress of a batch, one particle after the other: eigenvalues

template <int D>
Tensor<D, Pack> EulerianSweeps<D>::tension_stress(const Tensor<D, Pack> &sigma) const
{
  Tensor<D> R[LANES];
  for (int m = 0; m < LANES; m++)
    R[m] = artificial_stress<D>(of_lane<D>(sigma, m), opt.tensile_eps);
  Tensor<D, Pack> out;
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++)
      out(a, b) = pack_of([&](int m) {
        return R[m](a, b);
      });
  return out;
}

/* ----------------------------------------------------------------------
   force sweep
------------------------------------------------------------------------- */

template <int D> void EulerianSweeps<D>::force(const Particles &p, const NeighborRows &list)
{
  with_form(pair_form(opt.viscosity), [&](auto form) {
    force_rows<form()>(p, list);
  });
}

template <int D>
template <PairForm FORM>
void EulerianSweeps<D>::force_rows(const Particles &p, const NeighborRows &list)
{
  each_share(nthreads, list.inum, [&](int first, int end) {
    with_flags(
        [&](auto tensile, auto same) {
          for (int ii = first; ii < end; ii++) {
            const int i = list.ilist[ii];
            force_row<FORM, decltype(tensile)::value, decltype(same)::value>(p, i);
            if (FORM != PairForm::NONE && lonely) lonely_pairs(p, i);
          }
        },
        opt.tensile, uniform);
  });
}

// f_i = K_i sum_j K_j (T_i + T_j) g_ij - m_i sum_j m_j Pi_ij g_ij, g = F x_ij

template <int D>
template <PairForm FORM, bool TENSILE, bool UNIFORM>
void EulerianSweeps<D>::force_row(const Particles &p, int i)
{
  constexpr bool VISCOUS = FORM != PairForm::NONE, RATES = needs_rates(FORM);
  constexpr int R_AT = extra(0), L_AT = extra(TENSILE ? 1 : 0),    // R, velocity gradient
      STRIDE = extra((TENSILE ? 1 : 0) + (RATES ? 1 : 0));         // of a stress row
  const double *kall = krow.data(), *sall = srow.data();
  const int first = pairs.first[i], nearest = pairs.nearest[i];
  const int *neighbors = pairs.j.data() + first;
  const float *factors = pairs.factor.data() + first;
  const double *ki = kin(i), *si = sall + std::ptrdiff_t(i) * STRIDE;
  double *pulls = pull.data() + first, *crowds = crowd.data() + first,
         *weights = near_weight.data() + pairs.near_first[i];
  const double a1 = opt.a1, a2 = opt.a2;
  const Motion<D> own(ki);
  const Several<D> T = load_tensor<D>(si), R = load_tensor<D>(TENSILE ? si + R_AT : si),
                   rate = load_tensor<D>(RATES ? si + L_AT : si);
  const bool keep = keeps_pairs(), correct = needs_correction();
  // in a correction, pairs that touch a particle without nearest neighbors
  // are left to lonely_pairs()
  const Pack zero(0.0), ok_i(!correct || si[Str::NSUM] > 0.0 ? 1.0 : 0.0);
  Pack stress = zero, viscous[D], mu_least = zero;    // sums over pairs
  for (int a = 0; a < D; a++) viscous[a] = zero;

  each_vector(pairs.count[i], [&](int k, auto left) {
    const int *j = neighbors + k;
    Motion<D> d[BLOCK];
    Pack state[BLOCK], inertia[BLOCK], tensile[BLOCK], l_i[BLOCK], l_j[BLOCK];
    prefetch(factors + k + PAIRS_AHEAD, LANES);
    const Pack F = of_row(load(factors + k), left);
    const Spread factor(F);
    for (int m = 0; m < BLOCK; m++) {
      const Addresses kj(kall, j + m, stride_of<UNIFORM>()), sj(sall, j + m, STRIDE);
      d[m] = own - Motion<D>(kj);
      state[m] = load(sj + Str::K);
      const Several<D> X = d[m].spread_x();
      const Pack KF = shuffle<0, 0, 0, 0>(state[m]) * factor[m];
      stress = multiply_add(KF, times(T + load_tensor<D>(sj), X), stress);
      if (TENSILE) tensile[m] = KF * times(R + load_tensor<D>(sj + R_AT), X);
      if (!UNIFORM && (VISCOUS || TENSILE)) inertia[m] = load(kj + Kin::LENGTHS);
      if (RATES) {
        const Pack x = d[m].expanded_x();
        l_i[m] = x * times(rate, X);
        l_j[m] = x * times(load_tensor<D>(sj + L_AT), X);
      }
    }
    if (!VISCOUS && !TENSILE) return;

    const Components<D> apart = Motion<D>::components(d);
    const Pack r2 = apart.x_dot_x();
    Pack vr = apart.v_dot_x();
    if (!UNIFORM) transpose(inertia[0], inertia[1], inertia[2], inertia[3]);    // .., .., h, near
    const Pack h = UNIFORM ? Pack(common_h) : 0.5 * (ki[Kin::H] + inertia[Kin::H_LANE]);
    if (TENSILE) {
      const Pack own_near(near_of<UNIFORM>(ki));
      const Pack near = UNIFORM ? own_near : inertia[Kin::H_LANE + 1];
      const Pack spacing = (0.5 / opt.hbar) * (own_near + near);
      const Pack fn = crowding<D>(square_root(r2), h, spacing, opt.tensile_n);
      store_first(crowds + k, fn, left);
      const Spread each(fn);
      for (int m = 0; m < BLOCK; m++) stress = multiply_add(each[m], tensile[m], stress);
    }
    if (VISCOUS) {
      transpose(state[0], state[1], state[2], state[3]);    // K, rho, c, nsum or switch
      const Pack rho = 0.5 * (si[Str::RHO] + state[1]), c = 0.5 * (si[Str::C] + state[2]);
      const Pack on = needs_switch(FORM) ? 0.5 * (si[Str::SWITCH] + state[3]) : Pack(1.0);
      if (RATES)
        vr = jump_left<FORM>(vr, sums(l_i[0], l_i[1], l_i[2], l_i[3]),
                             sums(l_j[0], l_j[1], l_j[2], l_j[3]), on);
      const Pack mu = approach_rate(vr, r2, h);
      const Pack mass = opt.corrected ? state[0] * state[1] : state[0];    // K is V or m
      Pack q = mass * monaghan_pi(a1, a2, c, rho, mu) * F;
      if (FORM == PairForm::SWITCHED) q *= on;
      if (keep) store_first(pulls + k, q, left);    // m_j Pi_ij F_ij h0^(D+2)
      if (correct) {
        q = where_positive(state[3], ok_i * q, zero);
        if (k < nearest) {    // of the correction: m_j Wbar_ij becomes a weight
          double *weight = weights + k;
          const Pack n_i(si[Str::NSUM]), m_wbar = load(weight);
          store(weight, correction_weight(opt.weights, m_wbar, n_i, state[3]));
        }
      }
      apart.add_to(viscous, -q);
      mu_least = minimum(mu_least, of_row(mu, left));
    }
  });

  const double K = unit_factor * si[Str::K], mass = ki[Kin::MASS];
  stress = sum_of_blocks(stress);
  const Pack viscous_sum = unit_factor * sums_of<D>(viscous);
  for (int a = 0; a < D; a++) {
    p.f[i][a] += K * folded<D>(stress, a);
    if (VISCOUS && correct)
      da(i)[a] = viscous_sum[a];
    else if (VISCOUS)
      p.f[i][a] += mass * viscous_sum[a];
  }
  if (this->limits_step) mu_max[i] = -least(mu_least);
}

}    // namespace

/* ---------------------------------------------------------------------- */

template <int D>
std::unique_ptr<Sweeps> SPHSolid::eulerian_sweeps(const Options &o, const std::vector<TypeData> &t)
{
  return std::make_unique<EulerianSweeps<D>>(o, t);
}

template std::unique_ptr<Sweeps> SPHSolid::eulerian_sweeps<2>(const Options &,
                                                              const std::vector<TypeData> &);
template std::unique_ptr<Sweeps> SPHSolid::eulerian_sweeps<3>(const Options &,
                                                              const std::vector<TypeData> &);
