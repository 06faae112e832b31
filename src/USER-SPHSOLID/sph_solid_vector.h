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
   Packs of four or eight doubles (sph_solid_native.h), or of twice as many numbers in single
   precision: one number each of LANES, or WIDE, pairs or particles.  Here is what is done with every lane by itself, so that a formula takes
   packs and numbers alike; sph_solid_blocks.h has the rest.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_VECTOR_H
#define LMP_SPH_SOLID_VECTOR_H

#include "sph_solid_native.h"

#include <bitset>
#include <type_traits>
#include <utility>

namespace SPHSolid {

// a number in formulas that take as many particles or pairs at a time

template <class N, class Number> class PackOf {
 public:
  PackOf() = default;
  PackOf(double a) : v(native_all<N>(static_cast<Number>(a))) {}
  explicit PackOf(const N &n) : v(n) {}
  Number operator[](int k) const { return v[k]; }
  const N &native() const { return v; }

  friend PackOf operator+(const PackOf &a, const PackOf &b) { return PackOf(a.v + b.v); }
  friend PackOf operator-(const PackOf &a, const PackOf &b) { return PackOf(a.v - b.v); }
  friend PackOf operator*(const PackOf &a, const PackOf &b) { return PackOf(a.v * b.v); }
  friend PackOf operator/(const PackOf &a, const PackOf &b) { return PackOf(a.v / b.v); }
  PackOf operator-() const { return PackOf(0.0) - *this; }
  PackOf &operator+=(const PackOf &b) { return *this = *this + b; }
  PackOf &operator-=(const PackOf &b) { return *this = *this - b; }
  PackOf &operator*=(const PackOf &b) { return *this = *this * b; }
  PackOf &operator/=(const PackOf &b) { return *this = *this / b; }

  // of every pack, also where an argument is a number; the same of numbers alone is below
  friend PackOf multiply_add(PackOf a, PackOf b, PackOf c)
  {
    return PackOf(native_multiply_add(a.v, b.v, c.v));
  }
  friend PackOf where_positive(PackOf condition, PackOf a, PackOf b)
  {
    return PackOf(native_where_positive(condition.v, a.v, b.v));
  }
  friend unsigned larger_lanes(PackOf a, PackOf b) { return native_larger_lanes(a.v, b.v); }
  friend PackOf where_lanes(unsigned lanes, PackOf a, PackOf b)
  {
    return PackOf(native_where_lanes(lanes, a.v, b.v));
  }
  friend PackOf minimum(PackOf a, PackOf b) { return PackOf(native_minimum(a.v, b.v)); }
  friend PackOf maximum(PackOf a, PackOf b) { return PackOf(native_maximum(a.v, b.v)); }
  friend PackOf square_root(PackOf a) { return PackOf(native_square_root(a.v)); }

 private:
  N v;
};

using Pack = PackOf<Native, double>;

// for what is kept in single precision and need not be found in any other
using SinglePack = PackOf<NativeSingle, float>;

// of twice as many pairs or particles, all in single precision
using WidePack = PackOf<NativeWide, float>;

// how many numbers it has

template <class P>
constexpr int lanes_of = static_cast<int>(sizeof(P) / sizeof(std::declval<P>()[0]));

// a b + c, rounded once where the instruction set can.  Only where it is asked for: the
// compiler, left free to choose, takes it in a vector loop and not in what is left over, and
// numbers would depend on where in a row a pair stands

inline double multiply_add(double a, double b, double c)
{
#ifdef __FMA__
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}

// as many doubles as there are lanes

inline Pack load(const double *from)
{
  Native n;
  std::memcpy(&n, from, sizeof(n));
  return Pack(n);
}

inline void store(double *to, Pack v)
{
  std::memcpy(to, &v.native(), sizeof(Native));
}

// between the two precisions; rounded is to nearest

inline SinglePack rounded(Pack v)
{
  return SinglePack(narrowed(v.native()));
}
inline Pack widened(SinglePack v)
{
  return Pack(widened(v.native()));
}
// in formulas for both: is as it is
inline WidePack rounded(WidePack v)
{
  return v;
}
inline WidePack widened(WidePack v)
{
  return v;
}

// a wide pack and the two packs of doubles that have the same lanes; in double precision a pack is all
// there is

inline WidePack joined(Pack first, Pack second)
{
  return WidePack(native_joined(narrowed(first.native()), narrowed(second.native())));
}
template <int part> inline Pack part_of(WidePack v)
{
  return widened(SinglePack(native_half<part>(v.native())));
}
template <int part> inline Pack part_of(Pack v)
{
  static_assert(part == 0, "there is one");
  return v;
}

// value(part) of each; part: a constant

template <class P, class F> [[gnu::always_inline]] inline P of_parts(F value)
{
  using First = std::integral_constant<int, 0>;
  if constexpr (std::is_same_v<P, Pack>)
    return value(First());
  else
    return joined(value(First()), value(std::integral_constant<int, 1>()));
}
template <class P, class F> [[gnu::always_inline]] inline void each_part(F call)
{
  call(std::integral_constant<int, 0>());
  if constexpr (!std::is_same_v<P, Pack>) call(std::integral_constant<int, 1>());
}

// what is kept in single precision

inline SinglePack load_single(const float *from)
{
  NativeSingle n;
  std::memcpy(&n, from, sizeof(n));
  return SinglePack(n);
}
inline Pack load(const float *from)
{
  return widened(load_single(from));
}
inline WidePack load_wide(const float *from)
{
  NativeWide n;
  std::memcpy(&n, from, sizeof(n));
  return WidePack(n);
}
inline void store(float *to, SinglePack v)
{
  std::memcpy(to, &v.native(), sizeof(NativeSingle));
}
inline void store(float *to, WidePack v)
{
  std::memcpy(to, &v.native(), sizeof(NativeWide));
}

// whole numbers, where only differences count

class WholePack {
 public:
  WholePack() = default;
  explicit WholePack(const NativeWhole &n) : v(n) {}
  const NativeWhole &native() const { return v; }

 private:
  NativeWhole v;
};

inline WholePack load_whole(const float *from)
{
  NativeWhole n;
  std::memcpy(&n, from, sizeof(n));
  return WholePack(n);
}
// the whole numbers nearest to v, of less than 2^51, in the place of LANES numbers: the last 32 bits of each
inline void store_whole(float *to, Pack v)
{
  native_store_whole(to, v.native());
}
// less than 2^31 in truth
inline WidePack difference(WholePack a, WholePack b)
{
  return WidePack(native_to_single(a.native() - b.native()));
}

// value(lane) of each.  Not by way of an array: its load would have to wait for the stores

template <class F> inline Pack doubles_of(F value)
{
#ifdef SPHSOLID_PORTABLE_VECTOR
  return Pack(each_lane(value));
#elif SPHSOLID_LANES == 8
  return Pack(
      Native{value(0), value(1), value(2), value(3), value(4), value(5), value(6), value(7)});
#else
  return Pack(Native{value(0), value(1), value(2), value(3)});
#endif
}
// of numbers in single precision, to the bit

template <class F, int... k> inline WidePack floats_of(F value, std::integer_sequence<int, k...>)
{
#ifdef SPHSOLID_PORTABLE_VECTOR
  return WidePack(NativeWide{{value(k)...}});
#else
  return WidePack(NativeWide{value(k)...});
#endif
}
template <class F> inline WidePack floats_of(F value)
{
  return floats_of(value, std::make_integer_sequence<int, WIDE>());
}

template <class P = Pack, class F> inline P pack_of(F value)
{
  return of_parts<P>([&](auto part) {
    return doubles_of([&](int k) {
      return value(part * LANES + k);
    });
  });
}

// condition > 0 ? a : b; numbers and vectors of them

inline double where_positive(double condition, double a, double b)
{
  return condition > 0.0 ? a : b;
}

// in which lanes a is larger than b, as bits; a in lanes whose bit is set, b in the others

inline unsigned larger_lanes(double a, double b)
{
  return a > b ? 1 : 0;
}

// the first n of all lanes

constexpr unsigned first_lanes(int n)
{
  return (1u << n) - 1u;
}

// how many of the first n are set

inline int count_lanes(unsigned lanes, int n)
{
  return static_cast<int>(std::bitset<WIDE>(lanes & first_lanes(n)).count());
}

// of two, one of which is not a number, the second one

inline double minimum(double a, double b)
{
  return a < b ? a : b;
}
inline double maximum(double a, double b)
{
  return a > b ? a : b;
}

inline double square_root(double a)
{
  return std::sqrt(a);
}

}    // namespace SPHSolid

#endif
