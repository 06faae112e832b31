/* ----------------------------------------------------------------------
   The sweeps of the Lagrangian frame: pairs and kernel gradients belong to the
   reference configuration and are never renewed; see sph_solid_sweeps.h.

   With X reference positions, V0 reference volumes, g_ij = grad_i W(X_i - X_j):

     M_i  = sum_j V0_j (X_j - X_i) (x) g_ij,  B_i = M_i^-1
     F_i  = 1 + [sum_j V0_j (u_j - u_i) (x) g_ij] B_i,  u = x - X
     F'_i = [sum_j V0_j (v_j - v_i) (x) g_ij] B_i
     L_i  = F'_i (F_i - dt/2 F'_i)^-1            in the middle of the step
     C_i  = J_i F_i^-T B_i^T,  J_i = m_i/(rho_i V0_i)
     f_ij = V0_i V0_j (sigma_i C_i + sigma_j C_j) g_ij

   B makes F exact for linear fields, and the same B in C makes f_ij the exact
   adjoint of F.  Linear momentum is exact since f_ij = -f_ji; angular momentum
   since sum_j V0_j (x_j - x_i) (x) C_i g_ij = J_i 1 and sigma is symmetric.
   Corrected total-Lagrangian SPH: Bonet & Kulasegaram (2002); Ganzenmueller (2015).
------------------------------------------------------------------------- */

#include "sph_solid_sweeps_base.h"

#include <Eigen/Eigenvalues>
#include <atomic>

using namespace SPHSolid;

namespace {

// below this det M a particle has no partners to speak of and B = 1.  Corners
// of a body reach 0.05 and need their B
constexpr double DET_FALLBACK = 0.005;

// the frame ends where the least principal stretch, or the stretch of a pair,
// falls below this
constexpr double LEAST_STRETCH = 0.01;

// the time step shrinks with the least principal stretch, but not further than
// this: a Courant number of 0.6 is then still stable
constexpr double STEP_STRETCH = 0.05;

template <int D> class LagrangianSweeps : public SweepsBase<D, LagrangianRow<D>> {
 public:
  LagrangianSweeps(const Options &o, const std::vector<TypeData> &t) :
      SweepsBase<D, LagrangianRow<D>>(o, t, count_tensors(o))
  {
  }

  void new_neighbors(const Particles &, const NeighborRows &, double) override;
  int gradient(const Particles &, const NeighborRows &, double) override;
  void find_switch(const Particles &, const NeighborRows &) override;
  void force(const Particles &, const NeighborRows &) override;
  void heat(const Particles &, const NeighborRows &, double *, bool) override;
  void virial(const Particles &, const NeighborRows &, double *) override;
  Overload find_overload(const NeighborRows &) const override;
  double memory_usage() const override;

 private:
  using Base = SweepsBase<D, LagrangianRow<D>>;
  using Base::da, Base::da_stride, Base::early, Base::early_totals, Base::extra, Base::image_first,
      Base::image_j, Base::images, Base::keeps_pairs, Base::kin, Base::krow, Base::lonely,
      Base::mu_max, Base::near_weight, Base::needs_correction, Base::nthreads, Base::opt,
      Base::pairs, Base::pull, Base::separation, Base::srow, Base::str, Base::stress_stride,
      Base::types, Base::u, Base::VECTOR, Base::wbar_mass, Base::whole_pull;
  using typename Base::Kin;
  using typename Base::Str;

  std::vector<double> nearness;    // q/(q^2 + 0.01), q = |X_ij|/h_ij: eq. 24's factor
  Rows B;                          // of own particles, tensors
  Rows F;                          // the same, where no neighbor reads C
  std::vector<double> nsum;        // n of the correction, own
  std::vector<double> damp;        // of every pair: hourglass force on i = V0_i damp x_ij

  bool viscous() const { return opt.viscosity != Viscosity::NONE; }
  static bool keeps_rates(const Options &o)
  {
    return o.hourglass > 0.0 || needs_rates(pair_form(o.viscosity));
  }
  static int count_tensors(const Options &o)
  {
    return (o.viscosity != Viscosity::NONE ? 1 : 0) + (keeps_rates(o) ? 1 : 0);
  }
  // where in a stress row: C, F'
  int at_C() const { return extra(0); }
  int at_rate() const { return extra(viscous() ? 1 : 0); }

  bool can_keep_heat() const override
  {
    if (!opt.energy) return false;
    return !needs_correction() ||
        (opt.weights == Weights::CONSERVATIVE && opt.heating == Heating::COMPATIBLE);
  }
  void add_due_heat(const Particles &, const NeighborRows &) override;
  bool constant_weights() const override { return true; }
  double own_weight(int i) const override { return kin(i)[Kin::VOLUME]; }
  double switch_weight(int) const override { return 1.0; }    // the factor has V0_j
  double step_factor(int i) const override;
  Overload overload(int i) const;
  double weight_volume(const Particles &p, int i) const override { return p.vref[i]; }

  // X_i - X_j
  Vector<D> reference_separation(int i, int j) const
  {
    Vector<D> X;
    for (int a = 0; a < D; a++) X[a] = kin(i)[Kin::REFERENCE + a] - kin(j)[Kin::REFERENCE + a];
    return X;
  }
  double *reference(int row) { return &krow[row * Kin::STRIDE + Kin::REFERENCE]; }
  void place_references(const Particles &, const NeighborRows &);
  void unwrap_references(const Particles &, const NeighborRows &);
  int add_pairs(const Particles &, int i, int n, const int *list, bool nearest, int at);
  void fill_vectors(int i);
  double mass_wbar(const Particles &, int i, int j) const;
  void correct_row(const Particles &, int i);
  void prefetch_pairs(int k) const
  {
    prefetch(pairs.factor.data() + k + PAIRS_AHEAD, LANES);
  }
  // one of own particles' tensors
  static constexpr int TENSOR = Blocks<D>::TENSOR;
  static Tensor<D> tensor(const double *blocks)
  {
    Tensor<D> t;
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) t(a, b) = blocks[Blocks<D>::at(a, b)];
    return t;
  }
  Tensor<D> deformation_gradient(int i) const;

  // of a row, of the heat that is due: what viscosity, correction and hourglass damping of pairs
  // give, up to factors of the row
  struct LateHeat {
    Motion<D> kick;    // da and the velocity that belongs to it
    Pack drift, viscous, corrected, hourglass;
  };
  // of a batch: sum V0 (u_j-u_i)(x)g and sum V0 (v_j-v_i)(x)g; of the heat that is due, the
  // viscous part and that of the hourglass damping
  struct Sums {
    Several<D> displacement[LANES], velocity[LANES];
    double viscous[LANES] = {}, hourglass[LANES] = {};
  };
  template <bool LATE> void accumulate(int i, Sums &, int lane) const;
  void add_late_pairs(const int *j, int k, bool nearest, const Motion<D> *d, LateHeat &) const;
  template <bool LATE>
  int update(const Particles &, const typename Base::Batch &, int n, double dt,
             typename Base::Totals &);
  // velocity of the last evaluation
  const double *early_v(int i) const { return &da[i * da_stride + VECTOR]; }
  void add_late_heat(const Particles &, const typename Base::Batch &, int n,
                     const Tensor<D, Pack> &velocity, Sums &, typename Base::Totals &) const;
  template <class Call> void each_batch(const NeighborRows &, Call);
  template <PairForm FORM, bool HOURGLASS> typename Base::Power force_row(const Particles &, int i);
  template <PairForm FORM, bool HOURGLASS> void force_rows(const Particles &, const NeighborRows &);
  void near_weights(const Particles &, int i) override;
  void pack_constants(const Particles &, int i, double *row) const override;
  template <bool PULL, bool DAMP> typename Base::Power pair_power(int i) const;
};

/* ----------------------------------------------------------------------
   partners have new local indices: everything that is constant between two
   such moments
------------------------------------------------------------------------- */

template <int D>
void LagrangianSweeps<D>::pack_constants(const Particles &p, int i, double *row) const
{
  row[Kin::MASS] = p.mass[i];
  row[Kin::VOLUME] = p.vref[i];
  for (int a = 0; a < D; a++) row[Kin::REFERENCE + a] = p.xref[i][a];
}

// Bodies cross a periodic box, and their reference does not: move reference positions by whole
// boxes until partners are neighbors there, too.  How many boxes two rows are to be apart follows
// from where they are now, so that it is the same from every particle that has both as partners

template <int D>
void LagrangianSweeps<D>::unwrap_references(const Particles &p, const NeighborRows &list)
{
  std::vector<char> placed(p.nall, 0);
  std::vector<int> open;
  auto place = [&](int j) {
    placed[j] = 1;
    if (j < p.nlocal) open.push_back(j);
  };
  for (int ii = 0; ii < list.inum; ii++) {
    if (!placed[list.ilist[ii]]) place(list.ilist[ii]);
    while (!open.empty()) {
      const int i = open.back();
      open.pop_back();
      for (int jj = 0; jj < list.numneigh[i]; jj++) {
        const int j = list.firstneigh[i][jj] & INDEX_MASK;
        if (placed[j]) continue;
        const Vector<D> X = reference_separation(i, j);
        for (int a = 0; a < D; a++)
          if (p.period[a] > 0.0) reference(j)[a] += p.period[a] * std::round(X[a] / p.period[a]);
        place(j);
      }
    }
  }
}

template <int D>
void LagrangianSweeps<D>::place_references(const Particles &p, const NeighborRows &list)
{
  if (p.period[0] > 0.0 || p.period[1] > 0.0 || p.period[2] > 0.0) unwrap_references(p, list);
  for (int row = p.nall; row < this->nrows; row++) {
    const int k = row - p.nall;
    images.template position<D>(k, reference(images.source_of(k)), reference(row));
  }
}

// append the nearest or the other partners of a list to row i from at on

template <int D>
int LagrangianSweeps<D>::add_pairs(const Particles &p, int i, int n, const int *list, bool nearest,
                                   int at)
{
  for (int jj = 0; jj < n; jj++) {
    const int j = list[jj] & INDEX_MASK;
    const int source = Base::source_of(j);
    const TypeData &ti = types[p.type[i]], &tj = types[p.type[source]];
    const double h = 0.5 * (ti.h + tj.h), support = 0.5 * opt.hbar * (ti.spacing + tj.spacing);
    const double r = reference_separation(i, j).norm();
    if ((r < support) != nearest || (!nearest && r >= SUPPORT * h)) continue;
    if (j >= p.nall && r < COINCIDE * h) continue;    // on the plane: its own image
    const double q = r / h;
    pairs.j[at] = j;
    pairs.factor[at] = p.vref[source] * CubicSpline<D>::gradient_factor(r, h);
    nearness[at] = q / (q * q + MU_EPSILON);
    at++;
  }
  return at;
}

template <int D>
void LagrangianSweeps<D>::new_neighbors(const Particles &p, const NeighborRows &list, double reach)
{
  Base::find_image_candidates(p, list, p.xref, reach);
  Base::size_rows(p, list);
  place_references(p, list);
  const std::size_t n = pairs.j.size();
  if (opt.hourglass > 0.0) damp.resize(n);
  nearness.resize(n);
  B.resize(static_cast<std::size_t>(p.nlocal) * TENSOR);
  if (!viscous()) F.resize(static_cast<std::size_t>(p.nlocal) * TENSOR);
  nsum.assign(p.nlocal, 0.0);

#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads)
#endif
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii], start = pairs.first[i];
    const int nimage = images.any() ? image_first[i + 1] - image_first[i] : 0;
    const int *image = nimage ? &image_j[image_first[i]] : nullptr;
    int at = add_pairs(p, i, list.numneigh[i], list.firstneigh[i], true, start);
    at = add_pairs(p, i, nimage, image, true, at);
    pairs.nearest[i] = needs_correction() ? at - start : 0;
    at = add_pairs(p, i, list.numneigh[i], list.firstneigh[i], false, at);
    at = add_pairs(p, i, nimage, image, false, at);
    pairs.count[i] = at - start;
    fill_vectors(i);
    correct_row(p, i);
  }
  if (needs_correction()) near_weight.resize(n);
}

// the last pair again, without weight

template <int D> void LagrangianSweeps<D>::fill_vectors(int i)
{
  const int n = pairs.count[i], last = pairs.first[i] + n - 1;
  for (int at = last + 1; at < pairs.first[i] + whole_vectors(n); at++) {
    pairs.j[at] = pairs.j[last];
    pairs.factor[at] = 0.0;
    nearness[at] = nearness[last];
  }
}

// m_j Wbar(X_ij)

template <int D> double LagrangianSweeps<D>::mass_wbar(const Particles &p, int i, int j) const
{
  const double near_i = opt.hbar * types[p.type[i]].spacing;
  const double near_j = opt.hbar * types[p.type[Base::source_of(j)]].spacing;
  return Base::wbar_mass(reference_separation(i, j).norm(), kin(j)[Kin::MASS], near_i, near_j);
}

// B_i and, for the acceleration correction, n_i = sum m_j Wbar(X_ij)

template <int D> void LagrangianSweeps<D>::correct_row(const Particles &p, int i)
{
  Tensor<D> M = Tensor<D>::Zero();
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
    const Vector<D> X = reference_separation(i, pairs.j[k]);
    M -= pairs.factor[k] * X * X.transpose();
    if (k < pairs.first[i] + pairs.nearest[i]) nsum[i] += mass_wbar(p, i, pairs.j[k]);
  }
  const bool enough = M.determinant() >= DET_FALLBACK;
  const Tensor<D> inverse = enough ? Tensor<D>(M.inverse()) : Tensor<D>::Identity();
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) B[i * TENSOR + Blocks<D>::at(a, b)] = inverse(a, b);
}

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
      const Several<D> g = spread<D>(X) * factor[m];                // V0_j g_ij
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

template <int D>
void LagrangianSweeps<D>::find_switch(const Particles &p, const NeighborRows &list)
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
typename SweepsBase<D, LagrangianRow<D>>::Power LagrangianSweeps<D>::force_row(const Particles &p, int i)
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
  Pack stress = zero, viscous = zero, hourglass = zero, mu_least = zero;
  Pack viscous_power = zero, hourglass_power = zero;

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
      const Several<D> X = spread<D>(Xi - load(kj + Kin::REFERENCE)), g = X * factor[m];
      add_times<D>(stress, T + load_tensor<D>(sj), g);
      if (!VISCOUS && !HOURGLASS) continue;
      d[m] = own - Motion<D>(kj);
      const Pack x = d[m].expanded_x();
      state[m] = load(sj + Str::K);
      if (VISCOUS) along[m] = x * times(C + load_tensor<D>(sj + C_AT), g);
      if (BOTH) {
        l_i[m] = x * times(rate, X);
        l_j[m] = x * times(load_tensor<D>(sj + R_AT), X);
      } else if (RATES)
        l_i[m] = x * times(rate + load_tensor<D>(sj + R_AT), X);
    }
    if (!VISCOUS && !HOURGLASS) continue;

    Pack r2, vr;
    Motion<D>::dots(d, r2, vr);
    const Pack inv_r2 = 1.0 / r2;
    transpose(state[0], state[1], state[2], state[3]);    // K, rho, c, nsum or switch
    Pack li = zero, lj = zero;    // their sum counts, and for some viscosities each of them
    if (RATES) li = sums(l_i[0], l_i[1], l_i[2], l_i[3]);
    if (BOTH) lj = sums(l_j[0], l_j[1], l_j[2], l_j[3]);
    if (HOURGLASS) {
      const Pack impedance = damping_share * (si[Str::K] + state[0]);
      const Pack s = impedance * F * (vr - 0.5 * (li + lj)) * inv_r2;
      store(damping + k, s);
      hourglass_power = multiply_add(s, vr, hourglass_power);
      const Spread each(s);
      for (int m = 0; m < BLOCK; m++) hourglass = multiply_add(each[m], d[m].x(), hourglass);
    }
    if (VISCOUS) {
      const Pack on = needs_switch(FORM) ? 0.5 * (si[Str::SWITCH] + state[3]) : Pack(1.0);
      const Pack jump = jump_left<FORM>(vr, li, lj, on);
      const Pack mu = minimum(jump, zero) * load(near + k) * square_root(r2) * inv_r2;
      const Pack rho = 0.5 * (si[Str::RHO] + state[1]), c = 0.5 * (si[Str::C] + state[2]);
      Pack Pi = rho * mu * (a2 * mu - a1 * c);
      if (FORM == PairForm::SWITCHED) Pi *= on;
      const Pack G = 0.5 * sums(along[0], along[1], along[2], along[3]);
      Pack s = Pi * minimum(G, zero) * inv_r2;    // V0_j Pi G
      if (keep) {
        store(pulls + k, s);
        viscous_power = multiply_add(s, vr, viscous_power);
      }
      if (correct) s = where_positive(state[3], ok_i * s, zero);
      const Spread each(-s);
      for (int m = 0; m < BLOCK; m++) viscous = multiply_add(each[m], d[m].x(), viscous);
      mu_least = minimum(mu_least, mu);
    }
  }

  const double V0 = kin(i)[Kin::VOLUME], per_mass = V0 / kin(i)[Kin::MASS];
  stress = sum_of_blocks(stress);
  viscous = sum_of_blocks(viscous);
  hourglass = sum_of_blocks(hourglass);
  for (int a = 0; a < D; a++) {
    p.f[i][a] += V0 * (folded<D>(stress, a) + hourglass[a]);
    if (VISCOUS && correct)
      da[i * da_stride + a] = per_mass * viscous[a];
    else if (VISCOUS)
      p.f[i][a] += V0 * viscous[a];
  }
  mu_max[i] = -least(mu_least);
  return {0.0, 0.5 * V0 * sum(viscous_power), -0.5 * V0 * sum(hourglass_power)};
}

// over the nearest partners: constant until the partners have new indices

template <int D> void LagrangianSweeps<D>::near_weights(const Particles &p, int i)
{
  Base::set_near_weights(i, [&](int k) {
    return pack_of([&](int m) {
      return mass_wbar(p, i, pairs.j[k + m]);
    });
  });
}

/* ----------------------------------------------------------------------
   heat
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

/* ----------------------------------------------------------------------
   particles come closer with the least principal stretch, and so must the
   time step
------------------------------------------------------------------------- */

template <int D> double least_stretch(const Tensor<D> &F)
{
  Eigen::SelfAdjointEigenSolver<Tensor<D>> eigen;
  eigen.computeDirect(F.transpose() * F, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(eigen.eigenvalues()[0], 0.0));
}

template <int D> Tensor<D> LagrangianSweeps<D>::deformation_gradient(int i) const
{
  if (!viscous()) return tensor(&F[i * TENSOR]);
  const double J = kin(i)[Kin::MASS] / (str(i)[Str::RHO] * kin(i)[Kin::VOLUME]);
  return J * tensor(str(i) + at_C()).inverse().transpose() * tensor(&B[i * TENSOR]);
}

template <int D> double LagrangianSweeps<D>::step_factor(int i) const
{
  return std::min(1.0, std::max(STEP_STRETCH, least_stretch<D>(deformation_gradient(i))));
}

/* ----------------------------------------------------------------------
   where the frame ends: F turned over, squeezed flat, or two partners on top
   of each other
------------------------------------------------------------------------- */

template <int D> Overload LagrangianSweeps<D>::find_overload(const NeighborRows &list) const
{
  int first = list.inum;    // in the list, of those that are beyond it
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads) reduction(min : first)
#endif
  for (int ii = 0; ii < list.inum; ii++)
    if (ii < first && overload(list.ilist[ii]).kind != Overload::NONE) first = ii;
  return first < list.inum ? overload(list.ilist[first]) : Overload();
}

template <int D> Overload LagrangianSweeps<D>::overload(int i) const
{
  if (pairs.count[i] == 0) return {};
  const Tensor<D> Fi = deformation_gradient(i);
  const double J = Fi.determinant();
  if (!(J > 0.0)) return {Overload::TURNED_OVER, i, J};
  const double s = least_stretch<D>(Fi);
  if (s < LEAST_STRETCH) return {Overload::STRETCH, i, s};
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
    const double X2 = reference_separation(i, pairs.j[k]).squaredNorm();
    const double x2 = separation(i, pairs.j[k]).squaredNorm();
    if (x2 < LEAST_STRETCH * LEAST_STRETCH * X2) return {Overload::OVERLAP, i, std::sqrt(x2 / X2)};
  }
  return {};
}

template <int D> double LagrangianSweeps<D>::memory_usage() const
{
  const std::size_t doubles = nearness.capacity() + B.capacity() + F.capacity() +
      nsum.capacity() + damp.capacity();
  return Base::memory_usage() + static_cast<double>(doubles * sizeof(double));
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
