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
   Pairs of as many particles as there are lanes, a block, arranged in slots: of
   each particle a slot has one partner or none.

   A slot's neighbors lie side by side in columns as the particles themselves do, so
   many columns further, or, where no two particles of the block have neighbors
   that lie like that, anywhere: then their columns are gathered.  Of each particle partners
   keep their order, so that sums depend neither on where particles are stored nor on
   which others are in the block.  A slot's pair that is none has factor 0.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_SLOTS_H
#define LMP_SPH_SOLID_SLOTS_H

#include "sph_solid_shared.h"
#include "sph_solid_vector.h"

#include <cstdint>
#include <vector>

namespace SPHSolid {

// where a slot's neighbors are: numbers in columns that they are further, which a sweep need not
// compute from how many columns that is, or GATHERED + n
constexpr int GATHERED = 1 << 30;
// who is more columns away is gathered: columns have fewer than 60 components
constexpr int FURTHEST = GATHERED / 64;

inline bool is_within_reach(int columns_apart)
{
  return columns_apart > -FURTHEST && columns_apart < FURTHEST;
}

// this part of all slots gathered is worth having rows of what columns have
constexpr double WORTH_ROWS = 0.2;

struct Partner {
  int row;    // local index, or that of an image
  int column;
  bool nearest;              // of the acceleration correction
  std::int64_t direction;    // of partners that lie alike the same; decides on their order
  std::int64_t apart;        // and where that is equal: ID less that of the particle
  double r;                  // distance in the reference
};

inline bool comes_before(const Partner &a, const Partner &b)
{
  if (a.nearest != b.nearest) return a.nearest;
  return a.direction != b.direction ? a.direction < b.direction : a.apart < b.apart;
}

// partners of the particles from column first on, one list per lane: call(side_by_side, offset,
// which) for each slot; which[lane]: index in the lane's list, or -1.  price: so many times the
// work of another one is a gathered slot

template <int LANES, class Call>
void arrange(const std::vector<Partner> (&partners)[LANES], int first, int price, Call call)
{
  int next[LANES] = {};
  for (;;) {
    const Partner *head[LANES], *lead = nullptr;
    int open = 0, offset = 0;
    for (int m = 0; m < LANES; m++) {
      head[m] = next[m] < static_cast<int>(partners[m].size()) ? &partners[m][next[m]] : nullptr;
      if (!head[m]) continue;
      open++;
      if (lead && !comes_before(*head[m], *lead)) continue;
      lead = head[m];
      offset = lead->column - (first + m);
    }
    if (!lead) return;
    int which[LANES], together = 0;
    for (int m = 0; m < LANES; m++)
      if (head[m] && head[m]->column - (first + m) == offset) together++;
    const bool side_by_side = open <= price * together && is_within_reach(offset);
    for (int m = 0; m < LANES; m++) {
      const bool taken = head[m] && (!side_by_side || head[m]->column - (first + m) == offset);
      which[m] = taken ? next[m]++ : -1;
    }
    call(side_by_side, offset, which);
  }
}

template <int LANES> struct SlotsOf {
  std::vector<int> first;         // slot of each block, and one behind the last
  std::vector<int> near_first;    // the same if there were only slots with nearest partners
  std::vector<int> further;
  // of slots that read nearly the same columns, the last one: not 0 but how far its first column is from the
  // end of the chunk, 255 at most
  std::vector<unsigned char> foremost;
  std::vector<int> gathered;    // LANES columns each
  std::vector<int> count;       // partners of each column

  // LANES of each slot.  In single precision, so that rounding does not tell pairs of a lattice
  // apart.  They are the same seen from i and from j, and if all that follows from them is computed in
  // double precision sums are as exact as with others: of linear fields and of energy
  // and momentum to rounding of doubles.  h0 is the largest smoothing length
  static constexpr int FACTOR = 0;          // grad_i W(X_ij) = factor X_ij / h0^(D+2)
  static constexpr int NEARNESS = LANES;    // q/(q^2 + 0.01), q = |X_ij|/h_ij: eq. 24's factor
  static constexpr int CONSTANTS = 2 * LANES;
  SharedVectors<float, CONSTANTS> constants;

  std::size_t pairs() const { return static_cast<std::size_t>(first.back()) * LANES; }
  int nearest(int block) const { return near_first[block + 1] - near_first[block]; }
  double memory_usage() const
  {
    const std::size_t ints = first.capacity() + near_first.capacity() + further.capacity() +
        gathered.capacity() + count.capacity();
    return static_cast<double>(foremost.capacity() + ints * sizeof(int)) + constants.memory_usage();
  }
};

}    // namespace SPHSolid

#endif
