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
   What a pair needs, in packs of blocks: differences of motion, tensors of a
   row, and products of the two, alike in two and three dimensions.  A pack
   has one block, or two for two pairs at a time (sph_solid_blocks.h).

   In two dimensions one block holds a whole tensor, T = {xx, xy, yx, yy}, and a
   vector a takes part in products either "spread", {ax, ay, ax, ay}, or
   "expanded", {ax, ax, ay, ay}.  In three dimensions a tensor is three blocks,
   its columns; spread is every component in a block of its own, and expanded
   is the vector itself.  Then in both

     T.g    = fold(times(T, spread(g)))
     a.T.g  = sum of the lanes of expand(a) * times(T, spread(g))
     a (x) g: block b = expand(a) * spread(g) block b
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LANES_H
#define LMP_SPH_SOLID_LANES_H

#include "sph_solid_blocks.h"
#include "sph_solid_rows.h"
#include "sph_solid_tensor.h"

#include <utility>

namespace SPHSolid {

// call(0), call(1), ... call(N - 1), as constants: with a loop over three components the compiler keeps
// sums over pairs in memory instead of registers.  Never a function of its own, whatever the compiler
// thinks of its size

template <class Call, int... k>
[[gnu::always_inline]] inline void each_index(const Call &call, std::integer_sequence<int, k...>)
{
  (call(std::integral_constant<int, k>()), ...);
}
template <int N, class Call> [[gnu::always_inline]] inline void each_index(const Call &call)
{
  each_index(call, std::make_integer_sequence<int, N>());
}

// one block in two dimensions, three in three

template <int D> struct Several {
  static constexpr int N = (D == 2) ? 1 : 3;
  Pack block[N];

  static Several zero()
  {
    Several s;
    for (int b = 0; b < N; b++) s.block[b] = Pack(0.0);
    return s;
  }
};

template <int D> inline Several<D> operator+(const Several<D> &a, const Several<D> &b)
{
  Several<D> s;
  for (int n = 0; n < Several<D>::N; n++) s.block[n] = a.block[n] + b.block[n];
  return s;
}

template <int D> inline Several<D> operator*(const Several<D> &a, Pack factor)
{
  Several<D> s;
  for (int n = 0; n < Several<D>::N; n++) s.block[n] = a.block[n] * factor;
  return s;
}

template <int D> inline Several<D> load_tensor(const Addresses &row)
{
  Several<D> t;
  for (int n = 0; n < Several<D>::N; n++) t.block[n] = load(row + n * BLOCK);
  return t;
}

// the same one in every block

template <int D> inline Several<D> load_tensor(const double *row)
{
  Several<D> t;
  for (int n = 0; n < Several<D>::N; n++) t.block[n] = load_block(row + n * BLOCK);
  return t;
}

template <int D> inline void store_tensor(const Addresses &row, const Several<D> &t)
{
  for (int n = 0; n < Several<D>::N; n++) store(row + n * BLOCK, t.block[n]);
}

template <int D> inline Pack times(const Several<D> &T, const Several<D> &g)
{
  Pack s = T.block[0] * g.block[0];
  for (int n = 1; n < Several<D>::N; n++) s = multiply_add(T.block[n], g.block[n], s);
  return s;
}

// a vector in the first lanes of each block, spread

template <int D> inline Several<D> spread(Pack v)
{
  if constexpr (D == 2)
    return {shuffle<0, 1, 0, 1>(v)};
  else
    return {shuffle<0, 0, 0, 0>(v), shuffle<1, 1, 1, 1>(v), shuffle<2, 2, 2, 2>(v)};
}

// result += a (x) g, a expanded

template <int D> inline void add_outer(Several<D> &result, Pack a, const Several<D> &g)
{
  for (int n = 0; n < Several<D>::N; n++)
    result.block[n] = multiply_add(a, g.block[n], result.block[n]);
}

// all components times their counterparts

template <int D> inline double contract(const Several<D> &a, const Several<D> &b)
{
  return sum(times(a, b));
}

// component a of T.g from times(T, g), summed over pairs: in the first block

template <int D> inline double folded(Pack t, int a)
{
  return D == 2 ? t[2 * a] + t[2 * a + 1] : t[a];
}

// a vector as products with spread vectors take it: {fx, fx, fy, fy}, in three dimensions
// itself; from times(T, g), and from memory, D doubles and in three dimensions a 0

template <int D> inline Pack expanded(Pack t)
{
  return D == 2 ? t + shuffle<1, 0, 3, 2>(t) : t;
}
template <int D> inline Pack load_expanded(const Addresses &a)
{
  if constexpr (D == 2) {
    const Pack spread = load_two_twice(a);
    return shuffle<0, 0, 1, 1>(spread);
  } else
    return load(a);
}

// tensors of as many particles as there are lanes, one per lane: t[m] has those of particles
// m, m + 4 in its blocks

template <int D> inline Tensor<D, Pack> lanes_of(const Several<D> *t)
{
  Tensor<D, Pack> out;
  for (int n = 0; n < Several<D>::N; n++) {
    Pack a = t[0].block[n], b = t[1].block[n], c = t[2].block[n], d = t[3].block[n];
    transpose(a, b, c, d);
    if constexpr (D == 2)
      out << a, b, c, d;
    else
      out.col(n) << a, b, c;
  }
  return out;
}

template <int D> inline void from_lanes(const Tensor<D, Pack> &t, Several<D> *out)
{
  for (int n = 0; n < Several<D>::N; n++) {
    Pack a = D == 2 ? t(0, 0) : t(0, n), b = D == 2 ? t(0, 1) : t(1, n),
         c = D == 2 ? t(1, 0) : t(D - 1, n), d = D == 2 ? t(1, 1) : Pack(0.0);
    transpose(a, b, c, d);
    out[0].block[n] = a;
    out[1].block[n] = b;
    out[2].block[n] = c;
    out[3].block[n] = d;
  }
}

// sums over the pairs of LANES particles, one after the other and each spread over the
// blocks of a pack: t[m] becomes what lanes_of takes

template <int D> inline void add_blocks(Several<D> *t)
{
  for (int m = 0; m < BLOCK; m++)
    for (int n = 0; n < Several<D>::N; n++)
      t[m].block[n] = sums_of_blocks(t[m].block[n], t[m + LANES - BLOCK].block[n]);
}

template <int D> inline Pack dot(const Pack *v, const Pack *w)
{
  Pack s = v[0] * w[0];
  for (int a = 1; a < D; a++) s = multiply_add(v[a], w[a], s);
  return s;
}

// of as many pairs as there are lanes: a lane of each component belongs to one of them

template <int D> struct Components {
  Pack x[D], v[D];
  Pack free[2];    // three dimensions: what lies behind the vectors

  Pack x_dot_x() const { return dot<D>(x, x); }
  Pack v_dot_x() const { return dot<D>(v, x); }
  // sum += s x
  [[gnu::always_inline]] void add_to(Pack *sum, Pack s) const
  {
    each_index<D>([&](auto a) {
      sum[a] = multiply_add(s, x[a], sum[a]);
    });
  }
};

// sums of a (x) b over pairs, each of them in a lane of its own

template <int D> struct TensorSums {
  Pack sum[D][D];

  TensorSums()
  {
    each_index<D * D>([&](auto k) {
      sum[k / D][k % D] = 0.0;
    });
  }
  [[gnu::always_inline]] void add(const Pack *v, const Pack *w)
  {
    each_index<D * D>([&](auto k) {
      add_one<k()>(v, w);
    });
  }
  Tensor<D, Pack> symmetric_tensor() const    // after add_symmetric()
  {
    Tensor<D, Pack> t;
    each_index<D * D>([&](auto k) {
      t(k / D, k % D) = k / D > k % D ? sum[k % D][k / D] : sum[k / D][k % D];
    });
    return t;
  }
  Several<D> blocks() const { return blocks(false); }
  Tensor<D, Pack> tensor() const    // with all lanes as they are
  {
    Tensor<D, Pack> t;
    each_index<D * D>([&](auto k) {
      t(k / D, k % D) = sum[k / D][k % D];
    });
    return t;
  }
  // of w = v times a number: half of the components are those of the other half
  [[gnu::always_inline]] void add_symmetric(const Pack *v, const Pack *w)
  {
    each_index<D * D>([&](auto k) {
      if constexpr (k / D <= k % D) add_one<k()>(v, w);
    });
  }
  Several<D> symmetric_blocks() const { return blocks(true); }

 private:
  template <int k> [[gnu::always_inline]] void add_one(const Pack *v, const Pack *w)
  {
    sum[k / D][k % D] = multiply_add(v[k / D], w[k % D], sum[k / D][k % D]);
  }
  // yet to be summed over blocks
  Several<D> blocks(bool symmetric) const
  {
    auto at = [&](int a, int b) {
      return symmetric && a > b ? sum[b][a] : sum[a][b];
    };
    if constexpr (D == 2)
      return {sums(at(0, 0), at(0, 1), at(1, 0), at(1, 1))};
    else
      return {sums(at(0, 0), at(1, 0), at(2, 0), Pack(0.0)),
              sums(at(0, 1), at(1, 1), at(2, 1), Pack(0.0)),
              sums(at(0, 2), at(1, 2), at(2, 2), Pack(0.0))};
  }
};

// the sums over all lanes of D packs, in the first lanes

template <int D> inline Pack sums_of(const Pack *a)
{
  if constexpr (D == 2)
    return sum_of_blocks(sums(a[0], a[1], a[0], a[1]));
  else
    return sum_of_blocks(sums(a[0], a[1], a[2], a[2]));
}

// position and velocity of a row, or differences of these

template <int D> struct Motion;

template <> struct Motion<2> {
  Pack xv;    // x, y, vx, vy

  Motion() = default;
  explicit Motion(const double *row) : xv(load_block(row)) {}
  explicit Motion(const Addresses &row) : xv(load(row)) {}
  Motion operator-(const Motion &other) const
  {
    Motion d;
    d.xv = xv - other.xv;
    return d;
  }
  Pack expanded_x() const { return shuffle<0, 0, 1, 1>(xv); }
  Pack expanded_v() const { return shuffle<2, 2, 3, 3>(xv); }
  Several<2> spread_x() const { return spread<2>(xv); }

  // products with x, summed: over lanes 0 and 1 x.x, over the others v.x
  Pack products() const { return xv * shuffle<0, 1, 0, 1>(xv); }
  // the same with another vector, from load_vector()
  Pack products(Pack vector) const { return xv * vector; }
  static Pack load_vector(const Addresses &a) { return load_two_twice(a); }
  static double v_dot_x(Pack products)
  {
    const Pack s = sum_of_blocks(products);
    return s[2] + s[3];
  }
  // of each pair in a lane of its own
  static Components<2> components(const Motion *d)
  {
    Pack x = d[0].xv, y = d[1].xv, vx = d[2].xv, vy = d[3].xv;
    transpose(x, y, vx, vy);
    return {{x, y}, {vx, vy}, {}};
  }
};

template <> struct Motion<3> {
  Pack position, velocity;

  Motion() = default;
  // without what lies behind the vectors, so that differences have that of the other one, negative
  explicit Motion(const double *row) : Motion(Addresses(row))
  {
    const Pack vector = load_block(VECTOR);
    position *= vector;
    velocity *= vector;
  }
  explicit Motion(const Addresses &row) : position(load(row)), velocity(load(row + BLOCK)) {}
  Motion operator-(const Motion &other) const
  {
    Motion d;
    d.position = position - other.position;
    d.velocity = velocity - other.velocity;
    return d;
  }
  Pack expanded_x() const { return position; }
  Pack expanded_v() const { return velocity; }
  Several<3> spread_x() const { return spread<3>(position); }

  static constexpr double VECTOR[BLOCK] = {1.0, 1.0, 1.0, 0.0};

  // of v.x only
  Pack products() const { return velocity * position; }
  Pack products(Pack vector) const { return velocity * vector; }
  static Pack load_vector(const Addresses &a) { return load(a); }
  static double v_dot_x(Pack products) { return sum(products * load_block(VECTOR)); }
  static Components<3> components(const Motion *d)
  {
    Pack x[BLOCK], v[BLOCK];
    for (int m = 0; m < BLOCK; m++) {
      x[m] = d[m].position;
      v[m] = d[m].velocity;
    }
    transpose(x[0], x[1], x[2], x[3]);
    transpose(v[0], v[1], v[2], v[3]);
    return {{x[0], x[1], x[2]}, {v[0], v[1], v[2]}, {x[3], v[3]}};
  }
};

// - what a kinematic row has as volume, in all lanes of each block; d: the difference to its motion

template <int D> inline Pack minus_volume(const Motion<D> &d, const Addresses &row)
{
  if constexpr (D == 2)
    return -load_all(row + Kinematics<D>::VOLUME);
  else
    return shuffle<3, 3, 3, 3>(d.position);
}

// vectors of N rows, D doubles and in three dimensions a 0: two rows in a block, or one

template <int D> struct Few {
  static constexpr int EACH = (D == 2) ? 2 : 1;
  static constexpr int N = EACH * BLOCKS;
};

template <int D> inline Pack load_few(const double *rows, const int *j, int stride)
{
  const double *row[Few<D>::N];
  for (int n = 0; n < Few<D>::N; n++) row[n] = rows + static_cast<std::ptrdiff_t>(j[n]) * stride;
  if constexpr (D == 2)
    return load_twos(row);
  else
    return load(Addresses(row[0], row[BLOCKS - 1]));
}

// N weights, each as often as its vector has lanes

template <int D> inline Pack load_few_weights(const double *w)
{
  if constexpr (D == 2)
    return load_each_twice(w);
  else
    return load_all(Addresses(w, w + BLOCKS - 1));
}

// a vector in all places

template <int D> inline Pack load_few(const double *row)
{
  if constexpr (D == 2)
    return load_two_twice(Addresses(row));
  else
    return load_block(row);
}

// component a of the sum over rows: in the first block

template <int D> inline double few_summed(Pack t, int a)
{
  return D == 2 ? t[a] + t[2 + a] : t[a];
}

}    // namespace SPHSolid

#endif
