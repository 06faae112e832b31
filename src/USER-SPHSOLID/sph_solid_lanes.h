/* ----------------------------------------------------------------------
   What a pair needs, in vectors of four doubles: differences of motion,
   tensors of a row, and products of the two, alike in two and three dimensions.

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

#include "sph_solid_rows.h"
#include "sph_solid_tensor.h"

namespace SPHSolid {

// one block in two dimensions, three in three

template <int D> struct Several {
  static constexpr int N = (D == 2) ? 1 : 3;
  Four block[N];

  static Several zero()
  {
    Several s;
    for (int b = 0; b < N; b++) s.block[b] = Four(0.0);
    return s;
  }
};

template <int D> inline Several<D> operator+(const Several<D> &a, const Several<D> &b)
{
  Several<D> s;
  for (int n = 0; n < Several<D>::N; n++) s.block[n] = a.block[n] + b.block[n];
  return s;
}

template <int D> inline Several<D> operator*(const Several<D> &a, Four factor)
{
  Several<D> s;
  for (int n = 0; n < Several<D>::N; n++) s.block[n] = a.block[n] * factor;
  return s;
}

template <int D> inline Several<D> load_tensor(const double *row)
{
  Several<D> t;
  for (int n = 0; n < Several<D>::N; n++) t.block[n] = load(row + n * LANES);
  return t;
}

template <int D> inline void store_tensor(double *row, const Several<D> &t)
{
  for (int n = 0; n < Several<D>::N; n++) store(row + n * LANES, t.block[n]);
}

// a vector in memory, D doubles

template <int D> inline Several<D> load_spread(const double *a)
{
  if constexpr (D == 2)
    return {load_two_twice(a)};
  else
    return {Four(a[0]), Four(a[1]), Four(a[2])};
}

template <int D> inline Four times(const Several<D> &T, const Several<D> &g)
{
  Four s = T.block[0] * g.block[0];
  for (int n = 1; n < Several<D>::N; n++) s = multiply_add(T.block[n], g.block[n], s);
  return s;
}

// result += T.g

template <int D> inline void add_times(Four &result, const Several<D> &T, const Several<D> &g)
{
  for (int n = 0; n < Several<D>::N; n++) result = multiply_add(T.block[n], g.block[n], result);
}

// result += a (x) g, a expanded

template <int D> inline void add_outer(Several<D> &result, Four a, const Several<D> &g)
{
  for (int n = 0; n < Several<D>::N; n++)
    result.block[n] = multiply_add(a, g.block[n], result.block[n]);
}

// all components times their counterparts

template <int D> inline double contract(const Several<D> &a, const Several<D> &b)
{
  return sum(times(a, b));
}

// component a of T.g from times(T, g), summed over pairs

template <int D> inline double folded(Four t, int a)
{
  return D == 2 ? t[2 * a] + t[2 * a + 1] : t[a];
}

// a vector as products with spread vectors take it: {fx, fx, fy, fy}, in three dimensions
// itself; from times(T, g), and from memory, D doubles and in three dimensions a 0

template <int D> inline Four expanded(Four t)
{
  return D == 2 ? t + shuffle<1, 0, 3, 2>(t) : t;
}
template <int D> inline Four load_expanded(const double *a)
{
  return D == 2 ? Four(a[0], a[0], a[1], a[1]) : load(a);
}

// tensors of four particles, one per lane

template <int D> inline Tensor<D, Four> lanes_of(const Several<D> *t)
{
  Tensor<D, Four> out;
  for (int n = 0; n < Several<D>::N; n++) {
    Four a = t[0].block[n], b = t[1].block[n], c = t[2].block[n], d = t[3].block[n];
    transpose(a, b, c, d);
    if constexpr (D == 2)
      out << a, b, c, d;
    else
      out.col(n) << a, b, c;
  }
  return out;
}

template <int D> inline void from_lanes(const Tensor<D, Four> &t, Several<D> *out)
{
  for (int n = 0; n < Several<D>::N; n++) {
    Four a = D == 2 ? t(0, 0) : t(0, n), b = D == 2 ? t(0, 1) : t(1, n),
         c = D == 2 ? t(1, 0) : t(D - 1, n), d = D == 2 ? t(1, 1) : Four(0.0);
    transpose(a, b, c, d);
    out[0].block[n] = a;
    out[1].block[n] = b;
    out[2].block[n] = c;
    out[3].block[n] = d;
  }
}

// position and velocity of a row, or differences of these

template <int D> struct Motion;

template <> struct Motion<2> {
  Four xv;    // x, y, vx, vy

  explicit Motion(const double *row = nullptr) : xv(row ? load(row) : Four(0.0)) {}
  Motion operator-(const Motion &other) const
  {
    Motion d;
    d.xv = xv - other.xv;
    return d;
  }
  // added to the position: D doubles
  void move_by(const double *X) { xv += load_two(X); }

  Four x() const { return xv; }    // the first two lanes
  Four expanded_x() const { return shuffle<0, 0, 1, 1>(xv); }
  Four expanded_v() const { return shuffle<2, 2, 3, 3>(xv); }
  Several<2> spread_x() const { return {shuffle<0, 1, 0, 1>(xv)}; }

  // products with x, summed: over lanes 0 and 1 x.x, over the others v.x
  Four products() const { return xv * shuffle<0, 1, 0, 1>(xv); }
  static double v_dot_x(Four products) { return products[2] + products[3]; }
  static void dots(const Motion *d, Four &xx, Four &vx)
  {
    half_sums(d[0].products(), d[1].products(), d[2].products(), d[3].products(), xx, vx);
  }
};

template <> struct Motion<3> {
  Four position, velocity;

  explicit Motion(const double *row = nullptr) :
      position(row ? load(row) : Four(0.0)), velocity(row ? load(row + LANES) : Four(0.0))
  {
  }
  Motion operator-(const Motion &other) const
  {
    Motion d;
    d.position = position - other.position;
    d.velocity = velocity - other.velocity;
    return d;
  }
  void move_by(const double *X) { position += Four(X[0], X[1], X[2], 0.0); }

  Four x() const { return position; }
  Four expanded_x() const { return position; }
  Four expanded_v() const { return velocity; }
  Several<3> spread_x() const
  {
    return {shuffle<0, 0, 0, 0>(position), shuffle<1, 1, 1, 1>(position),
            shuffle<2, 2, 2, 2>(position)};
  }

  // of v.x only
  Four products() const { return velocity * position; }
  static double v_dot_x(Four products) { return sum(products); }
  static void dots(const Motion *d, Four &xx, Four &vx)
  {
    xx = sums(d[0].position * d[0].position, d[1].position * d[1].position,
              d[2].position * d[2].position, d[3].position * d[3].position);
    vx = sums(d[0].products(), d[1].products(), d[2].products(), d[3].products());
  }
};

// vectors of rows, D doubles and in three dimensions a 0: two rows in one block, or one

template <int D> struct Few {
  static constexpr int N = (D == 2) ? 2 : 1;
};

template <int D> inline Four load_few(const double *first, const double *second)
{
  return D == 2 ? Four(first[0], first[1], second[0], second[1]) : load(first);
}

template <int D> inline Four weights_of_few(double first, double second)
{
  return D == 2 ? Four(first, first, second, second) : Four(first);
}

// component a of the sum over the rows of a block

template <int D> inline double few_summed(Four t, int a)
{
  return D == 2 ? t[a] + t[2 + a] : t[a];
}

}    // namespace SPHSolid

#endif
