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
   Packs of four or eight doubles: the one place with explicit vector types.

   The rows of sph_solid_rows.h are made of blocks of four doubles, so that a
   pair is a handful of vector loads of its neighbor's row.  (A loop over pairs
   with one component per vector has to gather every component from another
   place, which costs several times the arithmetic.)

   A pack holds one number each of LANES pairs or particles, or as many blocks
   as it has room for, of as many pairs.  With four lanes that is one block; with
   eight (AVX-512) two, of pair k and of pair k + 4.  Everything between lanes
   stays inside its block, so that the same lines work with either.

   GCC and Clang know such vectors and take the widest instructions they were
   given; for any other compiler, and for a test that both give the same
   numbers, SPHSOLID_PORTABLE_VECTOR selects arrays and loops.  SPHSOLID_LANES
   can be set to 4 or 8 for tests.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_VECTOR_H
#define LMP_SPH_SOLID_VECTOR_H

#include <cmath>
#include <cstddef>
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

#ifdef SPHSOLID_PORTABLE_VECTOR

struct Native {
  double lane[LANES];
  double &operator[](int k) { return lane[k]; }
  double operator[](int k) const { return lane[k]; }
};

template <class F> inline Native each_lane(F f)
{
  Native out;
  for (int k = 0; k < LANES; k++) out.lane[k] = f(k);
  return out;
}
inline Native operator+(const Native &a, const Native &b)
{
  return each_lane([&](int k) {
    return a[k] + b[k];
  });
}
inline Native operator-(const Native &a, const Native &b)
{
  return each_lane([&](int k) {
    return a[k] - b[k];
  });
}
inline Native operator*(const Native &a, const Native &b)
{
  return each_lane([&](int k) {
    return a[k] * b[k];
  });
}
inline Native operator/(const Native &a, const Native &b)
{
  return each_lane([&](int k) {
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
inline Native native_where_positive(const Native &condition, const Native &a, const Native &b)
{
  return each_lane([&](int k) {
    return condition[k] > 0.0 ? a[k] : b[k];
  });
}
inline Native native_square_root(const Native &a)
{
  return each_lane([&](int k) {
    return std::sqrt(a[k]);
  });
}
inline Native native_minimum(const Native &a, const Native &b)
{
  return each_lane([&](int k) {
    return a[k] < b[k] ? a[k] : b[k];
  });
}
inline Native native_maximum(const Native &a, const Native &b)
{
  return each_lane([&](int k) {
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

// a number in formulas that take as many particles or pairs at a time

class Pack {
 public:
  Pack() = default;
  Pack(double a) : v(native_all(a)) {}
  explicit Pack(const Native &n) : v(n) {}

  double operator[](int k) const { return v[k]; }
  const Native &native() const { return v; }

  friend Pack operator+(const Pack &a, const Pack &b) { return Pack(a.v + b.v); }
  friend Pack operator-(const Pack &a, const Pack &b) { return Pack(a.v - b.v); }
  friend Pack operator*(const Pack &a, const Pack &b) { return Pack(a.v * b.v); }
  friend Pack operator/(const Pack &a, const Pack &b) { return Pack(a.v / b.v); }
  Pack operator-() const { return Pack(0.0) - *this; }
  Pack &operator+=(const Pack &b) { return *this = *this + b; }
  Pack &operator-=(const Pack &b) { return *this = *this - b; }
  Pack &operator*=(const Pack &b) { return *this = *this * b; }
  Pack &operator/=(const Pack &b) { return *this = *this / b; }

 private:
  Native v;
};

// a b + c, rounded once where the instruction set can.  Only where it is asked for: the
// compiler, left free to choose, takes it in a vector loop and not in what is left over, and
// numbers would depend on where in a row a pair stands

inline Pack multiply_add(Pack a, Pack b, Pack c)
{
  return Pack(native_multiply_add(a.native(), b.native(), c.native()));
}

inline double multiply_add(double a, double b, double c)
{
#ifdef __FMA__
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}

// lanes of a (0 to 3) and b (4 to 7)

template <int i, int j, int k, int l> inline Pack shuffle(Pack a, Pack b)
{
  return Pack(native_shuffle<i, j, k, l>(a.native(), b.native()));
}

template <int i, int j, int k, int l> inline Pack shuffle(Pack a)
{
  return shuffle<i, j, k, l>(a, a);
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

// the same in single precision; stored is the number as it is then

#ifdef SPHSOLID_PORTABLE_VECTOR
inline Pack load(const float *from)
{
  return Pack(each_lane([from](int k) {
    return static_cast<double>(from[k]);
  }));
}
inline Pack store_rounded(float *to, Pack v)
{
  for (int k = 0; k < LANES; k++) to[k] = static_cast<float>(v[k]);
  return load(to);
}
#else
typedef float NativeSingle __attribute__((vector_size(LANES * sizeof(float))));

// GCC 12 converts eight numbers in halves
#ifdef SPHSOLID_AVX512
inline Native widened(NativeSingle n)
{
  return _mm512_maskz_cvtps_pd(0xFF, n);
}
inline NativeSingle narrowed(Native n)
{
  return _mm512_maskz_cvtpd_ps(0xFF, n);
}
#else
inline Native widened(NativeSingle n)
{
  return __builtin_convertvector(n, Native);
}
inline NativeSingle narrowed(Native n)
{
  return __builtin_convertvector(n, NativeSingle);
}
#endif

inline Pack load(const float *from)
{
  NativeSingle n;
  std::memcpy(&n, from, sizeof(n));
  return Pack(widened(n));
}
inline Pack store_rounded(float *to, Pack v)
{
  const NativeSingle n = narrowed(v.native());
  std::memcpy(to, &n, sizeof(n));
  return Pack(widened(n));
}
#endif

// value(lane) of each.  Not by way of an array: its load would have to wait for the stores

template <class F> inline Pack pack_of(F value)
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

// 1 in the lanes that are less than n, 0 in the others

inline Pack first_lanes(int n)
{
  static constexpr double STEP[2 * LANES] = {
#if SPHSOLID_LANES == 8
    1.0,
    1.0,
    1.0,
    1.0,
#endif
    1.0,
    1.0,
    1.0,
    1.0
  };
  return load(STEP + LANES - (n < 0 ? 0 : n < LANES ? n : LANES));
}

// the first n lanes, if there are as many; what lies behind them stays as it is

inline void store_first(double *to, Pack v, int n)
{
  if (n >= LANES) return store(to, v);
#if defined(SPHSOLID_AVX512)
  _mm512_mask_storeu_pd(to, static_cast<__mmask8>((1 << n) - 1), v.native());
#else
  for (int m = 0; m < n; m++) to[m] = v[m];
#endif
}

// where the blocks of a pack lie: block b has lanes 4 b to 4 b + 3

struct Addresses {
  const double *block[BLOCKS];

  // rows of particles j[0] and, with a second block, j[4]
  Addresses(const double *rows, const int *j, int stride)
  {
    for (int b = 0; b < BLOCKS; b++)
      block[b] = rows + static_cast<std::ptrdiff_t>(j[b * BLOCK]) * stride;
  }
  // the same of rows that have pointers
  Addresses(const double *const *rows, const int *j)
  {
    for (int b = 0; b < BLOCKS; b++) block[b] = rows[j[b * BLOCK]];
  }
  Addresses(const double *first, const double *second)
  {
    for (int b = 0; b < BLOCKS; b++) block[b] = b == 0 ? first : second;
  }
  explicit Addresses(const double *same) : Addresses(same, same) {}
  Addresses operator+(int n) const
  {
    Addresses a = *this;
    for (int b = 0; b < BLOCKS; b++) a.block[b] += n;
    return a;
  }
};

#if defined(SPHSOLID_AVX512)
inline Pack joined(__m256d low, __m256d high)
{
  return Pack(_mm512_maskz_insertf64x4(0xFF, _mm512_castpd256_pd512(low), high, 1));
}
#endif

// a block from each address, one block in all, one double in all lanes of each block

inline Pack load(const Addresses &from)
{
#if defined(SPHSOLID_AVX512)
  return joined(_mm256_loadu_pd(from.block[0]), _mm256_loadu_pd(from.block[1]));
#else
  Native n;
  for (int b = 0; b < BLOCKS; b++)
    std::memcpy(reinterpret_cast<char *>(&n) + b * BLOCK * sizeof(double), from.block[b],
                BLOCK * sizeof(double));
  return Pack(n);
#endif
}

inline Pack load_block(const double *from)
{
#if defined(SPHSOLID_AVX512)
  return Pack(_mm512_maskz_broadcast_f64x4(0xFF, _mm256_loadu_pd(from)));
#else
  return load(Addresses(from));
#endif
}

inline Pack load_all(const Addresses &from)
{
#if defined(SPHSOLID_AVX512)
  return Pack(
      _mm512_mask_broadcastsd_pd(_mm512_set1_pd(*from.block[0]), 0xF0, _mm_load_sd(from.block[1])));
#else
  return pack_of([&](int n) {
    return *from.block[n / BLOCK];
  });
#endif
}

// {p0, p1, p0, p1} in each block

inline Pack load_two_twice(const Addresses &from)
{
#if defined(SPHSOLID_AVX512)
  return Pack(
      _mm512_mask_broadcast_f64x2(_mm512_maskz_broadcast_f64x2(0xFF, _mm_loadu_pd(from.block[0])),
                                  0xF0, _mm_loadu_pd(from.block[1])));
#else
  return pack_of([&](int n) {
    return from.block[n / BLOCK][n % 2];
  });
#endif
}

// two doubles from each of LANES/2 addresses; and LANES/2 doubles, each of them twice

inline Pack load_twos(const double *const *from)
{
#if defined(SPHSOLID_AVX512)
  auto block = [from](int n) {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(from[n])),
                                _mm_loadu_pd(from[n + 1]), 1);
  };
  return joined(block(0), block(2));
#else
  return pack_of([from](int n) {
    return from[n / 2][n % 2];
  });
#endif
}

inline Pack load_each_twice(const double *from)
{
#if defined(SPHSOLID_AVX512)
  return Pack(_mm512_maskz_permutexvar_pd(0xFF, _mm512_set_epi64(3, 3, 2, 2, 1, 1, 0, 0),
                                          _mm512_castpd256_pd512(_mm256_loadu_pd(from))));
#else
  return pack_of([from](int n) {
    return from[n / 2];
  });
#endif
}

inline void store(const Addresses &to, Pack v)
{
  for (int b = 0; b < BLOCKS; b++)
    std::memcpy(const_cast<double *>(to.block[b]),
                reinterpret_cast<const char *>(&v.native()) + b * BLOCK * sizeof(double),
                BLOCK * sizeof(double));
}

// condition > 0 ? a : b; numbers and vectors of them

inline Pack where_positive(Pack condition, Pack a, Pack b)
{
  return Pack(native_where_positive(condition.native(), a.native(), b.native()));
}

inline double where_positive(double condition, double a, double b)
{
  return condition > 0.0 ? a : b;
}

// the lanes of j and v where condition > 0, side by side; returns how many.  A whole vector is
// written, of which the rest is of no use.  COLLECTS_LANES: without a branch per lane

#if defined(SPHSOLID_AVX512) && defined(__AVX512VL__)
constexpr bool COLLECTS_LANES = true;
inline int collect_positive(Pack condition, const int *j, Pack v, int *to_j, double *to_v)
{
  const __mmask8 wanted = _mm512_cmp_pd_mask(condition.native(), Native{}, _CMP_GT_OQ);
  __m256i lanes;
  std::memcpy(&lanes, j, sizeof(lanes));
  lanes = _mm256_maskz_compress_epi32(wanted, lanes);
  std::memcpy(to_j, &lanes, sizeof(lanes));
  store(to_v, Pack(_mm512_maskz_compress_pd(wanted, v.native())));
  return __builtin_popcount(wanted);
}
#else
constexpr bool COLLECTS_LANES = false;
inline int collect_positive(Pack condition, const int *j, Pack v, int *to_j, double *to_v)
{
  int n = 0;
  for (int k = 0; k < LANES; k++) {
    if (!(condition[k] > 0.0)) continue;
    to_j[n] = j[k];
    to_v[n++] = v[k];
  }
  return n;
}
#endif

// of two, one of which is not a number, the second one

inline double minimum(double a, double b)
{
  return a < b ? a : b;
}
inline double maximum(double a, double b)
{
  return a > b ? a : b;
}
inline Pack minimum(Pack a, Pack b)
{
  return Pack(native_minimum(a.native(), b.native()));
}
inline Pack maximum(Pack a, Pack b)
{
  return Pack(native_maximum(a.native(), b.native()));
}

inline double square_root(double a)
{
  return std::sqrt(a);
}
inline Pack square_root(Pack a)
{
  return Pack(native_square_root(a.native()));
}

// blocks exchanged, if there are two

inline Pack other_block(Pack a)
{
#if defined(SPHSOLID_AVX512)
  return Pack(_mm512_maskz_shuffle_f64x2(0xFF, a.native(), a.native(), 0x4E));
#else
  return pack_of([&](int n) {
    return a[(n + BLOCK) % LANES];
  });
#endif
}

// the sum of all blocks, in each of them

inline Pack sum_of_blocks(Pack a)
{
  return BLOCKS == 1 ? a : a + other_block(a);
}

// the sum of all blocks of a and, in a second block, of b

inline Pack sums_of_blocks(Pack a, Pack b)
{
#if defined(SPHSOLID_AVX512)
  const Native p = a.native(), q = b.native();
  return Pack(_mm512_maskz_shuffle_f64x2(0xFF, p, q, 0x44) +
              _mm512_maskz_shuffle_f64x2(0xFF, p, q, 0xEE));
#else
  if (BLOCKS == 1) return a;
  return pack_of([&](int n) {
    const Pack &from = n < BLOCK ? a : b;
    return from[n % BLOCK] + from[n % BLOCK + LANES - BLOCK];
  });
#endif
}

inline double sum(Pack a)
{
  const Pack s = sum_of_blocks(a);
  return (s[0] + s[2]) + (s[1] + s[3]);
}

inline double least(Pack a)
{
  if (BLOCKS > 1) a = minimum(a, other_block(a));
  double least = a[0];
  for (int k = 1; k < BLOCK; k++) least = a[k] < least ? a[k] : least;
  return least;
}

inline bool all_positive(Pack a)
{
#if defined(SPHSOLID_AVX512)
  return _mm512_cmp_pd_mask(a.native(), Native{}, _CMP_GT_OQ) == 0xFF;
#else
  bool all = true;
  for (int k = 0; k < LANES; k++) all = all && a[k] > 0.0;
  return all;
#endif
}

// {sum of a, of b, of c, of d}

inline Pack sums(Pack a, Pack b, Pack c, Pack d)
{
  const Pack ab = shuffle<0, 4, 2, 6>(a, b) + shuffle<1, 5, 3, 7>(a, b);
  const Pack cd = shuffle<0, 4, 2, 6>(c, d) + shuffle<1, 5, 3, 7>(c, d);
  return shuffle<0, 1, 4, 5>(ab, cd) + shuffle<2, 3, 6, 7>(ab, cd);
}

// four rows become four columns

inline void transpose(Pack &a, Pack &b, Pack &c, Pack &d)
{
  const Pack ab0 = shuffle<0, 4, 2, 6>(a, b), ab1 = shuffle<1, 5, 3, 7>(a, b);
  const Pack cd0 = shuffle<0, 4, 2, 6>(c, d), cd1 = shuffle<1, 5, 3, 7>(c, d);
  a = shuffle<0, 1, 4, 5>(ab0, cd0);
  b = shuffle<0, 1, 4, 5>(ab1, cd1);
  c = shuffle<2, 3, 6, 7>(ab0, cd0);
  d = shuffle<2, 3, 6, 7>(ab1, cd1);
}

// lane m of each block in all of its lanes, for m = 0 to 3

struct Spread {
  Pack of[BLOCK];
  explicit Spread(Pack a) :
      of{shuffle<0, 0, 0, 0>(a), shuffle<1, 1, 1, 1>(a), shuffle<2, 2, 2, 2>(a),
         shuffle<3, 3, 3, 3>(a)}
  {
  }
  const Pack &operator[](int m) const { return of[m]; }
};

}    // namespace SPHSolid

#endif
