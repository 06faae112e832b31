/* ----------------------------------------------------------------------
   What the sweeps of both frames share: rows of particles, ghosts and mirror
   images, the constitutive update, the acceleration correction, heat.

   A frame fills in where a pair's kernel gradient comes from: present
   positions (sph_solid_sweeps_eulerian.cpp) or those of the reference
   configuration (sph_solid_sweeps_lagrangian.cpp).
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_SWEEPS_BASE_H
#define LMP_SPH_SOLID_SWEEPS_BASE_H

#include "sph_solid_eos.h"
#include "sph_solid_kernel.h"
#include "sph_solid_lanes.h"
#include "sph_solid_strength.h"
#include "sph_solid_sweeps.h"
#include "sph_solid_switch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace SPHSolid {

// the bits of a LAMMPS neighbor index that are the index (NEIGHMASK)
constexpr int INDEX_MASK = 0x1FFFFFFF;

// a particle this close to its image, in smoothing lengths, is on the plane, and
// both are the two halves of one particle
constexpr double COINCIDE = 1.0e-6;

// a sweep asks for the data of pairs so many pairs ahead
constexpr int PAIRS_AHEAD = 64;

// call with the form of the pair viscosity as a constant

template <class Call> void with_form(PairForm form, Call call)
{
  switch (form) {
    case PairForm::NONE:
      call(std::integral_constant<PairForm, PairForm::NONE>());
      break;
    case PairForm::WHOLE:
      call(std::integral_constant<PairForm, PairForm::WHOLE>());
      break;
    case PairForm::LIMITED:
      call(std::integral_constant<PairForm, PairForm::LIMITED>());
      break;
    case PairForm::SWITCHED:
      call(std::integral_constant<PairForm, PairForm::SWITCHED>());
      break;
    case PairForm::FRONT:
      call(std::integral_constant<PairForm, PairForm::FRONT>());
      break;
  }
}

// call with two flags as constants

template <class Call> void with_flags(bool first, bool second, Call call)
{
  constexpr std::true_type yes;
  constexpr std::false_type no;
  if (first && second) call(yes, yes);
  if (first && !second) call(yes, no);
  if (!first && second) call(no, yes);
  if (!first && !second) call(no, no);
}

// Row: EulerianRow<D> or LagrangianRow<D>

template <int D, class Row> class SweepsBase : public Sweeps {
 public:
  // ntensors: how many tensors follow the fixed part of a stress row
  SweepsBase(const Options &o, const std::vector<TypeData> &t, int ntensors_) :
      opt(o), types(t), ntensors(ntensors_), stress_stride(extra(ntensors_))
  {
    for (const TypeData &type : types) {
      resistances.push_back(resistance(type.material));
      compressions.push_back(compression(type.material));
    }
  }

  void pack_kinematics(const Particles &, const double *const *) override;
  int stress_size() const override { return stress_stride; }
  const double *stress_row(int i) const override { return &srow[i * stress_stride]; }
  void unpack_stress(const Particles &, int, const double *) override;
  void mirror_stress() override;
  bool sweeps_for_switch() const override { return opt.viscosity == Viscosity::FRONT; }
  double *viscosity_switch(int i) override { return str(i) + Str::SWITCH; }
  void mirror_switch() override;
  bool needs_correction() const override { return opt.viscosity == Viscosity::CORRECT; }
  double *viscous_acceleration(int i) override { return &da[i * da_stride]; }
  void correction(const Particles &, const NeighborRows &) override;
  double *displacement(int i) override { return &krow[i * Kin::STRIDE + Kin::V]; }
  double time_step_limit(const Particles &, const NeighborRows &) const override;
  double sound_speed(int i) const override { return srow[i * stress_stride + Str::C]; }
  int neighbor_count(int i) const override { return pairs.count[i]; }
  double memory_usage() const override;

 protected:
  using Kin = Row;
  using Str = Stress<D>;
  static constexpr int VECTOR = Blocks<D>::VECTOR;

  Options opt;
  std::vector<TypeData> types;
  std::vector<Resistance<>> resistances;    // of the types
  std::vector<Compression<>> compressions;
  int ntensors, stress_stride;
  int nown = 0, nparticles = 0, nrows = 0;    // own; own and ghost; with images

  Rows krow, srow, da;           // rows of kinematics, stress, da
  int da_stride = VECTOR;        // da, and with heat on the way the velocity that belongs to it
  std::vector<double> mu_max;    // largest approach rate of own particles
  Pairs pairs;
  std::vector<int> image_first, image_j;    // candidates among the images
  std::vector<double> near_weight;          // of pairs of nearest neighbors, for the correction
  std::vector<double> near_pull;            // weights safe: force on i = m_i/2 near_pull x_ij
  bool weights_known = false;
  std::vector<double> pull;    // viscous force on i = -own weight * pull * x_ij, kept for heat
  bool lonely = false;         // a particle here has no nearest neighbor

  const double *kin(int i) const { return &krow[i * Kin::STRIDE]; }
  double *str(int i) { return &srow[i * stress_stride]; }
  const double *str(int i) const { return &srow[i * stress_stride]; }
  // tensor k of those that follow the fixed part of a row
  static constexpr int extra(int k) { return Str::STRIDE + k * Blocks<D>::TENSOR; }

  // of two rows: of present positions, or of another vector in them
  Vector<D> separation(int i, int j, int at = Kin::X) const
  {
    Vector<D> d;
    for (int a = 0; a < D; a++) d[a] = kin(i)[at + a] - kin(j)[at + a];
    return d;
  }
  bool safe() const { return needs_correction() && opt.weights == Weights::SAFE; }
  bool is_lonely(int i) const { return needs_correction() && !(str(i)[Str::NSUM] > 0.0); }

  void size_rows(const Particles &, const NeighborRows &);
  // the particle that a row belongs to: for an image, that which it is one of
  int source_of(int row) const
  {
    return row < nparticles ? row : images.source_of(row - nparticles);
  }
  void find_image_candidates(const Particles &, const NeighborRows &, double **x, double reach);
  void mirror_vectors(double *rows, int stride) const;
  // m_j Wbar_ij; near: supports of Wbar of both, whose mean is that of the pair
  template <class Real> static Real wbar_mass(Real r, Real mass, Real near_i, Real near_j)
  {
    return mass * CubicSpline<D>::w(r, Real(0.25 * (near_i + near_j)));
  }
  double retained_viscosity() const;

  // as many own particles as there are lanes; at the end of a list the last one fills up
  struct Batch {
    int i[LANES];
    bool consecutive;    // they lie one after the other in arrays
    Batch(const NeighborRows &list, int first)
    {
      const int last = list.inum - 1;
      for (int m = 0; m < LANES; m++) i[m] = list.ilist[std::min(first + m, last)];
      consecutive = true;
      for (int m = 1; m < LANES; m++) consecutive = consecutive && i[m] == i[0] + m;
    }
    Pack load(const double *array) const
    {
      if (consecutive) return SPHSolid::load(array + i[0]);
      return pack_of([&](int m) {
        return array[i[m]];
      });
    }
    void store(double *array, Pack v) const
    {
      if (consecutive)
        SPHSolid::store(array + i[0], v);
      else
        for (int m = 0; m < LANES; m++) array[i[m]] = v[m];
    }
    // blocks of particles m and, with eight lanes, m + 4, m = 0 to 3, in an array of rows
    Addresses rows(const double *array, int m, int stride) const
    {
      return Addresses(array, i + m, stride);
    }
  };
  // value(type) of each particle
  template <class F> static Pack of_types(const Particles &p, const Batch &batch, F value)
  {
    int t[LANES];
    bool same = true;
    for (int m = 0; m < LANES; m++) {
      t[m] = p.type[batch.i[m]];
      same = same && t[m] == t[0];
    }
    if (same) return Pack(value(t[0]));
    return pack_of([&](int m) {
      return value(t[m]);
    });
  }
  struct Points {
    PointState<D, Pack> state;
    PressureState<Pack> eos;
    Tensor<D, Pack> sigma;    // Cauchy stress, tension positive
    Pack plastic_work;        // of this step [energy]
  };
  // of the first n particles of a batch
  static double sum_of_first(Pack v, int n) { return sum(n < LANES ? v * first_lanes(n) : v); }
  static void load_deviator(const Particles &, const Batch &, PointState<D, Pack> &);
  static void store_deviator(const Particles &, const Batch &, PointState<D, Pack> &);
  Points update_points(const Particles &, const Batch &, const Tensor<D, Pack> &L_mid, double dt);
  void write_rows(const Batch &, const Points &, const Tensor<D, Pack> &T, Pack K, Pack nsum);
  void write_tensors(const Batch &, int at, const Tensor<D, Pack> &);
  static int unphysical(const Batch &, Pack rho, Pack others);
  void prefetch_points(const Particles &, const Batch &) const;

  // is the viscous force of every pair kept for heat?
  bool keeps_pairs() const
  {
    if (opt.viscosity == Viscosity::NONE) return false;
    return !needs_correction() || opt.heating == Heating::PRINTED || lonely;
  }
  // ... and is it heat as it is?  A compatible correction heats in a way of its own
  bool heats_pairs() const
  {
    return keeps_pairs() && !(needs_correction() && opt.heating == Heating::COMPATIBLE);
  }
  double whole_pull(int i, int pair) const;
  void lonely_pairs(const Particles &, int i);
  // call(weights, neighbors, da_i - da_j) for the nearest neighbors of i, some at a time;
  // behind the last one weights are 0
  template <class F> void each_few(int i, F call) const
  {
    const Pack own = load_few<D>(&da[i * da_stride]);
    const int first = pairs.first[i], end = first + pairs.nearest[i];
    for (int k = first; k < end; k += Few<D>::N) {
      const int *j = &pairs.j[k];
      call(load_few_weights<D>(&near_weight[k]), j, own - load_few<D>(da.data(), j, da_stride));
    }
  }
  template <class Moved, class Apart> double lonely_power(int i, Moved du, Apart dx) const;
  const double *u(int i) const { return kin(i) + Kin::V; }    // during heat: displacements

  // of the frame: what a kinematic row has of a particle besides its motion, its volume weight,
  // what a kept pull is to be multiplied with, how much shorter a time step has to be
  virtual void pack_constants(const Particles &, int i, double *row) const = 0;
  virtual double weight_volume(const Particles &, int i) const = 0;
  virtual double own_weight(int i) const = 0;
  virtual double step_factor(int) const { return 1.0; }
  // are the weights of a row constant until neighbors are new?  Else the force sweep finds them
  virtual bool constant_weights() const { return false; }
  virtual void near_weights(int) {}

  // what the forces of a row's pairs give to i while all particles move by u; of
  // the stress the half with sigma_i, of the others half of each pair's
  struct Power {
    double stress = 0.0, viscous = 0.0, hourglass = 0.0;
  };
  template <class OfRow> void sum_heat(const NeighborRows &, double *, bool book, OfRow of_row);
  double heat_correction(int i) const;
  double standard_power(int i, const double *u) const;

  // of heat on the way: power of own particles with the velocities of the last evaluation, and sums
  // of it as the ledger has them
  struct Totals {
    double plastic = 0.0, viscous = 0.0, standard = 0.0, hourglass = 0.0;
  };
  std::vector<double> early;
  Totals early_totals;
  void enter(const Totals &, double factor);
  Pack central_correction(int i);
  Pack near_force(int i, int pair, const Motion<D> &d) const;
  template <class OfRow> void sum_virial(const NeighborRows &, double *six, OfRow of_row) const;

  Pack own_switch(const Tensor<D, Pack> &L, Pack c, Pack h) const;
  template <class Along>
  void sum_switch(const Particles &, const NeighborRows &, int at_rate, Along along);
  virtual double switch_weight(int j) const = 0;    // times pairs.factor
};

/* ----------------------------------------------------------------------
   storage
------------------------------------------------------------------------- */

template <int D, class Row>
void SweepsBase<D, Row>::size_rows(const Particles &p, const NeighborRows &list)
{
  nown = p.nlocal;
  nparticles = p.nall;
  nrows = p.nall + (images.any() ? images.count() : 0);
  krow.resize(static_cast<std::size_t>(nrows) * Kin::STRIDE);
  srow.resize(static_cast<std::size_t>(nrows) * stress_stride);
  da_stride = this->keeps_heat ? 2 * VECTOR : VECTOR;
  if (needs_correction()) da.resize(static_cast<std::size_t>(nrows) * da_stride);
  mu_max.assign(p.nlocal, 0.0);
  if (this->keeps_heat) early.assign(p.nlocal, 0.0);
  pairs.first.assign(p.nlocal + 1, 0);
  pairs.count.assign(p.nlocal, 0);
  pairs.nearest.assign(p.nlocal, 0);
  weights_known = false;

  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    pairs.first[i + 1] = list.numneigh[i];
  }
  for (int i = 0; i < p.nlocal; i++) {
    if (images.any()) pairs.first[i + 1] += image_first[i + 1] - image_first[i];
    pairs.first[i + 1] = pairs.first[i] + whole_vectors(pairs.first[i + 1]);
  }
  pairs.j.resize(pairs.first[p.nlocal]);
  pairs.factor.resize(pairs.first[p.nlocal]);
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads)
#endif
  for (int row = 0; row < nrows; row++)
    pack_constants(p, source_of(row), &krow[static_cast<std::size_t>(row) * Kin::STRIDE]);
}

// candidates among the images: those of every neighbor and of i itself, at x

template <int D, class Row>
void SweepsBase<D, Row>::find_image_candidates(const Particles &p, const NeighborRows &list,
                                               double **x, double reach)
{
  if (!images.any()) return;
  images.find(p.nall, x, reach);
  image_first.assign(p.nlocal + 1, 0);
  image_j.clear();
  std::vector<char> listed(p.nlocal, 0);
  for (int ii = 0; ii < list.inum; ii++) listed[list.ilist[ii]] = 1;
  for (int i = 0; i < p.nlocal; i++) {
    image_first[i] = static_cast<int>(image_j.size());
    if (!listed[i]) continue;
    auto add = [&](int j) {
      for (int k = images.first_of(j); k < images.first_of(j + 1); k++)
        image_j.push_back(p.nall + k);
    };
    add(i);
    for (int jj = 0; jj < list.numneigh[i]; jj++) add(list.firstneigh[i][jj] & INDEX_MASK);
  }
  image_first[p.nlocal] = static_cast<int>(image_j.size());
}

/* ---------------------------------------------------------------------- */

template <int D, class Row>
void SweepsBase<D, Row>::pack_kinematics(const Particles &p, const double *const *v)
{
  double *rows = krow.data();
  const bool weights = !constant_weights();
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads)
#endif
  for (int i = 0; i < p.nall; i++) {
    double *row = rows + static_cast<std::size_t>(i) * Kin::STRIDE;
    const double *x = p.x[i], *vi = v[i];
    for (int a = 0; a < D; a++) {
      row[Kin::X + a] = x[a];
      row[Kin::V + a] = vi[a];
    }
    if (weights) row[Kin::VOLUME] = weight_volume(p, i);
  }
  for (int k = 0; k < nrows - p.nall; k++) {
    const double *from = kin(images.source_of(k));
    double *row = &krow[(p.nall + k) * Kin::STRIDE];
    double sign[3];
    images.signs(k, sign);
    images.position<D>(k, from + Kin::X, row + Kin::X);
    for (int a = 0; a < D; a++) row[Kin::V + a] = sign[a] * from[Kin::V + a];
    if (weights) row[Kin::VOLUME] = from[Kin::VOLUME];
  }
}

/* ----------------------------------------------------------------------
   the deviatoric stress in LAMMPS's order, xx, yy, zz, xy, xz, yz: in two
   dimensions one block has all of it, in three a second one begins at zz
------------------------------------------------------------------------- */

template <int D, class Row>
void SweepsBase<D, Row>::load_deviator(const Particles &p, const Batch &batch,
                                       PointState<D, Pack> &state)
{
  auto columns = [&](int at, Pack *c) {
    for (int m = 0; m < BLOCK; m++) c[m] = load(Addresses(p.stress, batch.i + m) + at);
    transpose(c[0], c[1], c[2], c[3]);
  };
  Pack c[BLOCK];
  columns(0, c);
  state.S(0, 0) = c[0];
  state.S(1, 1) = c[1];
  state.S(0, 1) = state.S(1, 0) = c[3];
  if constexpr (D == 2)
    state.Szz = c[2];
  else {
    state.S(2, 2) = c[2];
    columns(2, c);
    state.S(0, 2) = state.S(2, 0) = c[2];
    state.S(1, 2) = state.S(2, 1) = c[3];
  }
}

// of the two numbers that S has for a shear stress, the one above the diagonal is kept, as a
// restart file has it

template <int D, class Row>
void SweepsBase<D, Row>::store_deviator(const Particles &p, const Batch &batch,
                                        PointState<D, Pack> &state)
{
  for (int a = 0; a < D; a++)
    for (int b = 0; b < a; b++) state.S(a, b) = state.S(b, a);
  auto store_columns = [&](int at, Pack a, Pack b, Pack c, Pack d) {
    transpose(a, b, c, d);
    const Pack rows[BLOCK] = {a, b, c, d};
    for (int m = 0; m < BLOCK; m++) store(Addresses(p.stress, batch.i + m) + at, rows[m]);
  };
  if constexpr (D == 2)
    store_columns(0, state.S(0, 0), state.S(1, 1), state.Szz, state.S(0, 1));
  else {
    store_columns(0, state.S(0, 0), state.S(1, 1), state.S(2, 2), state.S(0, 1));
    store_columns(2, state.S(2, 2), state.S(0, 1), state.S(0, 2), state.S(1, 2));
  }
}

/* ----------------------------------------------------------------------
   constitutive update of a batch over dt with the velocity gradient in the
   middle of the step; dt = 0: the state as it is
------------------------------------------------------------------------- */

template <int D, class Row>
typename SweepsBase<D, Row>::Points
SweepsBase<D, Row>::update_points(const Particles &p, const Batch &batch,
                                  const Tensor<D, Pack> &L_mid, double dt)
{
  auto of = [&](const auto &list, auto member) {
    return of_types(p, batch, [&](int t) {
      return list[t].*member;
    });
  };
  Points points;
  PointState<D, Pack> &state = points.state;
  state.rho = batch.load(p.rho);
  load_deviator(p, batch, state);
  const Pack mass = batch.load(p.mass);

  if (dt > 0.0) {
    using R = Resistance<>;
    const Resistance<Pack> r = {of(resistances, &R::shear), of(resistances, &R::Y),
                                of(resistances, &R::H)};
    state.epl = batch.load(p.epl);
    const Pack per_volume = advance<D, Pack>(r, state, L_mid, dt);
    points.plastic_work = per_volume * (mass / state.rho);
    batch.store(p.rho, state.rho);
    batch.store(p.epl, state.epl);
    store_deviator(p, batch, state);
  } else
    points.plastic_work = 0.0;

  using C = Compression<>;
  const Compression<Pack> k = {of(compressions, &C::a0), of(compressions, &C::b0),
                               of(compressions, &C::c0), of(compressions, &C::Gamma)};
  points.eos = pressure(k, state.rho, mass / batch.load(p.volume), batch.load(p.e));
  points.sigma = state.S - points.eos.P * Tensor<D, Pack>::Identity();
  return points;
}

template <int D, class Row>
void SweepsBase<D, Row>::write_rows(const Batch &batch, const Points &points,
                                    const Tensor<D, Pack> &T, Pack K, Pack nsum)
{
  write_tensors(batch, Str::T, T);
  Pack rho = points.state.rho, c = square_root(maximum(points.eos.c2, Pack(0.0)));
  transpose(K, rho, c, nsum);
  const Pack state[BLOCK] = {K, rho, c, nsum};
  for (int m = 0; m < BLOCK; m++)
    store(batch.rows(srow.data(), m, stress_stride) + Str::K, state[m]);
}

// one tensor of the rows

template <int D, class Row>
void SweepsBase<D, Row>::write_tensors(const Batch &batch, int at, const Tensor<D, Pack> &t)
{
  Several<D> rows[BLOCK];
  from_lanes<D>(t, rows);
  for (int m = 0; m < BLOCK; m++)
    store_tensor(batch.rows(srow.data(), m, stress_stride) + at, rows[m]);
}

// what the next batch needs, if it lies behind this one

template <int D, class Row>
void SweepsBase<D, Row>::prefetch_points(const Particles &p, const Batch &batch) const
{
  const int next = batch.i[0] + LANES;
  if (next + LANES > nown) return;
  prefetch(p.stress[next], 6 * LANES);
  prefetch(str(next), LANES * stress_stride);
  const double *arrays[] = {p.rho, p.epl, p.e, p.mass, p.volume};
  for (const double *array : arrays) prefetch(array + next, LANES);
}

// a particle whose density is not positive, or another number of whom is not
// finite; or -1

template <int D, class Row>
int SweepsBase<D, Row>::unphysical(const Batch &batch, Pack rho, Pack others)
{
  // sum - sum is 0 or not a number
  const Pack sum = rho + others, finite = where_positive(1.0 + (sum - sum), Pack(1.0), Pack(-1.0));
  if (least(where_positive(rho, finite, Pack(-1.0))) > 0.0) return -1;
  for (int m = 0; m < LANES; m++)
    if (!(rho[m] > 0.0) || !std::isfinite(sum[m])) return batch.i[m];
  return -1;
}

/* ----------------------------------------------------------------------
   rows of ghosts and images
------------------------------------------------------------------------- */

template <int D, class Row>
void SweepsBase<D, Row>::unpack_stress(const Particles &p, int i, const double *row)
{
  std::copy(row, row + stress_stride, str(i));
  p.rho[i] = row[Str::RHO];
}

// a tensor of an image is Q T Q^T with Q = diag(sign): component (a,b) times
// both signs

template <int D, class Row> void SweepsBase<D, Row>::mirror_stress()
{
  for (int k = 0; k < nrows - nparticles; k++) {
    const double *from = str(images.source_of(k));
    double *row = str(nparticles + k);
    double sign[3];
    images.signs(k, sign);
    std::copy(from, from + stress_stride, row);
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) {
        row[Str::T + Blocks<D>::at(a, b)] *= sign[a] * sign[b];
        for (int t = 0; t < ntensors; t++) row[extra(t) + Blocks<D>::at(a, b)] *= sign[a] * sign[b];
      }
  }

  if (needs_correction() && !weights_known) {    // as long as weights are known, so is this
    lonely = false;
    for (int i = 0; i < nrows; i++) lonely = lonely || !(str(i)[Str::NSUM] > 0.0);
  }
  if (keeps_pairs()) pull.resize(pairs.j.size());
}

template <int D, class Row> void SweepsBase<D, Row>::mirror_vectors(double *rows, int stride) const
{
  for (int k = 0; k < nrows - nparticles; k++) {
    double sign[3];
    images.signs(k, sign);
    for (int a = 0; a < D; a++)
      rows[(nparticles + k) * stride + a] = sign[a] * rows[images.source_of(k) * stride + a];
  }
}

/* ----------------------------------------------------------------------
   h/(c_L + 0.6 (a1 c + a2 |mu|)), the viscous part as far as it is retained
------------------------------------------------------------------------- */

template <int D, class Row>
double SweepsBase<D, Row>::time_step_limit(const Particles &p, const NeighborRows &list) const
{
  const double retained = retained_viscosity();
  double limit = 1.0e300;
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads) reduction(min : limit)
#endif
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    const TypeData &t = types[p.type[i]];
    const double c = str(i)[Str::C], rho = str(i)[Str::RHO];
    const double c_l = std::sqrt(c * c + 4.0 * t.material.shear / (3.0 * rho));
    const double viscous = 0.6 * retained * (opt.a1 * c + opt.a2 * mu_max[i]);
    limit = std::min(limit, step_factor(i) * t.h / (c_l + viscous));
  }
  return limit;
}

template <int D, class Row> double SweepsBase<D, Row>::retained_viscosity() const
{
  if (opt.viscosity == Viscosity::NONE) return 0.0;
  return opt.viscosity == Viscosity::CORRECT ? CORRECTION_RETAINS : 1.0;
}

template <int D, class Row> double SweepsBase<D, Row>::memory_usage() const
{
  const std::size_t doubles = krow.capacity() + srow.capacity() + da.capacity() +
      mu_max.capacity() + early.capacity() + pull.capacity() + pairs.factor.capacity() +
      near_weight.capacity() + near_pull.capacity();
  const std::size_t ints = pairs.first.capacity() + pairs.count.capacity() +
      pairs.nearest.capacity() + pairs.j.capacity() + image_first.capacity() + image_j.capacity();
  return static_cast<double>(doubles * sizeof(double) + ints * sizeof(int));
}

}    // namespace SPHSolid

#include "sph_solid_sweeps_viscous.h"

#endif
