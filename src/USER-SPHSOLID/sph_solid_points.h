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
   What the sweeps of both frames do with particles, as opposed to pairs: the
   constitutive update of some at a time, the energy ledger, the time step.

   A frame fills in which particles are pairs (sph_solid_eulerian.h,
   sph_solid_lagrangian.h); how they lie in memory is the same (sph_solid_column_*.h).
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_POINTS_H
#define LMP_SPH_SOLID_POINTS_H

#include "sph_solid_eos.h"
#include "sph_solid_kernel.h"
#include "sph_solid_lanes.h"
#include "sph_solid_storage.h"
#include "sph_solid_strength.h"
#include "sph_solid_sweeps.h"
#include "sph_solid_switch.h"
#include "sph_solid_threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <type_traits>

namespace SPHSolid {

// the bits of a LAMMPS neighbor index that are the index (NEIGHMASK)
constexpr int INDEX_MASK = 0x1FFFFFFF;

// longer than any time step [time]
constexpr double NO_LIMIT = 1.0e300;

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

template <int D> class PointSweeps : public Sweeps {
 public:
  PointSweeps(const Options &o, const std::vector<TypeData> &t) :
      opt(o), types(t), unit_factor(std::pow(largest(t, &TypeData::h), -(D + 2)))
  {
    for (const TypeData &type : types) {
      strengths.push_back(strength_constants(type.material));
      eos_of_types.push_back(eos_constants(type.material));
    }
  }
  bool sweeps_for_switch() const override { return opt.viscosity == Viscosity::FRONT; }
  bool needs_correction() const override { return opt.viscosity == Viscosity::CORRECT; }

 protected:
  Options opt;
  std::vector<TypeData> types;
  // 1/h0^(D+2), h0 the largest smoothing length, so that kernel gradients stored in single precision
  // are of order 1 in any units
  const double unit_factor;
  // of types that have a material; value: a member, or a function of the type
  template <class Value> static double largest(const std::vector<TypeData> &types, Value value)
  {
    double most = 0.0;
    for (const TypeData &type : types)
      if (type.h > 0.0) most = std::max<double>(most, std::invoke(value, type));
    return most;
  }
  static double least_h(const std::vector<TypeData> &types)
  {
    double least = NO_LIMIT;
    for (const TypeData &type : types)
      if (type.h > 0.0) least = std::min(least, type.h);
    return least;
  }
  std::vector<StrengthConstants<>> strengths;    // of the types
  std::vector<EosConstants<>> eos_of_types;
  std::vector<int> image_first, image_j;    // candidates among the images
  int nparticles = 0;                       // own and ghosts, before images

  // the particle that a row belongs to: for an image, that which it is one of
  int source_of(int row) const
  {
    return row < nparticles ? row : images.source_of(row - nparticles);
  }
  void find_image_candidates(const Particles &, const NeighborRows &, double **x, double reach);
  bool lonely = false;    // a particle here has no nearest neighbor: its viscosity stays whole
  // is the heat of a corrected pair the same from both sides, -1/4 sum w_ij (u_i - u_j).(da_i - da_j)?
  bool heats_evenly() const
  {
    return opt.heating == Heating::COMPATIBLE && opt.weights == Weights::CONSERVATIVE;
  }
  bool safe() const { return needs_correction() && opt.weights == Weights::SAFE; }
  // m_j Wbar_ij; near: supports of Wbar of both, whose mean is that of the pair
  template <class Real> static Real wbar_mass(Real r, Real mass, Real near_i, Real near_j)
  {
    return mass * CubicSpline<D>::w(r, Real(0.25 * (near_i + near_j)));
  }
  // is the viscous force of every pair kept for heat?
  bool keeps_pairs() const
  {
    if (opt.viscosity == Viscosity::NONE) return false;
    return !needs_correction() || opt.heating == Heating::PRINTED || lonely;
  }
  // of an elastic wave, c that of the bulk
  template <class Real> static Real longitudinal_speed(Real c, Real shear, Real inv_rho)
  {
    return square_root(c * c + (4.0 / 3.0) * shear * inv_rho);
  }
  template <class Real> Real step_limit(Real h, Real shear, Real rho, Real c, Real mu_max) const;

  // in a hybrid, others may have none
  bool has_material(const Particles &p, int i) const { return types[p.type[i]].h > 0.0; }

  // as many own particles as a pack has lanes; at the end of a list the last one fills up
  template <class Pack> struct BatchOf {
    static constexpr int LANES = lanes_of<Pack>;
    int i[LANES], n;
    bool consecutive;    // they lie one after the other in arrays
    // those from i on
    explicit BatchOf(int from) : n(LANES), consecutive(true) { std::iota(i, i + LANES, from); }
    BatchOf(const NeighborRows &list, int first) : n(std::min(LANES, list.inum - first))
    {
      const int *from = list.ilist + first;
      if (n == LANES)
        std::copy(from, from + LANES, i);
      else
        for (int m = 0; m < LANES; m++) i[m] = from[std::min(m, n - 1)];
      int apart = 0;    // without branches: the compiler compares all lanes at once
      for (int m = 0; m < LANES; m++) apart |= i[m] ^ (i[0] + m);
      consecutive = apart == 0;
    }
    Pack load(const double *array) const
    {
      return of_parts<Pack>([&](auto part) {
        return load_part<part()>(array);
      });
    }
    void store(double *array, Pack v) const
    {
      each_part<Pack>([&](auto part) {
        store_part<part()>(array, part_of<part()>(v));
      });
    }
    // array += v, in double precision
    void add(double *array, Pack v) const
    {
      each_part<Pack>([&](auto part) {
        store_part<part()>(array, load_part<part()>(array) + part_of<part()>(v));
      });
    }
    // those of a part, if there are any
    template <int part> int left() const { return n - part * SPHSolid::LANES; }
    template <int part> BatchOf<SPHSolid::Pack> part_of_batch() const
    {
      if (consecutive && left<part>() >= SPHSolid::LANES)
        return BatchOf<SPHSolid::Pack>(i[part * SPHSolid::LANES]);
      NeighborRows list = {left<part>(), const_cast<int *>(i) + part * SPHSolid::LANES, nullptr,
                           nullptr};
      return {list, 0};
    }

   private:
    template <int part> SPHSolid::Pack load_part(const double *array) const
    {
      return consecutive ? SPHSolid::load(array + i[part * SPHSolid::LANES])
                         : load_each<part>(array);
    }
    template <int part> void store_part(double *array, SPHSolid::Pack v) const
    {
      if (consecutive)
        SPHSolid::store(array + i[part * SPHSolid::LANES], v);
      else
        store_each<part>(array, v);
    }
    // apart from these, so that the compiler finds those small
    template <int part> SPHSolid::Pack load_each(const double *array) const
    {
      return pack_of([&](int m) {
        return array[i[part * SPHSolid::LANES + m]];
      });
    }
    template <int part> void store_each(double *array, SPHSolid::Pack v) const
    {
      const int end = std::min(left<part>(), SPHSolid::LANES);
      for (int m = 0; m < end; m++) array[i[part * SPHSolid::LANES + m]] = v[m];
    }
  };
  using Batch = BatchOf<Pack>;
  // the type that all particles of a batch have, or -1
  template <class Pack> static int common_type(const Particles &p, const BatchOf<Pack> &batch)
  {
    const int type = p.type[batch.i[0]];
    int others = 0;
    for (const int i : batch.i) others |= p.type[i] ^ type;
    return others == 0 ? type : -1;
  }
  // value(type) of each particle, common: what common_type() has found
  template <class Pack, class F>
  static Pack of_types(const Particles &p, const BatchOf<Pack> &batch, int common, F value)
  {
    if (common >= 0) return Pack(value(common));
    return pack_of<Pack>([&](int m) {
      return value(p.type[batch.i[m]]);
    });
  }
  template <class Pack, class F>
  static Pack of_types(const Particles &p, const BatchOf<Pack> &batch, F value)
  {
    return of_types(p, batch, common_type(p, batch), value);
  }
  template <class Pack> Pack smoothing_lengths(const Particles &p, const BatchOf<Pack> &batch) const
  {
    return of_types(p, batch, [this](int t) {
      return types[t].h;
    });
  }
  template <class Pack> Pack shear_moduli(const Particles &p, const BatchOf<Pack> &batch) const
  {
    return of_types(p, batch, [this](int t) {
      return types[t].material.shear;
    });
  }
  template <class Pack> struct PointsOf {
    PointState<D, Pack> state;
    PressureState<Pack> eos;
    Tensor<D, Pack> sigma;    // Cauchy stress, tension positive
    Pack plastic_work;        // of this step [energy]
    Pack inv_rho;
  };
  using Points = PointsOf<Pack>;
  // of the first n particles of a batch
  template <class Pack> static double sum_of_first(Pack v, int n)
  {
    return sum(n < lanes_of<Pack> ? where_lanes(first_lanes(n), v, Pack(0.0)) : v);
  }
  static void load_deviator(const Particles &, const Batch &, PointState<D, Pack> &);
  static void store_deviator(const Particles &, const Batch &, PointState<D, Pack> &);
  Points update_points(const Particles &, const Batch &, const Tensor<D, Pack> &L_mid, double dt);
  PointsOf<WidePack> update_points(const Particles &, const BatchOf<WidePack> &,
                                   const Tensor<D, WidePack> &L_mid, double dt);
  // what update_points() reads of n particles from next on
  static void prefetch_state(const Particles &p, int next, int n)
  {
    prefetch(p.stress[0] + 6 * std::ptrdiff_t(next), 6 * n);
    const double *arrays[] = {p.rho, p.epl, p.e, p.mass, p.volume};
    for (const double *array : arrays) prefetch(array + next, n);
  }
  template <class Pack> static int unphysical(const BatchOf<Pack> &, Pack rho, Pack others);
  template <class Pack> Pack own_switch(const Tensor<D, Pack> &L, Pack c, Pack h) const;

  // sums of one evaluation as the ledger has them
  struct Totals {
    double plastic = 0.0, viscous = 0.0, standard = 0.0, hourglass = 0.0;
    int uncorrected = 0;    // eulerian: particles with neighbors and B = 1
    static void add(Totals &sum, const Totals &t)
    {
      sum.plastic += t.plastic;
      sum.viscous += t.viscous;
      sum.standard += t.standard;
      sum.hourglass += t.hourglass;
      sum.uncorrected += t.uncorrected;
    }
  };
  void enter(const Totals &, double factor);

  // six numbers from of_share(first, end) for the shares of n particles or blocks, which add to the virial
  // of a pair style; the least of others
  using Six = std::array<double, 6>;
  template <class Call> void add_virial(int n, double *six, Call of_share) const
  {
    const Six total = join_shares(nthreads, n, Six(), of_share, [](Six &sum, const Six &share) {
      for (int k = 0; k < 6; k++) sum[k] += share[k];
    });
    for (int k = 0; k < 6; k++) six[k] += total[k];
  }
  template <class Real, class Call> Real least_of(int n, Real most, Call of_share) const
  {
    return join_shares(nthreads, n, most, of_share, [](Real &least, Real share) {
      least = std::min(least, share);
    });
  }
};

// candidates among the images: those of every neighbor and of i itself, at x

template <int D>
void PointSweeps<D>::find_image_candidates(const Particles &p, const NeighborRows &list, double **x,
                                           double reach)
{
  if (!images.any()) return;
  images.find(p.nall, x, reach, [&](int i) {
    return has_material(p, i);
  });
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

/* ----------------------------------------------------------------------
   the deviatoric stress in LAMMPS's order, xx, yy, zz, xy, xz, yz: in two
   dimensions one block has all of it, in three a second one begins at zz
------------------------------------------------------------------------- */

template <int D>
void PointSweeps<D>::load_deviator(const Particles &p, const Batch &batch,
                                   PointState<D, Pack> &state)
{
  auto columns = [&](int at, Pack *c) {
    for (int m = 0; m < BLOCK; m++) c[m] = load(Addresses(p.stress[0], 6, batch.i + m) + at);
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

template <int D>
void PointSweeps<D>::store_deviator(const Particles &p, const Batch &batch,
                                    PointState<D, Pack> &state)
{
  for (int a = 0; a < D; a++)
    for (int b = 0; b < a; b++) state.S(a, b) = state.S(b, a);
  auto store_columns = [&](int at, Pack a, Pack b, Pack c, Pack d) {
    transpose(a, b, c, d);
    const Pack rows[BLOCK] = {a, b, c, d};
    for (int m = 0; m < BLOCK; m++) store(Addresses(p.stress[0], 6, batch.i + m) + at, rows[m]);
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

template <int D>
typename PointSweeps<D>::Points
PointSweeps<D>::update_points(const Particles &p, const Batch &batch, const Tensor<D, Pack> &L_mid,
                              double dt)
{
  const int common = common_type(p, batch);
  auto of = [&](const auto &list, auto member) {
    return of_types(p, batch, common, [&](int t) {
      return list[t].*member;
    });
  };
  Points points;
  PointState<D, Pack> &state = points.state;
  state.rho = batch.load(p.rho);
  load_deviator(p, batch, state);
  const Pack mass = batch.load(p.mass);
  Pack plastic_work_density = 0.0;

  if (dt > 0.0) {
    using R = StrengthConstants<>;
    const StrengthConstants<Pack> r = {of(strengths, &R::shear), of(strengths, &R::Y),
                                       of(strengths, &R::H)};
    state.epl = batch.load(p.epl);
    plastic_work_density = advance<D, Pack>(r, state, L_mid, dt);
    batch.store(p.rho, state.rho);
    batch.store(p.epl, state.epl);
    store_deviator(p, batch, state);
  }

  using C = EosConstants<>;
  const EosConstants<Pack> k = {of(eos_of_types, &C::a0), of(eos_of_types, &C::b0),
                                of(eos_of_types, &C::c0), of(eos_of_types, &C::Gamma)};
  const Densities<Pack> densities(state.rho, mass / batch.load(p.volume));
  points.eos = pressure(k, densities, batch.load(p.e));
  points.inv_rho = densities.inv_rho;
  points.plastic_work = plastic_work_density * mass * densities.inv_rho;
  points.sigma = state.S - points.eos.P * Tensor<D, Pack>::Identity();
  return points;
}

// the same of a wide batch: velocity gradients come and numbers go in single precision, the state of particles is
// in double precision in between.  Lanes behind the last particle have what others have

template <int D>
typename PointSweeps<D>::template PointsOf<WidePack>
PointSweeps<D>::update_points(const Particles &p, const BatchOf<WidePack> &batch,
                              const Tensor<D, WidePack> &L_mid, double dt)
{
  auto update = [&](auto part) {
    Tensor<D, Pack> L;
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) L(a, b) = part_of<part()>(L_mid(a, b));
    return update_points(p, batch.template part_of_batch<part()>(), L, dt);
  };
  const Points first = update(std::integral_constant<int, 0>());
  const Points second = batch.template left<1>() > 0 ? update(std::integral_constant<int, 1>())
                                                     : first;
  PointsOf<WidePack> both;
  both.state.rho = joined(first.state.rho, second.state.rho);
  both.eos = {joined(first.eos.P, second.eos.P), joined(first.eos.c2, second.eos.c2)};
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) {
      both.state.S(a, b) = joined(first.state.S(a, b), second.state.S(a, b));
      both.sigma(a, b) = joined(first.sigma(a, b), second.sigma(a, b));
    }
  both.plastic_work = joined(first.plastic_work, second.plastic_work);
  both.inv_rho = joined(first.inv_rho, second.inv_rho);
  return both;
}

// a particle whose density is not positive, or another number of whom is not
// finite; or -1

template <int D>
template <class Pack>
int PointSweeps<D>::unphysical(const BatchOf<Pack> &batch, Pack rho, Pack others)
{
  // sum - sum is 0 or not a number
  const Pack sum = rho + others;
  if (all_positive(rho) && all_positive(1.0 + (sum - sum))) return -1;
  for (int m = 0; m < lanes_of<Pack>; m++)
    if (!(rho[m] > 0.0) || !std::isfinite(sum[m])) return batch.i[m];
  return -1;
}

/* ----------------------------------------------------------------------
   switches of the viscosity.  That of "front" is how much of the deformation of
   a particle is compression, known from its own velocity gradient, times how
   much of the motion around it is not resolved, which takes one more sweep
------------------------------------------------------------------------- */

template <int D>
template <class Pack>
Pack PointSweeps<D>::own_switch(const Tensor<D, Pack> &L, Pack c, Pack h) const
{
  if (opt.viscosity == Viscosity::FRONT) return compression_share<D, Pack>(L);
  return balsara_switch<D, Pack>(L, c, h);
}

/* ----------------------------------------------------------------------
   h/(c_L + 0.6 (a1 c + a2 |mu|)), the viscous part as far as it is retained: the form is that of
   Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543; what is retained, doc/fix_sph_solid_dt.rst
------------------------------------------------------------------------- */

template <int D>
template <class Real>
Real PointSweeps<D>::step_limit(Real h, Real shear, Real rho, Real c, Real mu_max) const
{
  const double retained = opt.viscosity == Viscosity::NONE ? 0.0
      : needs_correction()                                 ? CORRECTION_RETAINS
                                                           : 1.0;
  const Real c_l = longitudinal_speed(c, shear, Real(1.0 / rho));
  return h / (c_l + 0.6 * retained * (opt.a1 * c + opt.a2 * mu_max));
}

template <int D> void PointSweeps<D>::enter(const Totals &t, double factor)
{
  ledger.plastic_work += t.plastic;
  ledger.viscous_heat += factor * t.viscous;
  ledger.hourglass += factor * t.hourglass;
  if (needs_correction()) ledger.returned += factor * (t.standard - t.viscous);
}

}    // namespace SPHSolid

#endif
