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
   Vectors of numbers that are constant, as those of pairs in the Lagrangian frame are:
   which are alike to the last bit share one entry.

   On a lattice some hundred entries are all there are and stay in the first-level cache,
   where numbers of each pair would be read from memory in every step.  Where nothing
   is alike every vector has an entry of its own.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_SHARED_H
#define LMP_SPH_SOLID_SHARED_H

#include "sph_solid_fingerprint.h"
#include "sph_solid_storage.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace SPHSolid {

// a number with 32 of its 53 bits: what follows from lengths of a lattice, which differ by
// rounding, is then the same for all pairs that are alike, but for one in some thousands

inline double rounded(double x)
{
  const double large = x * 0x1p21;
  return (x + large) - large;
}

// of N numbers each

template <class Number, int N> class SharedVectors {
 public:
  using Numbers = std::vector<Number, CacheAligned<Number>>;

  // so many vectors, all of which are still without numbers
  void begin(std::size_t vectors)
  {
    entry.assign(vectors, 0);
    data.clear();
    recent.assign(std::size_t(WAYS) << PLACE_BITS, -1);
  }
  // those of several vectors, one after the other; one thread at a time
  void enter(std::size_t first, const Numbers &of)
  {
    for (std::size_t at = 0; at < of.size(); at += N) entry[first++] = place(&of[at]);
  }
  void end()
  {
    data.shrink_to_fit();
    recent = {};
  }

  const Number *of(std::size_t vector) const { return entry_at(entry[vector]); }
  // of a run of vectors, for a loop over them
  struct Run {
    const int *entry;
    const Number *data;
    const Number *of(std::ptrdiff_t k) const { return data + entry[k] * std::ptrdiff_t(N); }
  };
  Run from(std::size_t first) const { return {entry.data() + first, data.data()}; }
  // for where n of them are
  void ask(std::size_t first, int n) const { prefetch_list(entry.data() + first, n); }
  double memory_usage() const
  {
    return static_cast<double>(entry.capacity() * sizeof(int) + data.capacity() * sizeof(Number));
  }

 private:
  // the last entries, the newest WAYS of those for which the same place follows from their numbers: one
  // that is not there any more is entered again.  With one way some of a few hundred would always
  // put each other out
  static constexpr int PLACE_BITS = 10, WAYS = 4;
  std::vector<int> recent;

  std::vector<int> entry;    // of every vector
  Numbers data;

  int place(const Number *numbers)
  {
    int *known = &recent[WAYS * place_of(numbers)];
    for (int k = 0; k < WAYS && known[k] >= 0; k++)
      if (std::memcmp(entry_at(known[k]), numbers, N * sizeof(Number)) == 0) return known[k];
    std::copy_backward(known, known + WAYS - 1, known + WAYS);
    known[0] = static_cast<int>(data.size() / N);
    data.insert(data.end(), numbers, numbers + N);
    return known[0];
  }
  const Number *entry_at(int k) const { return &data[static_cast<std::size_t>(k) * N]; }

  static std::size_t place_of(const Number *numbers)
  {
    Fingerprint print(N);
    for (int k = 0; k < N; k++) print.add(static_cast<double>(numbers[k]));
    return print.value() >> (64 - PLACE_BITS);    // the highest bits depend on all numbers
  }
};

}    // namespace SPHSolid

#endif
