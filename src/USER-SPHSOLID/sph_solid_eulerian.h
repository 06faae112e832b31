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
   The sweeps of the Eulerian frame: neighbors and kernel gradients belong to
   the present positions; see sph_solid_sweeps.h.

   The class; its members are in
     sph_solid_eulerian_rows.h       storage, what neighbors read: messages, mirror images
     sph_solid_eulerian_viscous.h    switch of a viscosity, acceleration correction
     sph_solid_eulerian_heat.h       heat, virial
     sph_solid_sweeps_eulerian.cpp   gradient and force

   Every particle has a row of pairs, and a vector has some pairs of one particle.  What
   is read of neighbors lies in packed rows (sph_solid_rows.h).
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EULERIAN_H
#define LMP_SPH_SOLID_EULERIAN_H

#include "sph_solid_points.h"
#include "sph_solid_rows.h"

#include <utility>

using namespace SPHSolid;

// of one source file, sph_solid_sweeps_eulerian.cpp, as the compiler should know

namespace {

// a sweep asks for the data of pairs so many pairs ahead
constexpr int PAIRS_AHEAD = 64;

// call(k, left) for the pairs of a row from k on, a vector at a time, of which so many are left:
// a constant where the vector is whole.  Behind a row lie pairs of another one, or anything

using Whole = std::integral_constant<int, LANES>;

template <class Call> inline void each_vector(int n, Call call)
{
  int k = 0;
  for (; k + LANES <= n; k += LANES) call(k, Whole());
  if (k < n) call(k, n - k);
}

// numbers of pairs, 0 behind the row

inline Pack of_row(Pack numbers, Whole)
{
  return numbers;
}
inline Pack of_row(Pack numbers, int left)
{
  return where_positive(first_lanes(left), numbers, Pack(0.0));
}

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

template <int D> class EulerianSweeps : public PointSweeps<D> {
 public:
  EulerianSweeps(const Options &o, const std::vector<TypeData> &t) :
      PointSweeps<D>(o, t),
      ntensors((o.tensile ? 1 : 0) + (needs_rates(pair_form(o.viscosity)) ? 1 : 0)),
      stress_stride(extra(ntensors)), uniform(are_alike(t)),
      stride(uniform ? Kin::SHORT : Kin::STRIDE), da_in_rows(D == 2 && uniform),
      da_stride(uniform ? da_stride_of<true>() : da_stride_of<false>()),
      common_h(Base::largest(t, &TypeData::h)),
      common_near(o.hbar * Base::largest(t, &TypeData::spacing))
  {
  }

  void new_neighbors(const Particles &, const NeighborRows &, double) override;
  void pack_kinematics(const Particles &, const double *const *) override;
  int gradient(const Particles &, const NeighborRows &, double) override;
  int message_size(Message) const override;
  void pack(Message, int, double *) const override;
  void unpack(Message, const Particles &, int, const double *) override;
  void displace(const Particles &, int, int, const double *) override;
  void mirror_stress() override;
  void find_switch(const Particles &, const NeighborRows &) override;
  void mirror_switch() override;
  void force(const Particles &, const NeighborRows &) override;
  void correction(const Particles &, const NeighborRows &) override;
  void heat(const Particles &, const NeighborRows &, double *, bool) override;
  void virial(const Particles &, const NeighborRows &, double *) override;
  double time_step_limit(const Particles &, const NeighborRows &) const override;
  void velocity(int i, double *v) const override { std::copy_n(kin(i) + Kin::V, D, v); }
  int neighbor_count(int i) const override { return pairs.count[i]; }
  double memory_usage() const override;

 private:
  using Base = PointSweeps<D>;
  using Base::image_first, Base::image_j, Base::images, Base::needs_correction, Base::nparticles,
      Base::nthreads, Base::keeps_pairs, Base::lonely, Base::opt, Base::safe, Base::source_of,
      Base::types, Base::unit_factor;
  using Batch = typename Base::Batch;
  using Points = typename Base::Points;
  using Kin = Kinematics<D>;
  using Str = Stress<D>;
  static constexpr int VECTOR = Blocks<D>::VECTOR;

  const int ntensors, stress_stride;    // tensors that follow the fixed part of a stress row
  const bool uniform;                   // is there one smoothing length, and one spacing?
  const int stride;                     // of kinematic rows
  const bool da_in_rows;                // two dimensions: in place of lengths that all have
  const int da_stride;
  const double common_h, common_near;    // if so: what rows of others have as H and NEAR
  int nown = 0, nrows = 0;               // own; own and ghost with images

  // rows of kinematics, stress, and da where kinematic rows have no room for it
  Rows krow, srow, da_rows;
  std::vector<double> mu_max;    // largest approach rate of own particles, for a time step limit
  Pairs pairs;
  Room<double> near_weight;    // of pairs of nearest neighbors, for the correction
  Room<double> near_pull;      // weights safe: force on i = m_i/2 near_pull x_ij
  Room<double> pull;           // viscous force on i = -m_i/h0^(D+2) pull x_ij, kept for heat
  Room<double> crowd;          // of every pair, with artificial stress: (W/W(spacing))^n

  static bool are_alike(const std::vector<TypeData> &types)
  {
    const TypeData *one = nullptr;
    for (const TypeData &type : types) {
      if (type.h == 0.0) continue;    // no material
      if (one && (type.h != one->h || type.spacing != one->spacing)) return false;
      one = &type;
    }
    return true;
  }
  template <bool UNIFORM> static constexpr int stride_of()
  {
    return UNIFORM ? Kin::SHORT : Kin::STRIDE;
  }
  template <bool UNIFORM> static constexpr int da_stride_of()
  {
    return D == 2 && UNIFORM ? Kin::SHORT : VECTOR;
  }
  double *kin(int i) { return &krow[static_cast<std::size_t>(i) * stride]; }
  const double *kin(int i) const { return &krow[static_cast<std::size_t>(i) * stride]; }
  // of a kinematic row
  template <bool UNIFORM> double h_of(const double *row) const
  {
    return UNIFORM ? common_h : row[Kin::H];
  }
  template <bool UNIFORM> double near_of(const double *row) const
  {
    return UNIFORM ? common_near : row[Kin::NEAR];
  }
  double *da(int i) { return const_cast<double *>(std::as_const(*this).da(i)); }
  const double *da(int i) const
  {
    const double *first = da_in_rows ? krow.data() + Kin::LENGTHS + Kin::H_LANE : da_rows.data();
    return first + static_cast<std::size_t>(i) * da_stride;
  }
  double *str(int i) { return &srow[i * stress_stride]; }
  const double *str(int i) const { return &srow[i * stress_stride]; }
  // tensor k of those that follow the fixed part of a row
  static constexpr int extra(int k) { return Str::STRIDE + k * Blocks<D>::TENSOR; }
  int at_rate() const { return extra(opt.tensile ? 1 : 0); }    // velocity gradient in a row
  const double *u(int i) const { return kin(i) + Kin::V; }      // during heat: displacements

  Vector<D> separation(int i, int j) const
  {
    Vector<D> d;
    for (int a = 0; a < D; a++) d[a] = kin(i)[Kin::X + a] - kin(j)[Kin::X + a];
    return d;
  }
  bool is_lonely(int i) const { return needs_correction() && !(str(i)[Str::NSUM] > 0.0); }

  // rows
  void size_rows(const Particles &);
  void make_room_for_pairs(const NeighborRows &);
  int images_of(int i) const { return images.any() ? image_first[i + 1] - image_first[i] : 0; }
  void pack_constants(const Particles &, int i, double *row) const;
  void mirror_vectors(double *rows, int step) const;
  double *place_of(Message, int i);
  void write_rows(const Batch &, const Points &, const Tensor<D, Pack> &T, Pack K, Pack nsum);
  void write_tensors(const Batch &, int at, const Tensor<D, Pack> &);
  void prefetch_points(const Particles &, const Batch &) const;

  // gradient; of a batch
  struct Sums {
    Several<D> moment[LANES], velocity[LANES];    // sum V (x_j-x_i)(x)g and sum V (v_j-v_i)(x)g
    double nsum[LANES];                           // sum m_j Wbar
  };
  struct Scratch;
  template <bool UNIFORM, bool IMAGES> void gather(int i, int n, const int *list, Scratch &) const;
  template <bool UNIFORM> void find_pairs(int i, const NeighborRows &, Scratch &);
  template <bool UNIFORM> void find_factors(Scratch &);
  template <bool UNIFORM> void accumulate(int i, const Scratch &, Sums &, int lane);
  template <bool UNIFORM> void find_sums(const Batch &, const NeighborRows &, Scratch &, Sums &);
  int update(const Particles &, const Batch &, Sums &, double dt, double &plastic);
  Tensor<D, Pack> tension_stress(const Tensor<D, Pack> &) const;

  // force
  template <PairForm FORM, bool TENSILE, bool UNIFORM> void force_row(const Particles &, int i);
  template <PairForm FORM> void force_rows(const Particles &, const NeighborRows &);
  double whole_pull(int i, int pair) const;
  void lonely_pairs(const Particles &, int i);

  // correction.  call(weights, neighbors, da_i - da_j) for the nearest neighbors of i, some at a
  // time; behind the last one weights are 0
  template <class F> void each_few(int i, F call) const
  {
    const Pack own = load_few<D>(da(i));
    const int *j = pairs.j.data() + pairs.first[i];
    const double *weights = near_weight.data() + pairs.near_first[i];
    for (int k = 0; k < pairs.nearest[i]; k += Few<D>::N)
      call(load_few_weights<D>(weights + k), j + k, own - load_few<D>(da(0), j + k, da_stride));
  }
  Pack central_correction(int i);

  // heat.  Is the kept viscous force of every pair heat as it is?  A compatible correction heats
  // in a way of its own
  bool heats_pairs() const
  {
    return keeps_pairs() && !(needs_correction() && opt.heating == Heating::COMPATIBLE);
  }
  // is that of the correction found along with the work of other forces?
  bool heats_with_pairs() const { return needs_correction() && Base::heats_evenly(); }
  // what the forces of a row's pairs give to i while all particles move by u; of
  // the stress the half with sigma_i, of the viscosity half of each pair's
  struct Power {
    double stress = 0.0, viscous = 0.0, corrected = 0.0;
  };
  template <bool PULL, bool TENSILE, bool CORRECT, bool UNIFORM> Power pair_power(int i) const;
  template <class OfRow>
  typename Base::Totals sum_heat(const NeighborRows &, double *, OfRow) const;
  double lonely_power(int i) const;
  double heat_correction(int i) const;
  double standard_power(int i, const double *u) const;

  Several<D> row_virial(int i) const;
  Pack pair_force(int i, int pair, const Motion<D> &) const;
  Pack near_force(int i, int j, int near, const Motion<D> &) const;
};

}    // namespace

#endif
