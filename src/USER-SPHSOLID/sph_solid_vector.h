/* ----------------------------------------------------------------------
   Four doubles at a time: the one place with explicit vector types.

   The rows of sph_solid_rows.h are made of blocks of four doubles, so that a
   pair is a handful of vector loads of its neighbor's row.  (A loop over pairs
   with one component per vector has to gather every component from another
   place, which costs several times the arithmetic.)

   GCC and Clang know such vectors and take the widest instructions they were
   given; for any other compiler, and for a test that both give the same
   numbers, SPHSOLID_PORTABLE_VECTOR selects arrays and loops.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_VECTOR_H
#define LMP_SPH_SOLID_VECTOR_H

#include <cmath>
#include <cstddef>
#include <cstring>
#include <new>
#include <vector>

#if !defined(__GNUC__) && !defined(SPHSOLID_PORTABLE_VECTOR)
#define SPHSOLID_PORTABLE_VECTOR
#endif
#if defined(__FMA__) && !defined(SPHSOLID_PORTABLE_VECTOR)
#include <immintrin.h>
#endif

namespace SPHSolid {

constexpr int LANES = 4;

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
  return {f(0), f(1), f(2), f(3)};
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
template <int i, int j, int k, int l> inline Native native_shuffle(const Native &a, const Native &b)
{
  auto pick = [&](int n) {
    return n < LANES ? a[n] : b[n - LANES];
  };
  return {pick(i), pick(j), pick(k), pick(l)};
}

#else

typedef double Native __attribute__((vector_size(LANES * sizeof(double))));

inline Native native_multiply_add(Native a, Native b, Native c)
{
#ifdef __FMA__
  return _mm256_fmadd_pd(a, b, c);
#else
  return a * b + c;
#endif
}
inline Native native_where_positive(Native condition, Native a, Native b)
{
  return condition > Native{0.0, 0.0, 0.0, 0.0} ? a : b;
}
template <int i, int j, int k, int l> inline Native native_shuffle(Native a, Native b)
{
#if defined(__clang__) || __GNUC__ >= 12
  return __builtin_shufflevector(a, b, i, j, k, l);
#else
  typedef long long Mask __attribute__((vector_size(LANES * sizeof(long long))));
  return __builtin_shuffle(a, b, Mask{i, j, k, l});
#endif
}

#endif

// a number in formulas that take four particles or pairs at a time

class Four {
 public:
  Four() = default;
  Four(double a) : v{a, a, a, a} {}
  Four(double a, double b, double c, double d) : v{a, b, c, d} {}
  explicit Four(const Native &n) : v(n) {}

  double operator[](int k) const { return v[k]; }
  void set(int k, double a) { v[k] = a; }
  const Native &native() const { return v; }

  static Four loaded(const double *from)
  {
    Four a;
    std::memcpy(&a.v, from, sizeof(a.v));
    return a;
  }

  friend Four operator+(const Four &a, const Four &b) { return Four(a.v + b.v); }
  friend Four operator-(const Four &a, const Four &b) { return Four(a.v - b.v); }
  friend Four operator*(const Four &a, const Four &b) { return Four(a.v * b.v); }
  friend Four operator/(const Four &a, const Four &b) { return Four(a.v / b.v); }
  Four operator-() const { return Four(0.0) - *this; }
  Four &operator+=(const Four &b) { return *this = *this + b; }
  Four &operator-=(const Four &b) { return *this = *this - b; }
  Four &operator*=(const Four &b) { return *this = *this * b; }
  Four &operator/=(const Four &b) { return *this = *this / b; }

 private:
  Native v;
};

// a b + c, rounded once where the instruction set can.  Only where it is asked for: the
// compiler, left free to choose, takes it in a vector loop and not in what is left over, and
// numbers would depend on where in a row a pair stands

inline Four multiply_add(Four a, Four b, Four c)
{
  return Four(native_multiply_add(a.native(), b.native(), c.native()));
}

// lanes of a (0 to 3) and b (4 to 7)

template <int i, int j, int k, int l> inline Four shuffle(Four a, Four b)
{
  return Four(native_shuffle<i, j, k, l>(a.native(), b.native()));
}

template <int i, int j, int k, int l> inline Four shuffle(Four a)
{
  return shuffle<i, j, k, l>(a, a);
}

inline Four load(const double *from)
{
  return Four::loaded(from);
}

inline void store(double *to, Four v)
{
  std::memcpy(to, &v.native(), sizeof(Native));
}

// {p0, p1, 0, 0} and {p0, p1, p0, p1}
inline Four load_two(const double *p)
{
  return Four(p[0], p[1], 0.0, 0.0);
}
inline Four load_two_twice(const double *p)
{
  return Four(p[0], p[1], p[0], p[1]);
}

// condition > 0 ? a : b; numbers and vectors of them

inline Four where_positive(Four condition, Four a, Four b)
{
  return Four(native_where_positive(condition.native(), a.native(), b.native()));
}

inline double where_positive(double condition, double a, double b)
{
  return condition > 0.0 ? a : b;
}

template <class Real> inline Real minimum(Real a, Real b)
{
  return where_positive(b - a, a, b);
}

template <class Real> inline Real maximum(Real a, Real b)
{
  return where_positive(a - b, a, b);
}

inline double square_root(double a)
{
  return std::sqrt(a);
}
inline Four square_root(Four a)
{
  return Four(std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3]));
}

inline double sum(Four a)
{
  return (a[0] + a[2]) + (a[1] + a[3]);
}

inline double least(Four a)
{
  const double p = a[0] < a[1] ? a[0] : a[1], q = a[2] < a[3] ? a[2] : a[3];
  return p < q ? p : q;
}

// {sum of a, of b, of c, of d}

inline Four sums(Four a, Four b, Four c, Four d)
{
  const Four ab = shuffle<0, 4, 2, 6>(a, b) + shuffle<1, 5, 3, 7>(a, b);
  const Four cd = shuffle<0, 4, 2, 6>(c, d) + shuffle<1, 5, 3, 7>(c, d);
  return shuffle<0, 1, 4, 5>(ab, cd) + shuffle<2, 3, 6, 7>(ab, cd);
}

// the same of lanes 0, 1 (low) and of lanes 2, 3 (high)

inline void half_sums(Four a, Four b, Four c, Four d, Four &low, Four &high)
{
  const Four ab = shuffle<0, 4, 2, 6>(a, b) + shuffle<1, 5, 3, 7>(a, b);
  const Four cd = shuffle<0, 4, 2, 6>(c, d) + shuffle<1, 5, 3, 7>(c, d);
  low = shuffle<0, 1, 4, 5>(ab, cd);
  high = shuffle<2, 3, 6, 7>(ab, cd);
}

// four rows become four columns

inline void transpose(Four &a, Four &b, Four &c, Four &d)
{
  const Four ab0 = shuffle<0, 4, 2, 6>(a, b), ab1 = shuffle<1, 5, 3, 7>(a, b);
  const Four cd0 = shuffle<0, 4, 2, 6>(c, d), cd1 = shuffle<1, 5, 3, 7>(c, d);
  a = shuffle<0, 1, 4, 5>(ab0, cd0);
  b = shuffle<0, 1, 4, 5>(ab1, cd1);
  c = shuffle<2, 3, 6, 7>(ab0, cd0);
  d = shuffle<2, 3, 6, 7>(ab1, cd1);
}

// arrays of rows that begin on a cache line

template <class T> struct CacheAligned {
  typedef T value_type;
  CacheAligned() = default;
  template <class U> CacheAligned(const CacheAligned<U> &) {}
  static constexpr std::align_val_t LINE{64};
  T *allocate(std::size_t n) { return static_cast<T *>(::operator new(n * sizeof(T), LINE)); }
  void deallocate(T *p, std::size_t) { ::operator delete(p, LINE); }
};
template <class T, class U> inline bool operator==(CacheAligned<T>, CacheAligned<U>)
{
  return true;
}
template <class T, class U> inline bool operator!=(CacheAligned<T>, CacheAligned<U>)
{
  return false;
}

using Rows = std::vector<double, CacheAligned<double>>;

}    // namespace SPHSolid

#endif
