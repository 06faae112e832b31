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
   What the pairs of a slot need: vectors and tensors with a lane for each pair, and their sums.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LANES_H
#define LMP_SPH_SOLID_LANES_H

#include "sph_solid_blocks.h"
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

template <int D, class Pack> inline Pack dot(const Pack *v, const Pack *w)
{
  Pack s = v[0] * w[0];
  for (int a = 1; a < D; a++) s = multiply_add(v[a], w[a], s);
  return s;
}
// and s, in as many operations
template <int D, class Pack> inline Pack add_dot(Pack s, const Pack *v, const Pack *w)
{
  for (int a = 0; a < D; a++) s = multiply_add(v[a], w[a], s);
  return s;
}

// of as many pairs as there are lanes: a lane of each component belongs to one of them

template <int D, class Pack> struct Components {
  Pack x[D], v[D];

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

template <int D, class Pack> struct TensorSums {
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

 private:
  template <int k> [[gnu::always_inline]] void add_one(const Pack *v, const Pack *w)
  {
    sum[k / D][k % D] = multiply_add(v[k / D], w[k % D], sum[k / D][k % D]);
  }
};

}    // namespace SPHSolid

#endif
