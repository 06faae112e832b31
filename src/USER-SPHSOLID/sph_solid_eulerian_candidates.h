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
   The Eulerian frame between two neighbor lists: columns, and candidates arranged in slots.
   Members of EulerianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EULERIAN_CANDIDATES_H
#define LMP_SPH_SOLID_EULERIAN_CANDIDATES_H

#include "sph_solid_eulerian.h"

#include <limits>

namespace {

// a gathered slot is so many times the work of another
template <int LANES> constexpr int PRICE = LANES > 8 ? 6 : 4;

// where slots are so many times the work of slots without a place left empty there may be a better order
// of particles, which is not looked for again before work has grown as much, and has to be better
// by so much.  A few particles take more in any order: theirs is that of IDs
constexpr double WORTH_ANOTHER_ORDER = 2.5, MUCH_BETTER = 0.9;
constexpr std::size_t MANY = 1000;

template <int D, class Precision>
void EulerianSweeps<D, Precision>::new_neighbors(const Particles &p, const NeighborRows &list,
                                                 double reach)
{
  Base::find_image_candidates(p, list, p.x, reach);
  nparticles = p.nall;
  arrange_candidates(p, list);
  if (own.size() >= MANY && work() > WORTH_ANOTHER_ORDER * work_when_tried)
    try_other_order(p, list);
  const double gathered = static_cast<double>(candidates.gathered.size()) / LANES;
  if (gathered > WORTH_ROWS * static_cast<double>(candidates.further.size()))
    this->size_columns(components(), true);
  for (std::size_t row = 0; row < column_of.size(); row++)
    if (column_of[row] >= 0) place_constants(p, source_of(static_cast<int>(row)), column_of[row]);
  for (int column = static_cast<int>(own.size()); column < end_of_own; column++)
    place_constants(p, own.back(), column);    // behind the last particle the last one again
  make_room_for_pairs();
}

template <int D, class Precision>
void EulerianSweeps<D, Precision>::try_other_order(const Particles &p, const NeighborRows &list)
{
  const double before = work();
  by_position = !by_position;
  arrange_candidates(p, list);
  work_when_tried = std::min(work(), before);
  if (work() < MUCH_BETTER * before) return;
  by_position = !by_position;
  arrange_candidates(p, list);
}

template <int D, class Precision>
void EulerianSweeps<D, Precision>::place_constants(const Particles &p, int i, int column)
{
  const TypeData &type = types[p.type[i]];
  columns.set(column, MASS, p.mass[i]);
  if (uniform) return;
  columns.set(column, at_h, type.h);
  columns.set(column, at_near, opt.hbar * type.spacing);
}

/* ----------------------------------------------------------------------
   columns: own particles, ghosts, images.  In the order of IDs a lattice is row by row, turned
   or not, as create_atoms has made it, however LAMMPS sorts its particles or moves them
   between ranks, and sums over pairs depend on nothing of that.  Where IDs say nothing, particles are
   put in rows by their positions
------------------------------------------------------------------------- */

template <int D, class Precision>
void EulerianSweeps<D, Precision>::place_columns(const Particles &p, const NeighborRows &list)
{
  struct Place {
    std::int64_t key;
    int row;
  };
  auto position = [&](int row) {
    const double *x = p.x[source_of(row)];
    std::array<double, D> at;
    if (row < p.nall)
      std::copy_n(x, D, at.data());
    else
      images.template position<D>(row - p.nall, x, at.data());
    return at;
  };
  auto before = [&](const Place &a, const Place &b) {
    if (a.key != b.key) return a.key < b.key;
    const auto x = position(a.row), y = position(b.row);    // periodic images have one ID
    return x != y ? x < y : a.row < b.row;
  };
  double width = NO_LIMIT;
  for (const TypeData &type : types)
    if (type.h > 0.0 && type.spacing > 0.0) width = std::min(width, type.spacing);
  std::vector<Place> places;
  places.reserve(p.nall + images.count());
  auto add = [&](int row) {
    const int i = source_of(row);
    std::int64_t key = p.id ? p.id[i] : i;
    if (by_position) {
      // rows along x, a spacing wide.  Of a lattice none is where rounding decides
      const auto x = position(row);
      key = 0;
      for (int a = D - 1; a > 0; a--) key = key * (1 << 20) + std::llround(x[a] / width + 0.25);
    }
    places.push_back({key, row});
  };
  for (int ii = 0; ii < list.inum; ii++) add(list.ilist[ii]);
  for (int i = p.nlocal; i < p.nall; i++)
    if (Base::has_material(p, i)) add(i);
  for (int k = 0; k < images.count(); k++) add(p.nall + k);
  if (!std::is_sorted(places.begin(), places.end(), before))
    std::sort(places.begin(), places.end(), before);

  std::vector<int> owned, ghosts, mirrored;
  for (const Place &place : places)
    (place.row < p.nlocal ? owned : place.row < p.nall ? ghosts : mirrored).push_back(place.row);
  this->number_columns(owned, ghosts, mirrored, p.nall + images.count());
  ranked.assign(column_of.size(), -1);
  for (std::size_t k = 0; k < places.size(); k++)
    ranked[places[k].row] = std::int64_t(k) << 32 | column_of[places[k].row];
}

/* ----------------------------------------------------------------------
   the candidates of a block's particles, arranged in slots: those as many columns further in
   one, where there are enough of them, and others gathered.  Of each particle they keep
   their order
------------------------------------------------------------------------- */

template <int D, class Precision> struct EulerianSweeps<D, Precision>::Arranging {
  const EulerianSweeps &of;
  const NeighborRows &list;
  const int first_image;                    // column
  std::vector<int> distances;               // how many columns further there are candidates
  std::vector<Bits> together;               // which lanes have one as much further
  std::vector<std::int64_t> lane[LANES];    // of each candidate what `ranked` has, in this order
  Candidates found;

  // the next candidate of each lane: how much further it is in rank and in columns
  static constexpr int NONE = std::numeric_limits<int>::max();
  int rank[LANES], apart[LANES], next[LANES];
  unsigned rare;    // lanes where few others have one as far apart

  Arranging(const EulerianSweeps &s, const NeighborRows &rows) :
      of(s), list(rows), first_image(s.end_of_columns - s.images.count()),
      together(2 * s.end_of_columns + 1, 0)
  {
  }

  // for twice as many slots as candidates would fill, of which the system gives as much as is written
  // to: vectors that grow need room for both
  void make_room(int first, int end)
  {
    std::size_t n = 0;
    for (int block = first; block < end; block++)
      for (int m = 0; m < of.particles_of(block); m++)
        n += list.numneigh[of.own[block * LANES + m]];
    n = 2 * n / LANES;
    found.further.reserve(n);
    found.lanes.reserve(n);
    found.mirrored.reserve(n);
  }

  // append the slots of a block.  Own particles are in the order of columns, and where no candidate
  // is any other that is the order of slots
  void arrange(int block)
  {
    const bool among_own = find_distances(block);
    bool plain = among_own;
    for (const int columns : distances) plain = plain && !is_rare(columns);
    if (plain)
      for (const int columns : distances) add_slot(block * LANES, true, columns, with(columns));
    else {
      if (among_own)
        sort_by_distance(block);
      else
        sort_by_rank(block);
      merge(block * LANES);
    }
    for (const int columns : distances) with(columns) = 0;
    found.first.push_back(static_cast<int>(found.further.size()));
  }

 private:
  static int column(std::int64_t candidate) { return static_cast<int>(candidate & 0x7FFFFFFF); }
  Bits &with(int columns_apart) { return together[columns_apart + of.end_of_columns]; }
  bool is_rare(int columns_apart)
  {
    return PRICE<LANES> * count_lanes(with(columns_apart), LANES) <= LANES ||
        !is_within_reach(columns_apart);
  }

  // call(row) for the candidates of a particle
  template <class Call> void each_candidate(int i, Call call) const
  {
    for (int k = 0; k < list.numneigh[i]; k++) call(list.firstneigh[i][k] & INDEX_MASK);
    if (!of.images.any()) return;
    for (int k = of.image_first[i]; k < of.image_first[i + 1]; k++) call(of.image_j[k]);
  }

  // are all of them own particles?
  bool find_distances(int block)
  {
    bool among_own = true;
    distances.clear();
    for (int m = 0; m < of.particles_of(block); m++) {
      const int own = block * LANES + m;
      each_candidate(of.own[own], [&](int row) {
        const int column = of.column_of[row];
        if (column < 0) return;    // no material
        among_own = among_own && column < of.end_of_own;
        Bits &lanes = with(column - own);
        if (!lanes) distances.push_back(column - own);
        lanes |= static_cast<Bits>(1u << m);
        found.count++;
      });
    }
    std::sort(distances.begin(), distances.end());
    return among_own;
  }
  void sort_by_distance(int block)
  {
    for (int m = 0; m < LANES; m++) {
      lane[m].clear();
      for (const int columns : distances)
        if (with(columns) >> m & 1)
          lane[m].push_back(of.ranked[of.own[block * LANES + m + columns]]);
    }
  }
  void sort_by_rank(int block)
  {
    for (int m = 0; m < LANES; m++) {
      lane[m].clear();
      if (m >= of.particles_of(block)) continue;
      each_candidate(of.own[block * LANES + m], [&](int row) {
        if (of.ranked[row] >= 0) lane[m].push_back(of.ranked[row]);
      });
      std::sort(lane[m].begin(), lane[m].end());
    }
  }

  // lanes together whose next candidates are as far apart, or are rare
  void merge(int first)
  {
    rare = 0;
    for (int m = 0; m < LANES; m++) {
      next[m] = -1;
      advance(first, m);
    }
    for (;;) {
      const int lead = static_cast<int>(std::min_element(rank, rank + LANES) - rank);
      if (rank[lead] == NONE) break;
      const bool side_by_side = !(rare >> lead & 1);
      unsigned taken = rare;
      if (side_by_side) {
        taken = 0;
        for (int m = 0; m < LANES; m++) taken |= (apart[m] == apart[lead] ? 1u : 0u) << m;
      }
      add_slot(first, side_by_side, apart[lead], taken);
      for (int m = 0; m < LANES; m++)
        if (taken >> m & 1) advance(first, m);
    }
  }
  void advance(int first, int m)
  {
    rank[m] = apart[m] = NONE;
    rare &= ~(1u << m);
    if (++next[m] >= static_cast<int>(lane[m].size())) return;
    const std::int64_t j = lane[m][next[m]];
    rank[m] = static_cast<int>(j >> 32) - static_cast<int>(of.ranked[of.own[first + m]] >> 32);
    apart[m] = column(j) - (first + m);
    if (is_rare(apart[m])) rare |= 1u << m;
  }
  void add_slot(int first, bool side_by_side, int further, unsigned taken)
  {
    bool mirrored = false;
    for (int m = 0; m < LANES && of.images.any(); m++) {
      const int columns = side_by_side ? further : apart[m];
      mirrored = mirrored || ((taken >> m & 1) && first + m + columns >= first_image);
    }
    found.lanes.push_back(static_cast<Bits>(taken));
    found.mirrored.push_back(mirrored);
    if (side_by_side) {
      found.further.push_back(of.columns.from(first, first + further));
      return;
    }
    found.further.push_back(GATHERED + static_cast<int>(found.gathered.size() / LANES));
    for (int m = 0; m < LANES; m++)
      found.gathered.push_back(taken >> m & 1 ? first + m + apart[m] : first + m);
  }
};

template <int D, class Precision>
void EulerianSweeps<D, Precision>::Candidates::append(const Candidates &other)
{
  count += other.count;
  const int slots = first.back(), vectors = static_cast<int>(gathered.size() / LANES);
  for (std::size_t block = 1; block < other.first.size(); block++)
    first.push_back(slots + other.first[block]);
  for (const int n : other.further) further.push_back(n < GATHERED ? n : n + vectors);
  lanes.insert(lanes.end(), other.lanes.begin(), other.lanes.end());
  mirrored.insert(mirrored.end(), other.mirrored.begin(), other.mirrored.end());
  gathered.insert(gathered.end(), other.gathered.begin(), other.gathered.end());
}

template <int D, class Precision>
void EulerianSweeps<D, Precision>::arrange_candidates(const Particles &p, const NeighborRows &list)
{
  place_columns(p, list);
  this->size_columns(components(), false);
  std::vector<Candidates> shares(nthreads);
  const int number = number_shares(nthreads, blocks(), [&](int share, int first, int end) {
    Arranging arranging(*this, list);
    arranging.make_room(first, end);
    for (int block = first; block < end; block++) arranging.arrange(block);
    shares[share] = std::move(arranging.found);
  });
  candidates = std::move(shares[0]);
  for (int share = 1; share < number; share++) candidates.append(shares[share]);
}

// of slots, over that of as many as candidates would fill

template <int D, class Precision> double EulerianSweeps<D, Precision>::work() const
{
  const double slots = static_cast<double>(candidates.lanes.size() * LANES) +
      static_cast<double>(candidates.gathered.size()) * (PRICE<LANES> - 1);
  return candidates.count ? slots / static_cast<double>(candidates.count) : 1.0;
}

template <int D, class Precision> void EulerianSweeps<D, Precision>::make_room_for_pairs()
{
  const std::size_t n = candidates.further.size(), all = n * LANES;
  for (std::vector<int> *of : {&pairs.first, &pairs.count, &pairs.near_first, &pairs.near_count})
    of->assign(blocks(), 0);
  make_room(pairs.further, n);
  make_room(pairs.lanes, n);
  make_room(pairs.factor, all);
  if (needs_correction()) {
    make_room(pairs.near, n);
    make_room(pairs.near_kernel, all);
  }
  if (safe()) make_room(pairs.near_pull, all);
  if (opt.tensile) make_room(pairs.crowd, all);
  if (this->limits_step) mu_max.assign(end_of_own, 0.0);
}

template <int D, class Precision> int EulerianSweeps<D, Precision>::neighbor_count(int i) const
{
  const int column = column_of[i], block = column / LANES;
  int n = 0;
  for (int k = 0; column >= 0 && k < pairs.count[block]; k++)
    n += pairs.lanes[pairs.first[block] + k] >> column % LANES & 1;
  return n;
}

template <int D, class Precision> double EulerianSweeps<D, Precision>::memory_usage() const
{
  std::size_t all = 0, near = 0;    // what is in use of the room for candidates
  for (const int n : pairs.count) all += n;
  for (const int n : pairs.near_count) near += n;
  auto used = [](const auto &of, std::size_t n) {
    return of.empty() ? 0 : n * LANES * sizeof(of[0]);
  };
  const std::size_t ints = candidates.first.capacity() + candidates.gathered.capacity() +
      4 * pairs.first.capacity() + 2 * ranked.capacity() + image_first.capacity() +
      image_j.capacity() + candidates.further.capacity() + near + all * (LANES + 1);
  return Base::memory_of_columns() +
      static_cast<double>(ints * sizeof(int) + (candidates.lanes.capacity() + all) * sizeof(Bits) +
                          candidates.mirrored.capacity() + used(pairs.near_kernel, near) +
                          used(pairs.near_pull, near) + used(pairs.pull, all) +
                          used(pairs.crowd, all) + mu_max.capacity() * sizeof(Number));
}

}    // namespace

#endif
