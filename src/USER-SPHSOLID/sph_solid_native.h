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
   Four or eight doubles in one variable, or twice as many numbers in single precision, and the
   instruction set: the one place that knows how wide vectors are.

   GCC and Clang have such vectors and take the widest instructions they were
   given; for any other compiler, and for a test that both give the same
   numbers, SPHSOLID_PORTABLE_VECTOR selects arrays and loops.  SPHSOLID_LANES
   can be set to 4 or 8 for tests.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_NATIVE_H
#define LMP_SPH_SOLID_NATIVE_H

#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

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
constexpr int WIDE = 2 * LANES;          // as many numbers of single precision are as wide
constexpr int BLOCK = 4;                 // doubles in a block
constexpr int BLOCKS = LANES / BLOCK;    // in a pack
static_assert(LANES == 4 || LANES == 8, "SPHSOLID_LANES is 4 or 8");

// one after the other, where no instruction finds them: in which of N lanes a is larger than b, as bits

template <int N, class V> inline unsigned lanes_that_are_larger(const V &a, const V &b)
{
  unsigned lanes = 0;
  for (int k = 0; k < N; k++) lanes |= (a[k] > b[k] ? 1u : 0u) << k;
  return lanes;
}

// what is added to a number so that its lowest bits are those of the whole number nearest to it,
// also of a negative one: 1.5 2^52

constexpr double TO_WHOLE = 0x1.8p52;

#ifdef SPHSOLID_PORTABLE_VECTOR

template <class T, int N> struct PortableVector {
  T lane[N];
  T &operator[](int k) { return lane[k]; }
  T operator[](int k) const { return lane[k]; }
};
typedef PortableVector<double, LANES> Native;
typedef PortableVector<float, LANES> NativeSingle;
typedef PortableVector<float, WIDE> NativeWide;
typedef PortableVector<unsigned, WIDE> NativeWhole;

template <class T = double, int N = LANES, class F> inline PortableVector<T, N> each_lane(F f)
{
  PortableVector<T, N> out;
  for (int k = 0; k < N; k++) out.lane[k] = f(k);
  return out;
}
template <class T, int N>
inline PortableVector<T, N> operator+(const PortableVector<T, N> &a, const PortableVector<T, N> &b)
{
  return each_lane<T, N>([&](int k) {
    return a[k] + b[k];
  });
}
template <class T, int N>
inline PortableVector<T, N> operator-(const PortableVector<T, N> &a, const PortableVector<T, N> &b)
{
  return each_lane<T, N>([&](int k) {
    return a[k] - b[k];
  });
}
template <class T, int N>
inline PortableVector<T, N> operator*(const PortableVector<T, N> &a, const PortableVector<T, N> &b)
{
  return each_lane<T, N>([&](int k) {
    return a[k] * b[k];
  });
}
template <class T, int N>
inline PortableVector<T, N> operator/(const PortableVector<T, N> &a, const PortableVector<T, N> &b)
{
  return each_lane<T, N>([&](int k) {
    return a[k] / b[k];
  });
}
template <class V, class T> inline V native_all(T a)
{
  V out;
  for (T &lane : out.lane) lane = a;
  return out;
}
template <class T, int N>
inline PortableVector<T, N> native_multiply_add(const PortableVector<T, N> &a,
                                                const PortableVector<T, N> &b,
                                                const PortableVector<T, N> &c)
{
  return each_lane<T, N>([&](int k) {
#ifdef __FMA__
    return std::fma(a[k], b[k], c[k]);
#else
    return a[k] * b[k] + c[k];
#endif
  });
}
template <class T, int N>
inline PortableVector<T, N> native_where_positive(const PortableVector<T, N> &condition,
                                                  const PortableVector<T, N> &a,
                                                  const PortableVector<T, N> &b)
{
  return each_lane<T, N>([&](int k) {
    return condition[k] > 0 ? a[k] : b[k];
  });
}
template <class T, int N>
inline unsigned native_larger_lanes(const PortableVector<T, N> &a, const PortableVector<T, N> &b)
{
  return lanes_that_are_larger<N>(a, b);
}
template <class T, int N>
inline PortableVector<T, N> native_where_lanes(unsigned lanes, const PortableVector<T, N> &a,
                                               const PortableVector<T, N> &b)
{
  return each_lane<T, N>([&](int k) {
    return lanes >> k & 1 ? a[k] : b[k];
  });
}
template <class T, int N>
inline PortableVector<T, N> native_square_root(const PortableVector<T, N> &a)
{
  return each_lane<T, N>([&](int k) {
    return std::sqrt(a[k]);
  });
}
template <class T, int N>
inline PortableVector<T, N> native_minimum(const PortableVector<T, N> &a,
                                           const PortableVector<T, N> &b)
{
  return each_lane<T, N>([&](int k) {
    return a[k] < b[k] ? a[k] : b[k];
  });
}
template <class T, int N>
inline PortableVector<T, N> native_maximum(const PortableVector<T, N> &a,
                                           const PortableVector<T, N> &b)
{
  return each_lane<T, N>([&](int k) {
    return a[k] > b[k] ? a[k] : b[k];
  });
}
template <int i, int j, int k, int l, class T, int N>
inline PortableVector<T, N> native_shuffle(const PortableVector<T, N> &a,
                                           const PortableVector<T, N> &b)
{
  const int from[BLOCK] = {i, j, k, l};
  return each_lane<T, N>([&](int n) {
    const int m = from[n % BLOCK], block = n / BLOCK * BLOCK;
    return m < BLOCK ? a[block + m] : b[block + m - BLOCK];
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
template <int half> inline NativeSingle native_half(const NativeWide &a)
{
  return each_lane<float>([&](int k) {
    return a[half * LANES + k];
  });
}
inline NativeWide native_joined(const NativeSingle &first, const NativeSingle &second)
{
  return each_lane<float, WIDE>([&](int k) {
    return k < LANES ? first[k] : second[k - LANES];
  });
}

// whole numbers that differ by less than 2^31, whatever they are
inline NativeWide native_to_single(const NativeWhole &a)
{
  return each_lane<float, WIDE>([&](int k) {
    return static_cast<float>(static_cast<int>(a[k]));
  });
}
inline void native_store_whole(void *to, const Native &a)
{
  for (int k = 0; k < LANES; k++) {
    const double sum = a[k] + TO_WHOLE;
    std::uint64_t bits;
    std::memcpy(&bits, &sum, sizeof(bits));
    const unsigned whole = static_cast<unsigned>(bits);
    std::memcpy(static_cast<char *>(to) + k * sizeof(whole), &whole, sizeof(whole));
  }
}

#else

typedef double Native __attribute__((vector_size(LANES * sizeof(double))));
typedef float NativeSingle __attribute__((vector_size(LANES * sizeof(float))));
typedef float NativeWide __attribute__((vector_size(WIDE * sizeof(float))));

// of any of these vectors, and with the instructions of AVX-512

template <class V> inline V native_where_positive(V condition, V a, V b)
{
  return condition > V{} ? a : b;
}
template <class V> inline V native_minimum(V a, V b)
{
  return a < b ? a : b;
}
template <class V> inline V native_maximum(V a, V b)
{
  return a > b ? a : b;
}

#if defined(SPHSOLID_AVX512)
inline Native native_where_positive(Native condition, Native a, Native b)
{
  return _mm512_mask_blend_pd(_mm512_cmp_pd_mask(condition, Native{}, _CMP_GT_OQ), b, a);
}
inline NativeWide native_where_positive(NativeWide condition, NativeWide a, NativeWide b)
{
  return _mm512_mask_blend_ps(_mm512_cmp_ps_mask(condition, NativeWide{}, _CMP_GT_OQ), b, a);
}
inline Native native_minimum(Native a, Native b)
{
  return _mm512_maskz_min_pd(0xFF, a, b);
}
inline NativeWide native_minimum(NativeWide a, NativeWide b)
{
  return _mm512_maskz_min_ps(0xFFFF, a, b);
}
inline Native native_maximum(Native a, Native b)
{
  return _mm512_maskz_max_pd(0xFF, a, b);
}
inline NativeWide native_maximum(NativeWide a, NativeWide b)
{
  return _mm512_maskz_max_ps(0xFFFF, a, b);
}
#endif

template <class V, class T> inline V native_all(T a)
{
  return a - V{};    // -0.0 stays -0.0
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
inline unsigned native_larger_lanes(Native a, Native b)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ);
#elif defined(__AVX__) && SPHSOLID_LANES == 4
  return _mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GT_OQ));
#else
  return lanes_that_are_larger<LANES>(a, b);
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

inline unsigned native_larger_lanes(NativeSingle a, NativeSingle b)
{
#if defined(__AVX__) && SPHSOLID_LANES == 8
  return _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_GT_OQ));
#elif defined(__AVX__)
  return _mm_movemask_ps(_mm_cmp_ps(a, b, _CMP_GT_OQ));
#else
  return lanes_that_are_larger<LANES>(a, b);
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

inline NativeWide native_multiply_add(NativeWide a, NativeWide b, NativeWide c)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_fmadd_ps(a, b, c);
#elif defined(__FMA__) && SPHSOLID_LANES == 4
  return _mm256_fmadd_ps(a, b, c);
#elif defined(__FMA__)
  for (int k = 0; k < WIDE; k++) a[k] = std::fma(a[k], b[k], c[k]);
  return a;
#else
  return a * b + c;
#endif
}
inline unsigned native_larger_lanes(NativeWide a, NativeWide b)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_cmp_ps_mask(a, b, _CMP_GT_OQ);
#elif defined(__AVX__) && SPHSOLID_LANES == 4
  return _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_GT_OQ));
#else
  return lanes_that_are_larger<WIDE>(a, b);
#endif
}
inline NativeWide native_where_lanes(unsigned lanes, NativeWide a, NativeWide b)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_mask_blend_ps(static_cast<__mmask16>(lanes), b, a);
#else
  typedef int Bits __attribute__((vector_size(WIDE * sizeof(int))));
  Bits bit;
  for (int k = 0; k < WIDE; k++) bit[k] = 1 << k;
  return (bit & static_cast<int>(lanes)) != 0 ? a : b;
#endif
}
inline NativeWide native_square_root(NativeWide a)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_maskz_sqrt_ps(0xFFFF, a);
#elif defined(__AVX__) && SPHSOLID_LANES == 4
  return _mm256_sqrt_ps(a);
#else
  for (int k = 0; k < WIDE; k++) a[k] = std::sqrt(a[k]);
  return a;
#endif
}

// the first and the second half
template <int half> inline NativeSingle native_half(NativeWide a)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_maskz_extractf32x8_ps(0xFF, a, half);
#else
  NativeSingle out;
  std::memcpy(&out, reinterpret_cast<const char *>(&a) + half * sizeof(out), sizeof(out));
  return out;
#endif
}
inline NativeWide native_joined(NativeSingle first, NativeSingle second)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_maskz_insertf32x8(0xFFFF, _mm512_castps256_ps512(first), second, 1);
#else
  NativeWide out;
  std::memcpy(&out, &first, sizeof(first));
  std::memcpy(reinterpret_cast<char *>(&out) + sizeof(first), &second, sizeof(second));
  return out;
#endif
}

// whole numbers that differ by less than 2^31, whatever they are
typedef unsigned NativeWhole __attribute__((vector_size(WIDE * sizeof(unsigned))));

inline NativeWide native_to_single(NativeWhole a)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_maskz_cvtepi32_ps(0xFFFF, reinterpret_cast<__m512i>(a));
#else
  typedef int Signed __attribute__((vector_size(WIDE * sizeof(int))));
  return __builtin_convertvector(reinterpret_cast<Signed>(a), NativeWide);
#endif
}
inline void native_store_whole(void *to, Native a)
{
  typedef unsigned long long Bits __attribute__((vector_size(LANES * sizeof(long long))));
  typedef unsigned Lowest __attribute__((vector_size(LANES * sizeof(unsigned))));
  const Lowest whole = __builtin_convertvector(reinterpret_cast<Bits>(a + TO_WHOLE), Lowest);
  std::memcpy(to, &whole, sizeof(whole));
}

// where lane n of a block comes from: of a (0 to 3) or b (4 to 7), vectors of so many lanes; the same in
// every block
constexpr int source_lane(int n, int block, int lanes)
{
  return n < BLOCK ? block * BLOCK + n : lanes + block * BLOCK + n - BLOCK;
}
template <int i, int j, int k, int l, class V, int... n>
inline V shuffle_lanes(V a, V b, std::integer_sequence<int, n...>)
{
  constexpr int FROM[BLOCK] = {i, j, k, l}, ALL = sizeof...(n);
#if defined(__clang__) || __GNUC__ >= 12
  return __builtin_shufflevector(a, b, source_lane(FROM[n % BLOCK], n / BLOCK, ALL)...);
#else
  V out;
  for (int m = 0; m < ALL; m++) {
    const int from = source_lane(FROM[m % BLOCK], m / BLOCK, ALL);
    out[m] = from < ALL ? a[from] : b[from - ALL];
  }
  return out;
#endif
}
template <int i, int j, int k, int l, class V> inline V native_shuffle(V a, V b)
{
  return shuffle_lanes<i, j, k, l>(a, b,
                                   std::make_integer_sequence<int, sizeof(V) / sizeof(a[0])>());
}

#endif

}    // namespace SPHSolid

#endif
