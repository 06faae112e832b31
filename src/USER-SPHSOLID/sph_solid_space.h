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
   Vectors in space as LAMMPS has them: three doubles of each particle, one particle after the
   other.  Those of LANES particles are three packs, in which number e = 3 m + c is component c of
   particle m.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_SPACE_H
#define LMP_SPH_SOLID_SPACE_H

#include "sph_solid_vector.h"

#include <utility>

namespace SPHSolid {

// lanes of a (0 to LANES - 1) and b (from LANES on) across blocks: From::lane(n) becomes lane n

template <class From, std::size_t... n> inline Pack pick(Pack a, Pack b, std::index_sequence<n...>)
{
#if !defined(SPHSOLID_PORTABLE_VECTOR) && (defined(__clang__) || __GNUC__ >= 12)
  return Pack(__builtin_shufflevector(a.native(), b.native(), From::lane(n)...));
#else
  static constexpr int FROM[] = {From::lane(n)...};
  return pack_of([&](int m) {
    return FROM[m] < LANES ? a[FROM[m]] : b[FROM[m] - LANES];
  });
#endif
}
template <class From> inline Pack pick(Pack a, Pack b)
{
  return pick<From>(a, b, std::make_index_sequence<LANES>());
}

constexpr int SPACE = 3;

// pack k of {a0, a0, a0, a1, a1, a1, ...}

template <int k> inline Pack thrice(Pack a)
{
  struct From {
    static constexpr int lane(int n) { return (k * LANES + n) / SPACE; }
  };
  return pick<From>(a, a);
}

// component c of all particles, from the three packs

template <int c> inline Pack component_of(const Pack *packs)
{
  struct FirstTwo {
    static constexpr int lane(int m) { return (SPACE * m + c) % (2 * LANES); }
  };
  struct Third {
    static constexpr int lane(int m)
    {
      return SPACE * m + c < 2 * LANES ? m : SPACE * m + c - LANES;
    }
  };
  return pick<Third>(pick<FirstTwo>(packs[0], packs[1]), packs[2]);
}

// pack k from the components x, y and z of all particles

template <int k> inline Pack pack_of_components(Pack x, Pack y, Pack z)
{
  struct FirstTwo {
    static constexpr int lane(int n)
    {
      return (k * LANES + n) / SPACE + ((k * LANES + n) % SPACE == 1 ? LANES : 0);
    }
  };
  struct Third {
    static constexpr int lane(int n)
    {
      return (k * LANES + n) % SPACE < 2 ? n : LANES + (k * LANES + n) / SPACE;
    }
  };
  return pick<Third>(pick<FirstTwo>(x, y), z);
}

// to += factor from, of the first D components only

template <int D, int k> inline void add_multiple(double *to, const double *from, Pack factor)
{
  struct Changed {
    static constexpr int lane(int n) { return (k * LANES + n) % SPACE < D ? n : LANES + n; }
  };
  const Pack old = load(to + k * LANES);
  const Pack sum = old + thrice<k>(factor) * load(from + k * LANES);
  store(to + k * LANES, pick<Changed>(sum, old));
}
template <int D> inline void add_multiples(double *to, const double *from, Pack factor)
{
  add_multiple<D, 0>(to, from, factor);
  add_multiple<D, 1>(to, from, factor);
  add_multiple<D, 2>(to, from, factor);
}

// D components of LANES particles from an array, and added to one

template <int D> inline void load_components(const double *from, Pack *out)
{
  const Pack packs[SPACE] = {load(from), load(from + LANES), load(from + 2 * LANES)};
  out[0] = component_of<0>(packs);
  out[1] = component_of<1>(packs);
  if constexpr (D == SPACE) out[2] = component_of<2>(packs);
}

template <int D> inline void add_components(double *to, const Pack *v)
{
  const Pack z = D == SPACE ? v[D - 1] : Pack(0.0);
  store(to, load(to) + pack_of_components<0>(v[0], v[1], z));
  store(to + LANES, load(to + LANES) + pack_of_components<1>(v[0], v[1], z));
  store(to + 2 * LANES, load(to + 2 * LANES) + pack_of_components<2>(v[0], v[1], z));
}

}    // namespace SPHSolid

#endif
