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
   The Lagrangian frame: how long a step may be, and where the frame ends.  Members of
   LagrangianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_LIMITS_H
#define LMP_SPH_SOLID_LAGRANGIAN_LIMITS_H

#include "sph_solid_lagrangian.h"
#include "sph_solid_stretch.h"

namespace {

// the frame ends where the least principal stretch, or the stretch of a pair,
// falls below this
constexpr double LEAST_STRETCH = 0.01;

// the time step shrinks with the least principal stretch, but not further than
// this: a Courant number of 0.6 is then still stable
constexpr double STEP_STRETCH = 0.05;

// F of a block's particles at the last evaluation.  It is asked for in few steps: summed anew in these it
// costs less than its way to memory in all of them

template <int D, class Precision>
typename LagrangianSweeps<D, Precision>::Tensors
LagrangianSweeps<D, Precision>::deformation(int block) const
{
  const Number *i = columns.at(block * LANES);
  Neighbors neighbors(*this, block, T);
  const Places own(*this, i, X);
  TensorSums<D, Pack> sum;
  for (int slot = slots.first[block]; slot < slots.first[block + 1]; slot++) {
    const Number *j = neighbors(slot);
    Pack x[D], u[D], g[D];
    own.apart(j, X, x);
    displacement(i, j, x, -factor(slot, j), u, g);
    sum.add(u, g);
  }
  return Tensors::Identity() + sum.tensor() * load_correction(block);
}

/* ----------------------------------------------------------------------
   particles come closer with the least principal stretch, and so must the
   time step
------------------------------------------------------------------------- */

template <int D, class Precision>
double LagrangianSweeps<D, Precision>::time_step_limit(const Particles &p,
                                                       const NeighborRows &) const
{
  return least_limit(p, nullptr);
}

template <int D, class Precision>
double
LagrangianSweeps<D, Precision>::scaled_time_step_limit(const Particles &p,
                                                       const std::vector<double> &factors) const
{
  return least_limit(p, factors.data());
}

// factors: of types, or null.  Eigenvalues only where the bound could be the least of all

template <int D, class Precision>
double LagrangianSweeps<D, Precision>::least_limit(const Particles &p, const double *factors) const
{
  auto stretched = [](auto s) {
    using Real = decltype(s);
    return minimum(Real(1.0), maximum(Real(STEP_STRETCH), s));
  };
  auto share = [&](const Batch &batch) {
    const Pack factor = Base::of_types(p, batch, [&](int t) {
      return factors[t];
    });
    return minimum(factor * square_root(batch.load(p.volume) / batch.load(p.mass)), Pack(1.0));
  };
  return Base::least_of(blocks(), NO_LIMIT, [&](int first, int end) {
    double limit = NO_LIMIT;
    for (int block = first; block < end; block++) {
      const Batch batch = this->batch(block);
      const Number *i = columns.at(block * LANES);
      const Tensors Fi = deformation(block);
      Pack unstretched =
          Base::step_limit(Base::smoothing_lengths(p, batch), Base::shear_moduli(p, batch),
                           batch.load(p.rho), component(i, SOUND), load(&mu_max[block * LANES]));
      if (factors) unstretched *= share(batch);
      if (!(least(unstretched * stretched(stretch_bound<D>(Fi))) < limit)) continue;
      for (int m = 0; m < batch.n; m++)
        limit = std::min(limit, unstretched[m] * stretched(least_stretch<D>(of_lane<D>(Fi, m))));
    }
    return limit;
  });
}

/* ----------------------------------------------------------------------
   where the frame ends: F turned over, squeezed flat, or two partners on top
   of each other
------------------------------------------------------------------------- */

template <int D, class Precision> Overload LagrangianSweeps<D, Precision>::find_overload() const
{
  return first_found([this](int block) {
    return overload(block);
  });
}

// of the first block in which there is one

template <int D, class Precision>
template <class Find>
Overload LagrangianSweeps<D, Precision>::first_found(Find find) const
{
  const int n = blocks();
  const int block = Base::least_of(n, n, [&](int first, int end) {
    while (first < end && find(first).kind == Overload::NONE) first++;
    return first < end ? first : n;
  });
  return block < n ? find(block) : Overload();
}

// where distances cannot be told any more

template <int D, class Precision> Overload LagrangianSweeps<D, Precision>::find_torn() const
{
  if (!(ruler.furthest() > 0.0)) return {};
  return first_found([this](int block) {
    return torn(block);
  });
}

template <int D, class Precision> Overload LagrangianSweeps<D, Precision>::torn(int block) const
{
  const Places own_place(*this, columns.at(block * LANES), X);
  Neighbors neighbors(*this, block, T);
  for (int slot = slots.first[block]; slot < slots.first[block + 1]; slot++) {
    const Number *j = neighbors(slot);
    Pack x[D];
    own_place.apart(j, X, x);
    const Pack r2 = where_positive(-factor(slot, j), dot<D>(x, x), Pack(0.0));
    const unsigned lanes = larger_lanes(r2, Pack(ruler.furthest() * ruler.furthest()));
    for (int m = 0; m < particles_of(block); m++)
      if (lanes >> m & 1) return {Overload::APART, own[block * LANES + m], std::sqrt(r2[m])};
  }
  return {};
}

// of the first particle of a block that is beyond it

template <int D, class Precision> Overload LagrangianSweeps<D, Precision>::overload(int block) const
{
  const Tensors Fi = deformation(block);
  if (all_positive(room_left(Fi, block))) return {};
  for (int m = 0; m < particles_of(block); m++) {
    const Overload found = overload(of_lane<D>(Fi, m), block, m);
    if (found.kind != Overload::NONE) return found;
  }
  return {};
}

// positive for particles that are surely not beyond it

template <int D, class Precision>
typename LagrangianSweeps<D, Precision>::Pack
LagrangianSweeps<D, Precision>::room_left(const Tensors &Fi, int block) const
{
  Pack room = minimum(stretch_bound<D>(Fi) - LEAST_STRETCH, Fi.determinant());
  const Number *i = columns.at(block * LANES);
  const Places own(*this, i, X), own_reference(*this, i, REFERENCE);
  Neighbors neighbors(*this, block, T);
  for (int slot = slots.first[block]; slot < slots.first[block + 1]; slot++) {
    const Number *j = neighbors(slot);
    Pack x[D], reference[D], apart = 0.0;
    own.apart(j, X, x);
    own_reference.apart(j, REFERENCE, reference);
    for (int a = 0; a < D; a++)
      apart += x[a] * x[a] - LEAST_STRETCH * LEAST_STRETCH * reference[a] * reference[a];
    room = minimum(room, where_positive(-factor(slot, j), apart, Pack(1.0)));
  }
  return room;
}

template <int D, class Precision>
Overload LagrangianSweeps<D, Precision>::overload(const Tensor<D> &Fi, int block, int lane) const
{
  const int column = block * LANES + lane, i = own[column];
  if (slots.count[column] == 0) return {};
  const double J = Fi.determinant();
  if (!(J > 0.0)) return {Overload::TURNED_OVER, i, J};
  const double s = least_stretch<D>(Fi);
  if (s < LEAST_STRETCH) return {Overload::STRETCH, i, s};
  const Neighbors neighbors(*this, block, T);
  for (int slot = slots.first[block]; slot < slots.first[block + 1]; slot++) {
    if (slots.constants.of(slot)[Slots::FACTOR + lane] == 0.0f) continue;
    const int other = neighbors.column(slot, lane);
    double X2 = 0.0, x2 = 0.0;
    for (int a = 0; a < D; a++) {
      const double dX = Base::apart(column, other, REFERENCE + a);
      const double dx = Base::apart(column, other, X + a);
      X2 += dX * dX;
      x2 += dx * dx;
    }
    if (x2 < LEAST_STRETCH * LEAST_STRETCH * X2) return {Overload::OVERLAP, i, std::sqrt(x2 / X2)};
  }
  return {};
}

}    // namespace

#endif
