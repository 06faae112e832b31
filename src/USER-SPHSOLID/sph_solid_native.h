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
   Four or eight doubles in one variable, and the instruction set: the one place that knows how
   wide vectors are.

   GCC and Clang have such vectors and take the widest instructions they were
   given; for any other compiler, and for a test that both give the same
   numbers, SPHSOLID_PORTABLE_VECTOR selects arrays and loops.  SPHSOLID_LANES
   can be set to 4 or 8 for tests.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_NATIVE_H
#define LMP_SPH_SOLID_NATIVE_H

#include <cmath>
#include <cstring>

#if !defined(__GNUC__) && !defined(SPHSOLID_PORTABLE_VECTOR)
#define SPHSOLID_PORTABLE_VECTOR
#endif
#if defined(__AVX__) && !defined(SPHSOLID_PORTABLE_VECTOR)
#include <immintrin.h>
#endif

#if !defined(SPHSOLID_LANES)
#if defined(__AVX512F__) && defined(__AVX512DQ__)
#define SPHSOLID_LANES 8
#else
#define SPHSOLID_LANES 4
#endif
#endif

#if defined(__AVX512F__) && defined(__AVX512DQ__) && SPHSOLID_LANES == 8 && \
    !defined(SPHSOLID_PORTABLE_VECTOR)
#define SPHSOLID_AVX512
#endif

namespace SPHSolid {

constexpr int LANES = SPHSOLID_LANES;
constexpr int BLOCK = 4;                 // doubles in a block
constexpr int BLOCKS = LANES / BLOCK;    // in a pack
static_assert(LANES == 4 || LANES == 8, "SPHSOLID_LANES is 4 or 8");

// n rounded up to whole vectors

inline int whole_vectors(int n)
{
  return (n + LANES - 1) / LANES * LANES;
}

// one after the other, where no instruction finds them: in which lanes a is larger than b, as bits

template <class V> inline unsigned lanes_that_are_larger(const V &a, const V &b)
{
  unsigned lanes = 0;
  for (int k = 0; k < LANES; k++) lanes |= (a[k] > b[k] ? 1u : 0u) << k;
  return lanes;
}

#ifdef SPHSOLID_PORTABLE_VECTOR

template <class T> struct PortableVector {
  T lane[LANES];
  T &operator[](int k) { return lane[k]; }
  T operator[](int k) const { return lane[k]; }
};
typedef PortableVector<double> Native;
typedef PortableVector<float> NativeSingle;

template <class T = double, class F> inline PortableVector<T> each_lane(F f)
{
  PortableVector<T> out;
  for (int k = 0; k < LANES; k++) out.lane[k] = f(k);
  return out;
}
template <class T>
inline PortableVector<T> operator+(const PortableVector<T> &a, const PortableVector<T> &b)
{
  return each_lane<T>([&](int k) {
    return a[k] + b[k];
  });
}
template <class T>
inline PortableVector<T> operator-(const PortableVector<T> &a, const PortableVector<T> &b)
{
  return each_lane<T>([&](int k) {
    return a[k] - b[k];
  });
}
template <class T>
inline PortableVector<T> operator*(const PortableVector<T> &a, const PortableVector<T> &b)
{
  return each_lane<T>([&](int k) {
    return a[k] * b[k];
  });
}
template <class T>
inline PortableVector<T> operator/(const PortableVector<T> &a, const PortableVector<T> &b)
{
  return each_lane<T>([&](int k) {
    return a[k] / b[k];
  });
}
inline Native native_all(double a)
{
  return each_lane([&](int) {
    return a;
  });
}
inline Native native_multiply_add(const Native &a, const Native &b, const Native &c)
{
  return each_lane([&](int k) {
#ifdef __FMA__
    return std::fma(a[k], b[k], c[k]);
#else
    return a[k] * b[k] + c[k];
#endif
  });
}
template <class T>
inline PortableVector<T> native_where_positive(const PortableVector<T> &condition,
                                               const PortableVector<T> &a,
                                               const PortableVector<T> &b)
{
  return each_lane<T>([&](int k) {
    return condition[k] > 0 ? a[k] : b[k];
  });
}
template <class T>
inline unsigned native_larger_lanes(const PortableVector<T> &a, const PortableVector<T> &b)
{
  return lanes_that_are_larger(a, b);
}
inline Native native_where_lanes(unsigned lanes, const Native &a, const Native &b)
{
  return each_lane([&](int k) {
    return lanes >> k & 1 ? a[k] : b[k];
  });
}
template <class T> inline PortableVector<T> native_square_root(const PortableVector<T> &a)
{
  return each_lane<T>([&](int k) {
    return std::sqrt(a[k]);
  });
}
inline Native native_minimum(const Native &a, const Native &b)
{
  return each_lane([&](int k) {
    return a[k] < b[k] ? a[k] : b[k];
  });
}
template <class T>
inline PortableVector<T> native_maximum(const PortableVector<T> &a, const PortableVector<T> &b)
{
  return each_lane<T>([&](int k) {
    return a[k] > b[k] ? a[k] : b[k];
  });
}
template <int i, int j, int k, int l> inline Native native_shuffle(const Native &a, const Native &b)
{
  const int from[BLOCK] = {i, j, k, l};
  return each_lane([&](int n) {
    const int m = from[n % BLOCK], block = n / BLOCK * BLOCK;
    return m < BLOCK ? a[block + m] : b[block + m - BLOCK];
  });
}

inline NativeSingle native_all(float a)
{
  return each_lane<float>([&](int) {
    return a;
  });
}
inline NativeSingle narrowed(const Native &a)
{
  return each_lane<float>([&](int k) {
    return static_cast<float>(a[k]);
  });
}
inline Native widened(const NativeSingle &a)
{
  return each_lane([&](int k) {
    return static_cast<double>(a[k]);
  });
}

#else

typedef double Native __attribute__((vector_size(LANES * sizeof(double))));

inline Native native_all(double a)
{
  return a - Native{};    // -0.0 stays -0.0
}
inline Native native_multiply_add(Native a, Native b, Native c)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_fmadd_pd(a, b, c);
#elif defined(__FMA__)
  Native out;
  for (int n = 0; n < BLOCKS; n++) {
    __m256d x, y, z;
    std::memcpy(&x, reinterpret_cast<const char *>(&a) + n * sizeof(x), sizeof(x));
    std::memcpy(&y, reinterpret_cast<const char *>(&b) + n * sizeof(y), sizeof(y));
    std::memcpy(&z, reinterpret_cast<const char *>(&c) + n * sizeof(z), sizeof(z));
    x = _mm256_fmadd_pd(x, y, z);
    std::memcpy(reinterpret_cast<char *>(&out) + n * sizeof(x), &x, sizeof(x));
  }
  return out;
#else
  return a * b + c;
#endif
}
inline Native native_where_positive(Native condition, Native a, Native b)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_mask_blend_pd(_mm512_cmp_pd_mask(condition, Native{}, _CMP_GT_OQ), b, a);
#else
  return condition > Native{} ? a : b;
#endif
}
inline unsigned native_larger_lanes(Native a, Native b)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ);
#elif defined(__AVX__) && SPHSOLID_LANES == 4
  return _mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GT_OQ));
#else
  return lanes_that_are_larger(a, b);
#endif
}
inline Native native_where_lanes(unsigned lanes, Native a, Native b)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_mask_blend_pd(static_cast<__mmask8>(lanes), b, a);
#else
  static constexpr long long BIT[] = {1, 2, 4, 8, 16, 32, 64, 128};
  typedef long long Bits __attribute__((vector_size(LANES * sizeof(long long))));
  Bits bit;
  std::memcpy(&bit, BIT, sizeof(bit));
  return (bit & static_cast<long long>(lanes)) != 0 ? a : b;
#endif
}
inline Native native_square_root(Native a)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_maskz_sqrt_pd(0xFF, a);
#else
  for (int k = 0; k < LANES; k++) a[k] = std::sqrt(a[k]);
  return a;
#endif
}
inline Native native_minimum(Native a, Native b)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_maskz_min_pd(0xFF, a, b);
#else
  return a < b ? a : b;
#endif
}
inline Native native_maximum(Native a, Native b)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_maskz_max_pd(0xFF, a, b);
#else
  return a > b ? a : b;
#endif
}

typedef float NativeSingle __attribute__((vector_size(LANES * sizeof(float))));

inline NativeSingle native_all(float a)
{
  return a - NativeSingle{};
}
inline NativeSingle native_where_positive(NativeSingle condition, NativeSingle a, NativeSingle b)
{
  return condition > NativeSingle{} ? a : b;
}
inline NativeSingle native_maximum(NativeSingle a, NativeSingle b)
{
  return a > b ? a : b;
}
inline unsigned native_larger_lanes(NativeSingle a, NativeSingle b)
{
#if defined(__AVX__) && SPHSOLID_LANES == 8
  return _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_GT_OQ));
#elif defined(__AVX__)
  return _mm_movemask_ps(_mm_cmp_ps(a, b, _CMP_GT_OQ));
#else
  return lanes_that_are_larger(a, b);
#endif
}
// left to itself GCC 12 converts in halves
inline Native widened(NativeSingle n)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_maskz_cvtps_pd(0xFF, n);
#elif defined(__AVX__) && SPHSOLID_LANES == 4
  return _mm256_cvtps_pd(n);
#else
  return __builtin_convertvector(n, Native);
#endif
}
inline NativeSingle narrowed(Native n)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_maskz_cvtpd_ps(0xFF, n);
#elif defined(__AVX__) && SPHSOLID_LANES == 4
  return _mm256_cvtpd_ps(n);
#else
  return __builtin_convertvector(n, NativeSingle);
#endif
}
inline NativeSingle native_square_root(NativeSingle a)
{
#if defined(__AVX__) && SPHSOLID_LANES == 8
  return _mm256_sqrt_ps(a);
#elif defined(__AVX__)
  return _mm_sqrt_ps(a);
#else
  for (int k = 0; k < LANES; k++) a[k] = std::sqrt(a[k]);
  return a;
#endif
}

// where lane n of a block comes from: of a (0 to 3) or b (4 to 7), the same in every block
constexpr int source_lane(int n, int block)
{
  return n < BLOCK ? block * BLOCK + n : LANES + block * BLOCK + n - BLOCK;
}
template <int i, int j, int k, int l> inline Native native_shuffle(Native a, Native b)
{
#if defined(__clang__) || __GNUC__ >= 12
#if SPHSOLID_LANES == 8
  return __builtin_shufflevector(a, b, source_lane(i, 0), source_lane(j, 0), source_lane(k, 0),
                                 source_lane(l, 0), source_lane(i, 1), source_lane(j, 1),
                                 source_lane(k, 1), source_lane(l, 1));
#else
  return __builtin_shufflevector(a, b, i, j, k, l);
#endif
#else
  typedef long long Mask __attribute__((vector_size(LANES * sizeof(long long))));
  const int from[BLOCK] = {i, j, k, l};
  Mask mask;
  for (int n = 0; n < LANES; n++) mask[n] = source_lane(from[n % BLOCK], n / BLOCK);
  return __builtin_shuffle(a, b, mask);
#endif
}

#endif

}    // namespace SPHSolid

#endif
