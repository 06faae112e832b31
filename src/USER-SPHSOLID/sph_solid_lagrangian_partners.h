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
   The Lagrangian frame between two neighbor lists: columns, reference positions,
   pairs and what is constant of them.  Members of LagrangianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_PARTNERS_H
#define LMP_SPH_SOLID_LAGRANGIAN_PARTNERS_H

#include "sph_solid_lagrangian.h"

#include <numeric>

namespace {

// B = 1 for who has all partners in one row or layer, beyond_share().  Particles with B = 1 are tied
// to the axes of the laboratory.  Caps of balls reach 0.17, a row 0
constexpr double LEAST_ROUNDNESS = 0.02;

template <int D> bool can_be_corrected(const Tensor<D> &moment)
{
  return beyond_share<D>(moment, LEAST_ROUNDNESS) > 0.0;    // without partners it is 0
}

// who lies closer to its own image in the reference than this, in smoothing lengths, and so nearly on the
// plane, is no partner of it: both are the two halves of one particle, and may come to lie on the plane
constexpr double BESIDE_IMAGE = 0.05;

// slots that have room for this many times the pairs of a body are reason to look for a better
// order of its particles
constexpr double WORTH_ANOTHER_ORDER = 1.25;

// neighbors in position are neighbors in memory, too, for which some more slots are a fair price
constexpr double MUCH_WORSE = 1.1;

// a gathered slot is so many times the work of another, without rows of what columns have and with them
template <int LANES> constexpr int PRICE[2] = {LANES > 8 ? 8 : 4, 2};

/* ----------------------------------------------------------------------
   columns: own particles, ghosts, images.  In the order of IDs a lattice is row by row, turned
   or not, as create_atoms has made it, however LAMMPS sorts its particles or moves them
   between ranks.  Where IDs say nothing, rows of the reference along its longest side often do
------------------------------------------------------------------------- */

inline std::int64_t id_of(const Particles &p, int i)
{
  return p.id ? p.id[i] : i;
}

template <int D, class Precision>
int LagrangianSweeps<D, Precision>::longest_side(const NeighborRows &list,
                                                 const std::vector<double> &reference)
{
  int longest = 0;
  double length = -1.0;
  for (int a = 0; a < D; a++) {
    double low = NO_LIMIT, high = -NO_LIMIT;
    for (int ii = 0; ii < list.inum; ii++) {
      const double X = reference[list.ilist[ii] * D + a];
      low = std::min(low, X);
      high = std::max(high, X);
    }
    if (!(high - low > length)) continue;
    longest = a;
    length = high - low;
  }
  return longest;
}

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::place_columns(const Particles &p, const NeighborRows &list,
                                                   const std::vector<double> &reference, int side)
{
  struct Place {
    std::int64_t key[D];    // from the slowest on
    double along;
    int i;
    bool operator<(const Place &b) const
    {
      for (int a = 0; a < D; a++)
        if (key[a] != b.key[a]) return key[a] < b.key[a];
      return along < b.along;
    }
  };
  const bool by_position = side != BY_ID;
  auto sort = [&](std::vector<int> &particles) {
    std::vector<Place> places;
    for (const int i : particles) {
      Place place = {{}, by_position ? reference[i * D + side] : 0.0, i};
      if (!by_position) place.key[0] = id_of(p, i);
      for (int a = 1; a < D && by_position; a++)    // rows lie further apart than half a spacing
        place.key[D - 1 - a] = std::llround(reference[i * D + (side + a) % D] /
                                            (0.5 * types[p.type[source_of(i)]].spacing));
      places.push_back(place);
    }
    std::stable_sort(places.begin(), places.end());
    for (std::size_t k = 0; k < places.size(); k++) particles[k] = places[k].i;
  };

  std::vector<int> owned(list.ilist, list.ilist + list.inum), ghosts, mirrored(images.count());
  for (int i = p.nlocal; i < p.nall; i++)
    if (Base::has_material(p, i)) ghosts.push_back(i);
  std::iota(mirrored.begin(), mirrored.end(), p.nall);
  sort(owned);
  sort(ghosts);
  if (by_position) sort(mirrored);
  Base::number_columns(owned, ghosts, mirrored, p.nall + images.count());
}

/* ----------------------------------------------------------------------
   reference positions of rows, D doubles each.  Bodies cross a periodic box, and
   their reference does not: move reference positions by whole boxes until partners are
   neighbors there, too.  The nearest image in the reference is the right one: a
   body is longer than two ranges of the kernel, or two of its partners would be one
------------------------------------------------------------------------- */

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::unwrap_references(const Particles &p, const NeighborRows &list,
                                                       std::vector<double> &reference) const
{
  std::vector<char> placed(p.nall, 0);
  std::vector<int> open;
  auto place = [&](int j) {
    placed[j] = 1;
    if (j < p.nlocal) open.push_back(j);
  };
  for (int ii = 0; ii < list.inum; ii++) {
    if (!placed[list.ilist[ii]]) place(list.ilist[ii]);
    while (!open.empty()) {
      const int i = open.back();
      open.pop_back();
      for (int jj = 0; jj < list.numneigh[i]; jj++) {
        const int j = list.firstneigh[i][jj] & INDEX_MASK;
        if (placed[j]) continue;
        for (int a = 0; a < D; a++) {
          const double apart = reference[i * D + a] - reference[j * D + a];
          if (p.period[a] > 0.0)
            reference[j * D + a] += p.period[a] * std::round(apart / p.period[a]);
        }
        place(j);
      }
    }
  }
}

template <int D, class Precision>
std::vector<double> LagrangianSweeps<D, Precision>::place_references(const Particles &p,
                                                                     const NeighborRows &list) const
{
  std::vector<double> reference((p.nall + images.count()) * std::size_t(D));
  for (int i = 0; i < p.nall; i++)
    for (int a = 0; a < D; a++) reference[i * D + a] = p.xref[i][a];
  if (p.period[0] > 0.0 || p.period[1] > 0.0 || p.period[2] > 0.0)
    unwrap_references(p, list, reference);
  for (int k = 0; k < images.count(); k++)
    images.template position<D>(k, &reference[images.source_of(k) * D],
                                &reference[(p.nall + k) * D]);
  return reference;
}

/* ----------------------------------------------------------------------
   the partners of a block's particles, arranged in slots
------------------------------------------------------------------------- */

template <int D, class Precision> struct LagrangianSweeps<D, Precision>::Arranging {
  LagrangianSweeps &of;
  const Particles &p;
  const NeighborRows &list;
  const std::vector<double> &reference;
  Arranging(LagrangianSweeps &s, const Particles &particles, const NeighborRows &rows,
            const std::vector<double> &X) :
      of(s),
      p(particles), list(rows), reference(X)
  {
  }

  std::vector<Partner> partners[LANES];
  SingleRows constants;        // of the pairs of a block's slots
  Numbers near;                // m_j Wbar of the nearest
  std::vector<int> offsets;    // of a block's slots, 0: gathered
  Tensor<D> moment[LANES];     // M
  Vector<D> sum[LANES];    // of V0_j g_ij: inside of a lattice nothing is left of it but rounding
  double nsum[LANES];      // n of the correction: sum m_j Wbar

  static constexpr std::int64_t PLACES = 1 << 10;    // more than a kernel has spacings

  // X_i - X_j of two rows
  Vector<D> separation(int i, int j) const
  {
    Vector<D> d;
    for (int a = 0; a < D; a++) d[a] = reference[i * D + a] - reference[j * D + a];
    return d;
  }
  const TypeData &type(int row) const { return of.types[p.type[of.source_of(row)]]; }
  double mean_h(int i, int j) const { return 0.5 * (type(i).h + type(j).h); }
  double near_support(int i) const { return of.opt.hbar * type(i).spacing; }

  // append the nearest partners among n rows to those of i, or the others
  void add(std::vector<Partner> &to, int i, int n, const int *rows, bool nearest) const
  {
    for (int k = 0; k < n; k++) {
      const int j = rows[k] & INDEX_MASK;
      const double r = separation(i, j).norm(), h = mean_h(i, j);
      const bool near = r < 0.5 * (near_support(i) + near_support(j));
      if (near != nearest || (!nearest && r >= PARTNER_SUPPORT * h)) continue;
      if (j >= p.nall && of.source_of(j) == i && r < BESIDE_IMAGE * h) continue;
      to.push_back({j, of.column_of[j], nearest && of.needs_correction(), direction(i, j),
                    id_of(p, of.source_of(j)) - id_of(p, i), r});
    }
  }

  // of particles on a lattice the same number for partners that lie alike: how many spacings j is
  // from i in the reference; images last.  Not halves, which rounding would tell apart
  std::int64_t direction(int i, int j) const
  {
    std::int64_t number = j < p.nall ? 0 : 1;
    const Vector<D> X = separation(j, i);
    for (int a = D - 1; a >= 0; a--)
      number = number * PLACES + std::llround(X[a] / type(i).spacing + 0.01) + PLACES / 2;
    return number;
  }

  void collect(int block)
  {
    for (int m = 0; m < LANES; m++) {
      partners[m].clear();
      if (m >= of.particles_of(block)) continue;
      const int i = of.own[block * LANES + m];
      const int nimage = of.images.any() ? of.image_first[i + 1] - of.image_first[i] : 0;
      const int *image = nimage ? &of.image_j[of.image_first[i]] : nullptr;
      for (const bool nearest : {true, false}) {
        add(partners[m], i, list.numneigh[i], list.firstneigh[i], nearest);
        add(partners[m], i, nimage, image, nearest);
      }
      std::sort(partners[m].begin(), partners[m].end(), comes_before);
    }
  }

  bool has_nearest(const int *which) const
  {
    for (int m = 0; m < LANES; m++)
      if (which[m] >= 0 && partners[m][which[m]].nearest) return true;
    return false;
  }

  // slots that a block has, those with nearest partners, those to be gathered
  void count(int block, int &nslots, int &nearest, int &gathered)
  {
    nslots = nearest = gathered = 0;
    collect(block);
    for (int m = 0; m < LANES; m++)
      if (m < of.particles_of(block))
        of.slots.count[block * LANES + m] = static_cast<int>(partners[m].size());
    arrange(partners, block * LANES, PRICE<LANES>[of.with_rows],
            [&](bool side_by_side, int, const int *which) {
              nslots++;
              if (!side_by_side) gathered++;
              if (has_nearest(which)) nearest = nslots;
            });
  }

  void fill(int block, int gathered)
  {
    Slots &slots = of.slots;
    const int first = slots.first[block];
    int s = first;
    offsets.clear();
    constants.assign((slots.first[block + 1] - first) * Slots::CONSTANTS, 0.0f);
    near.assign(slots.nearest(block) * LANES, 0.0);
    for (int m = 0; m < LANES; m++) {
      moment[m].setZero();
      sum[m].setZero();
      nsum[m] = 0.0;
    }
    collect(block);
    arrange(partners, block * LANES, PRICE<LANES>[of.with_rows],
            [&](bool side_by_side, int offset, const int *which) {
              slots.further[s] = side_by_side
                  ? of.columns.from(block * LANES, block * LANES + offset)
                  : GATHERED + gathered;
              offsets.push_back(side_by_side ? offset : 0);
              for (int m = 0; m < LANES; m++) {
                const Partner *partner = which[m] >= 0 ? &partners[m][which[m]] : nullptr;
                if (!side_by_side)
                  slots.gathered[gathered * std::size_t(LANES) + m] = partner ? partner->column
                                                                              : block * LANES + m;
                if (partner) fill_pair(block, m, s - first, *partner);
              }
              if (!side_by_side) gathered++;
              s++;
            });
    const int left = correct(block);
    enter(block, left);
    find_foremost(block);
  }

  void enter(int block, int left_uncorrected)
  {
    const std::lock_guard<std::mutex> alone(of.mutex);
    of.nuncorrected += left_uncorrected;
    of.slots.constants.enter(of.slots.first[block], constants);
    of.near_weight.enter(of.slots.near_first[block], near);
  }

  // which of the slots that read nearly the same columns reads the last of them, where these lie
  // further on: what lies before has been read in this sweep
  void find_foremost(int block)
  {
    Slots &slots = of.slots;
    unsigned char *foremost = slots.foremost.data() + slots.first[block];
    for (std::size_t k = 0; k < offsets.size(); k++) {
      const int column = block * LANES + offsets[k];
      foremost[k] =
          of.asks_ahead && offsets[k] > LANES ? std::min(of.columns.left_of_chunk(column), 255) : 0;
      for (const int other : offsets)
        if (other > offsets[k] && other <= offsets[k] + LANES) foremost[k] = 0;
    }
  }

  // what is constant of a pair
  void fill_pair(int block, int m, int slot, const Partner &partner)
  {
    const int i = of.own[block * LANES + m], source = of.source_of(partner.row);
    const double h = mean_h(i, source), q = partner.r / h;
    float *of_slot = &constants[slot * Slots::CONSTANTS + m], &factor = of_slot[Slots::FACTOR];
    factor = CubicSpline<D>::gradient_factor(partner.r, h) / of.unit_factor;
    of_slot[Slots::NEARNESS] = q / (q * q + MU_EPSILON);
    // rounded as sweeps will find it
    const Number F = static_cast<Number>(factor * of.columns.get(partner.column, WEIGHT));
    Vector<D> X;
    for (int a = 0; a < D; a++) X[a] = of.apart(block * LANES + m, partner.column, REFERENCE + a);
    const Vector<D> of_pair = static_cast<double>(F) * X;
    moment[m] -= of_pair * X.transpose();
    sum[m] += of_pair;
    if (!partner.nearest) return;
    const double weight = p.mass[source] *
        rounded(Base::wbar_mass(partner.r, 1.0, near_support(i), near_support(source)));
    near[slot * LANES + m] = weight;
    nsum[m] += weight;
  }

  // B_i and, for the acceleration correction, n_i; behind the last particle the last one again.
  // How many have partners and no B
  int correct(int block)
  {
    int left = 0;
    for (int m = 0; m < LANES; m++) {
      const int n = std::min(m, of.particles_of(block) - 1);
      const bool enough = can_be_corrected<D>(moment[n]);
      if (m == n && !enough && of.slots.count[block * LANES + m] > 0) left++;
      const Tensor<D> inverse = enough ? Tensor<D>(moment[n].inverse()) : Tensor<D>::Identity();
      Number *at = of.correction_of(block) + m;
      for (int a = 0; a < D; a++)
        for (int b = a; b < D; b++, at += LANES) *at = static_cast<Number>(inverse(a, b));
      for (int a = 0; a < D; a++)
        of.gradient_sum[vector_at(block) + a * LANES + m] = static_cast<Number>(sum[m][a]);
      const int i = of.own[block * LANES + n];
      of.columns.set(block * LANES + m, DENSITY, p.mass[i] / p.vref[i] * inverse.trace() / D);
      if (of.needs_correction()) of.columns.set(block * LANES + m, LAST, rounded(nsum[n]));
    }
    return left;
  }
};

/* ----------------------------------------------------------------------
   partners have new local indices: everything that is constant between two
   such moments
------------------------------------------------------------------------- */

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::new_neighbors(const Particles &p, const NeighborRows &list,
                                                   double reach)
{
  Base::find_image_candidates(p, list, p.xref, reach);
  nparticles = p.nall;
  const std::vector<double> reference = place_references(p, list);
  const std::vector<int> gathered = choose_order(p, list, reference);
  size_storage(gathered.back());
  for (std::size_t row = 0; row < column_of.size(); row++) {
    if (column_of[row] < 0) continue;
    Base::set_places(column_of[row], REFERENCE, &reference[row * D]);
    const int i = source_of(static_cast<int>(row));
    columns.set(column_of[row], WEIGHT, p.vref[i] * unit_factor);
    if (this->unlike) columns.set(column_of[row], at_rho, p.mass[i] / p.vref[i]);
  }
  // behind the last particle the last one again
  for (int column = static_cast<int>(own.size()); column < end_of_own; column++) {
    columns.set(column, WEIGHT, columns.get(column - 1, WEIGHT));
    if (this->unlike) columns.set(column, at_rho, columns.get(column - 1, at_rho));
  }
  nuncorrected = 0;
  each_arranging(Arranging(*this, p, list, reference), [&](Arranging &arranging, int block) {
    arranging.fill(block, gathered[block]);
  });
  slots.constants.end();
  near_weight.end();
}

// an order of columns that leaves few places in slots empty, and whether rows are worth having,
// too; returns how many gathered slots there are before each block, and in all

template <int D, class Precision>
std::vector<int> LagrangianSweeps<D, Precision>::choose_order(const Particles &p,
                                                              const NeighborRows &list,
                                                              const std::vector<double> &reference)
{
  auto room = [&]() {    // for how many times the pairs there are
    const auto pairs = std::accumulate(slots.count.begin(), slots.count.end(), std::int64_t(0));
    return pairs ? slots.first.back() * double(LANES) / pairs : 1.0;
  };
  int chosen = BY_ID, tried = BY_ID;
  with_rows = false;
  std::vector<int> gathered = count_slots(p, list, reference, tried);
  auto mostly_gathered = [&]() {
    return gathered.back() > WORTH_ROWS * slots.first.back();
  };
  double least = room();
  bool wants_rows = mostly_gathered();
  auto try_rows = [&](int side, double worth) {
    if (least <= WORTH_ANOTHER_ORDER || side == tried) return;
    gathered = count_slots(p, list, reference, tried = side);
    if (room() > worth * least) return;
    chosen = tried;
    least = room();
    wants_rows = mostly_gathered();
  };
  try_rows(0, MUCH_WORSE);
  try_rows(longest_side(list, reference), 1.0 / MUCH_WORSE);
  with_rows = wants_rows;
  if (with_rows || chosen != tried) gathered = count_slots(p, list, reference, chosen);
  return gathered;
}

// place columns and find out how many slots blocks have

template <int D, class Precision>
std::vector<int>
LagrangianSweeps<D, Precision>::count_slots(const Particles &p, const NeighborRows &list,
                                            const std::vector<double> &reference, int side)
{
  place_columns(p, list, reference, side);
  slots.first.assign(blocks() + 1, 0);
  slots.near_first.assign(blocks() + 1, 0);
  slots.count.assign(end_of_own, 0);
  std::vector<int> gathered(blocks() + 1, 0);
  each_arranging(Arranging(*this, p, list, reference), [&](Arranging &arranging, int block) {
    arranging.count(block, slots.first[block + 1], slots.near_first[block + 1],
                    gathered[block + 1]);
  });
  for (std::vector<int> *n : {&slots.first, &slots.near_first, &gathered})
    std::partial_sum(n->begin(), n->end(), n->begin());
  return gathered;
}

// call(Arranging, block), one of them per thread

template <int D, class Precision>
template <class Call>
void LagrangianSweeps<D, Precision>::each_arranging(const Arranging &first, Call call)
{
  each_share(nthreads, blocks(), [&](int begin, int end) {
    Arranging arranging = first;
    for (int block = begin; block < end; block++) call(arranging, block);
  });
}

template <int D, class Precision> void LagrangianSweeps<D, Precision>::size_storage(int gathered)
{
  const std::size_t near = static_cast<std::size_t>(slots.near_first.back()) * LANES;
  Base::size_columns(components(), with_rows);
  slots.further.resize(slots.first.back());
  slots.foremost.resize(slots.first.back());
  slots.gathered.resize(static_cast<std::size_t>(gathered) * LANES);
  slots.constants.begin(slots.first.back());
  near_weight.begin(slots.near_first.back());
  if (safe()) {
    near_pull.assign(near, 0.0);
    near_in_order.resize(slots.near_first.back());
    std::iota(near_in_order.begin(), near_in_order.end(), 0);
  }
  B.resize(static_cast<std::size_t>(end_of_own) * SYMMETRIC);
  gradient_sum.assign(static_cast<std::size_t>(end_of_own) * D, 0.0);
  if (this->limits_step) mu_max.assign(end_of_own, 0.0);
  size_accounts();
  weights_known = velocities_known = false;
}

template <int D, class Precision> void LagrangianSweeps<D, Precision>::size_accounts()
{
  const bool viscous = opt.viscosity != Viscosity::NONE;
  accounts.hourglass = needs_correction() || (viscous && opt.energy) ? D : 0;
  accounts.stress = accounts.hourglass + (opt.energy && opt.hourglass > 0.0 ? D : 0);
  accounts.pairs = accounts.stress + (this->keeps_heat ? 1 : 0);
  accounts.size = accounts.pairs + (opt.energy && dissipates() ? 1 : 0);
  accounts.numbers.assign(end_of_own * std::size_t(accounts.size), 0.0);
}

template <int D, class Precision> int LagrangianSweeps<D, Precision>::neighbor_count(int i) const
{
  return column_of[i] < 0 ? 0 : slots.count[column_of[i]];
}

template <int D, class Precision> double LagrangianSweeps<D, Precision>::memory_usage() const
{
  double bytes = Base::memory_of_columns() + slots.memory_usage() + near_weight.memory_usage();
  for (const Numbers *rows : {&B, &gradient_sum, &accounts.numbers, &heated_force, &power_then,
                              &central_virial, &near_pull, &mu_max})
    bytes += static_cast<double>(rows->capacity() * sizeof(Number));
  return bytes;
}

}    // namespace

#endif
