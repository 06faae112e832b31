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
   Packs of blocks: what is done between lanes.

   What LAMMPS has of a particle lies in rows, stress six numbers long: four doubles of each
   of four particles, a block, are loaded and transposed.  A pack holds as many blocks as it has room for.
   With four lanes that is one; with eight (AVX-512) two, of particle k and of particle
   k + 4.  Everything between lanes stays inside its block, so that the same lines work with either.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_BLOCKS_H
#define LMP_SPH_SOLID_BLOCKS_H

#include "sph_solid_vector.h"

namespace SPHSolid {

// lanes of a (0 to 3) and b (4 to 7)

template <int i, int j, int k, int l, class Pack> inline Pack shuffle(Pack a, Pack b)
{
  return Pack(native_shuffle<i, j, k, l>(a.native(), b.native()));
}

// where the blocks of a pack lie: block b has lanes 4 b to 4 b + 3

struct Addresses {
  const double *block[BLOCKS];

  // rows j[0] and, with a second block, j[4] of an array with so many columns
  Addresses(const double *array, int columns, const int *j)
  {
    for (int b = 0; b < BLOCKS; b++) block[b] = array + columns * std::ptrdiff_t(j[b * BLOCK]);
  }
  Addresses(const double *first, const double *second)
  {
    for (int b = 0; b < BLOCKS; b++) block[b] = b == 0 ? first : second;
  }
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

// a block from each address

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

// of a wide pack from rows 0, 4, 8 and 12, as far as there are lanes, from component c on

inline WidePack load_blocks(const float *const *rows, int c)
{
#if defined(SPHSOLID_AVX512)
  __m512 n = _mm512_castps128_ps512(_mm_loadu_ps(rows[0] + c));
  n = _mm512_maskz_insertf32x4(0xFFFF, n, _mm_loadu_ps(rows[BLOCK] + c), 1);
  n = _mm512_maskz_insertf32x4(0xFFFF, n, _mm_loadu_ps(rows[2 * BLOCK] + c), 2);
  return WidePack(_mm512_maskz_insertf32x4(0xFFFF, n, _mm_loadu_ps(rows[3 * BLOCK] + c), 3));
#else
  NativeWide n;
  for (int b = 0; b < WIDE / BLOCK; b++)
    std::memcpy(reinterpret_cast<char *>(&n) + b * BLOCK * sizeof(float), rows[b * BLOCK] + c,
                BLOCK * sizeof(float));
  return WidePack(n);
#endif
}
inline Pack load_blocks(const double *const *rows, int c)
{
  return load(Addresses(rows[0] + c, rows[LANES - BLOCK] + c));
}

inline void store(const Addresses &to, Pack v)
{
  for (int b = 0; b < BLOCKS; b++)
    std::memcpy(const_cast<double *>(to.block[b]),
                reinterpret_cast<const char *>(&v.native()) + b * BLOCK * sizeof(double),
                BLOCK * sizeof(double));
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

template <class Pack> inline bool all_positive(Pack a)
{
  return larger_lanes(a, Pack(0.0)) == first_lanes(lanes_of<Pack>);
}

// of both halves

inline double sum(WidePack a)
{
  return sum(part_of<0>(a)) + sum(part_of<1>(a));
}
inline double least(WidePack a)
{
  return minimum(least(part_of<0>(a)), least(part_of<1>(a)));
}

// four rows become four columns

template <class Pack> inline void transpose(Pack &a, Pack &b, Pack &c, Pack &d)
{
  const Pack ab0 = shuffle<0, 4, 2, 6>(a, b), ab1 = shuffle<1, 5, 3, 7>(a, b);
  const Pack cd0 = shuffle<0, 4, 2, 6>(c, d), cd1 = shuffle<1, 5, 3, 7>(c, d);
  a = shuffle<0, 1, 4, 5>(ab0, cd0);
  b = shuffle<0, 1, 4, 5>(ab1, cd1);
  c = shuffle<2, 3, 6, 7>(ab0, cd0);
  d = shuffle<2, 3, 6, 7>(ab1, cd1);
}

}    // namespace SPHSolid
#endif
