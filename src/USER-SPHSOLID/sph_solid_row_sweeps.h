/* ----------------------------------------------------------------------
   Sweeps over rows: of every particle a list of pairs, and packed rows of particles
   that neighbors read.  Ghosts and mirror images, the acceleration correction, heat.

   For the Eulerian frame (sph_solid_sweeps_eulerian.cpp), whose neighbors change.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_ROW_SWEEPS_H
#define LMP_SPH_SOLID_ROW_SWEEPS_H

#include "sph_solid_points.h"
#include "sph_solid_rows.h"

namespace SPHSolid {

// a sweep asks for the data of pairs so many pairs ahead
constexpr int PAIRS_AHEAD = 64;

// call with flags as constants

template <class Call> void with_flags(Call call)
{
  call();
}
template <class Call, class... Flags> void with_flags(Call call, bool first, Flags... others)
{
  if (first)
    with_flags(
        [&](auto... flags) {
          call(std::true_type(), flags...);
        },
        others...);
  else
    with_flags(
        [&](auto... flags) {
          call(std::false_type(), flags...);
        },
        others...);
}

template <int D> class RowSweeps : public PointSweeps<D> {
 public:
  // ntensors: how many tensors follow the fixed part of a stress row
  RowSweeps(const Options &o, const std::vector<TypeData> &t, int ntensors_) :
      PointSweeps<D>(o, t), ntensors(ntensors_), stress_stride(extra(ntensors_))
  {
  }

  void pack_kinematics(const Particles &, const double *const *) override;
  int message_size(Message) const override;
  void pack(Message, int, double *) const override;
  void unpack(Message, const Particles &, int, const double *) override;
  void mirror_stress() override;
  void mirror_switch() override;
  void correction(const Particles &, const NeighborRows &) override;
  double time_step_limit(const Particles &, const NeighborRows &) const override;
  int neighbor_count(int i) const override { return pairs.count[i]; }
  double memory_usage() const override;

 protected:
  using Base = PointSweeps<D>;
  using Base::image_first, Base::image_j, Base::images, Base::needs_correction, Base::nparticles,
      Base::nthreads, Base::opt, Base::keeps_pairs, Base::lonely, Base::safe, Base::source_of,
      Base::types;
  using Batch = typename Base::Batch;
  using Points = typename Base::Points;
  using Kin = Kinematics<D>;
  using Str = Stress<D>;
  static constexpr int VECTOR = Blocks<D>::VECTOR;

  int ntensors, stress_stride;
  int nown = 0, nrows = 0;    // own; own and ghost with images

  Rows krow, srow, da;           // rows of kinematics, stress, da
  std::vector<double> mu_max;    // largest approach rate of own particles
  Pairs pairs;
  std::vector<double> near_weight;    // of pairs of nearest neighbors, for the correction
  std::vector<double> near_pull;      // weights safe: force on i = m_i/2 near_pull x_ij
  std::vector<double> pull;    // viscous force on i = -own weight * pull * x_ij, kept for heat

  const double *kin(int i) const { return &krow[i * Kin::STRIDE]; }
  double *str(int i) { return &srow[i * stress_stride]; }
  const double *str(int i) const { return &srow[i * stress_stride]; }
  // tensor k of those that follow the fixed part of a row
  static constexpr int extra(int k) { return Str::STRIDE + k * Blocks<D>::TENSOR; }

  Vector<D> separation(int i, int j) const
  {
    Vector<D> d;
    for (int a = 0; a < D; a++) d[a] = kin(i)[Kin::X + a] - kin(j)[Kin::X + a];
    return d;
  }
  bool is_lonely(int i) const { return needs_correction() && !(str(i)[Str::NSUM] > 0.0); }

  void size_rows(const Particles &, const NeighborRows &);
  void mirror_vectors(double *rows, int stride) const;
  double *place_of(Message, int i);

  void write_rows(const Batch &, const Points &, const Tensor<D, Pack> &T, Pack K, Pack nsum);
  void write_tensors(const Batch &, int at, const Tensor<D, Pack> &);
  void prefetch_points(const Particles &, const Batch &) const;

  // is the kept viscous force of every pair heat as it is?  A compatible correction heats in a way of its own
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
    const Pack own = load_few<D>(&da[i * VECTOR]);
    const int first = pairs.first[i], end = first + pairs.nearest[i];
    for (int k = first; k < end; k += Few<D>::N) {
      const int *j = &pairs.j[k];
      call(load_few_weights<D>(&near_weight[k]), j, own - load_few<D>(da.data(), j, VECTOR));
    }
  }
  double lonely_power(int i) const;
  const double *u(int i) const { return kin(i) + Kin::V; }    // during heat: displacements

  // of the frame: what a kinematic row has of a particle besides its motion, its volume weight
  virtual void pack_constants(const Particles &, int i, double *row) const = 0;
  virtual double weight_volume(const Particles &, int i) const = 0;

  // what the forces of a row's pairs give to i while all particles move by u; of
  // the stress the half with sigma_i, of the viscosity half of each pair's
  struct Power {
    double stress = 0.0, viscous = 0.0, corrected = 0.0;
  };
  template <class OfRow> void sum_heat(const NeighborRows &, double *, bool book, OfRow of_row);
  double heat_correction(int i) const;
  // is it found along with the work of other forces?
  bool heats_with_pairs() const { return needs_correction() && Base::heats_evenly(); }
  double standard_power(int i, const double *u) const;

  Pack central_correction(int i);
  Pack near_force(int i, int pair, const Motion<D> &d) const;
  template <class OfRow> void sum_virial(const NeighborRows &, double *six, OfRow of_row) const;

  void sum_switch(const Particles &, const NeighborRows &, int at_rate);
};

/* ----------------------------------------------------------------------
   storage
------------------------------------------------------------------------- */

template <int D> void RowSweeps<D>::size_rows(const Particles &p, const NeighborRows &list)
{
  nown = p.nlocal;
  nparticles = p.nall;
  nrows = p.nall + (images.any() ? images.count() : 0);
  krow.resize(static_cast<std::size_t>(nrows) * Kin::STRIDE);
  srow.resize(static_cast<std::size_t>(nrows) * stress_stride);
  if (needs_correction()) da.resize(static_cast<std::size_t>(nrows) * VECTOR);
  mu_max.assign(p.nlocal, 0.0);
  pairs.first.assign(p.nlocal + 1, 0);
  pairs.count.assign(p.nlocal, 0);
  pairs.nearest.assign(p.nlocal, 0);

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
  each_share(nthreads, nrows, [&](int first, int end) {
    for (int row = first; row < end; row++)
      pack_constants(p, source_of(row), &krow[static_cast<std::size_t>(row) * Kin::STRIDE]);
  });
}

/* ---------------------------------------------------------------------- */

template <int D> void RowSweeps<D>::pack_kinematics(const Particles &p, const double *const *v)
{
  double *rows = krow.data();
  each_share(nthreads, p.nall, [&](int first, int end) {
    for (int i = first; i < end; i++) {
      double *row = rows + static_cast<std::size_t>(i) * Kin::STRIDE;
      const double *x = p.x[i], *vi = v[i];
      for (int a = 0; a < D; a++) {
        row[Kin::X + a] = x[a];
        row[Kin::V + a] = vi[a];
      }
      row[Kin::VOLUME] = weight_volume(p, i);
    }
  });
  for (int k = 0; k < nrows - p.nall; k++) {
    const double *from = kin(images.source_of(k));
    double *row = &krow[(p.nall + k) * Kin::STRIDE];
    double sign[3];
    images.signs(k, sign);
    images.template position<D>(k, from + Kin::X, row + Kin::X);
    for (int a = 0; a < D; a++) row[Kin::V + a] = sign[a] * from[Kin::V + a];
    row[Kin::VOLUME] = from[Kin::VOLUME];
  }
}

template <int D>
void RowSweeps<D>::write_rows(const Batch &batch, const Points &points, const Tensor<D, Pack> &T,
                              Pack K, Pack nsum)
{
  write_tensors(batch, Str::T, T);
  Pack rho = points.state.rho, c = square_root(maximum(points.eos.c2, Pack(0.0)));
  transpose(K, rho, c, nsum);
  const Pack state[BLOCK] = {K, rho, c, nsum};
  for (int m = 0; m < BLOCK; m++)
    store(batch.rows(srow.data(), m, stress_stride) + Str::K, state[m]);
}

// one tensor of the rows

template <int D>
void RowSweeps<D>::write_tensors(const Batch &batch, int at, const Tensor<D, Pack> &t)
{
  Several<D> rows[BLOCK];
  from_lanes<D>(t, rows);
  for (int m = 0; m < BLOCK; m++)
    store_tensor(batch.rows(srow.data(), m, stress_stride) + at, rows[m]);
}

// what the next batch needs, if it lies behind this one

template <int D> void RowSweeps<D>::prefetch_points(const Particles &p, const Batch &batch) const
{
  const int next = batch.i[0] + LANES;
  if (next + LANES > nown) return;
  Base::prefetch_state(p, next);
  prefetch(str(next), LANES * stress_stride);
}

/* ----------------------------------------------------------------------
   rows of ghosts and images
------------------------------------------------------------------------- */

template <int D> int RowSweeps<D>::message_size(Message what) const
{
  if (what == Message::STRESS) return stress_stride;
  return what == Message::SWITCH ? 1 : D;
}

template <int D> double *RowSweeps<D>::place_of(Message what, int i)
{
  if (what == Message::STRESS) return str(i);
  if (what == Message::SWITCH) return str(i) + Str::SWITCH;
  return what == Message::VISCOUS ? &da[i * VECTOR] : &krow[i * Kin::STRIDE + Kin::V];
}

template <int D> void RowSweeps<D>::pack(Message what, int i, double *out) const
{
  const double *from = const_cast<RowSweeps *>(this)->place_of(what, i);
  std::copy(from, from + message_size(what), out);
}

template <int D>
void RowSweeps<D>::unpack(Message what, const Particles &p, int i, const double *in)
{
  std::copy(in, in + message_size(what), place_of(what, i));
  if (what == Message::STRESS) p.rho[i] = in[Str::RHO];
}

// a tensor of an image is Q T Q^T with Q = diag(sign): component (a,b) times
// both signs

template <int D> void RowSweeps<D>::mirror_stress()
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

  if (needs_correction()) {
    lonely = false;
    for (int i = 0; i < nrows; i++) lonely = lonely || !(str(i)[Str::NSUM] > 0.0);
  }
  if (keeps_pairs()) pull.resize(pairs.j.size());
}

template <int D> void RowSweeps<D>::mirror_vectors(double *rows, int stride) const
{
  for (int k = 0; k < nrows - nparticles; k++) {
    double sign[3];
    images.signs(k, sign);
    for (int a = 0; a < D; a++)
      rows[(nparticles + k) * stride + a] = sign[a] * rows[images.source_of(k) * stride + a];
  }
}

template <int D>
double RowSweeps<D>::time_step_limit(const Particles &p, const NeighborRows &list) const
{
  return Base::least_of(list.inum, NO_LIMIT, [&](int first, int end) {
    double limit = NO_LIMIT;
    for (int ii = first; ii < end; ii++) {
      const int i = list.ilist[ii];
      const double *row = str(i);
      const TypeData &type = types[p.type[i]];
      limit = std::min(
          limit,
          Base::step_limit(type.h, type.material.shear, row[Str::RHO], row[Str::C], mu_max[i]));
    }
    return limit;
  });
}

template <int D> double RowSweeps<D>::memory_usage() const
{
  const std::size_t doubles = krow.capacity() + srow.capacity() + da.capacity() +
      mu_max.capacity() + pull.capacity() + pairs.factor.capacity() + near_weight.capacity() +
      near_pull.capacity();
  const std::size_t ints = pairs.first.capacity() + pairs.count.capacity() +
      pairs.nearest.capacity() + pairs.j.capacity() + image_first.capacity() + image_j.capacity();
  return static_cast<double>(doubles * sizeof(double) + ints * sizeof(int));
}

}    // namespace SPHSolid

#include "sph_solid_row_sweeps_viscous.h"

#endif
