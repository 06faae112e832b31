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
   What a sweep sees of columns: where the neighbors of a slot are, and of a particle what its
   pairs are made of.  Members of ColumnSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_COLUMN_VIEWS_H
#define LMP_SPH_SOLID_COLUMN_VIEWS_H

#include "sph_solid_column_sweeps.h"

namespace {

// a sweep's view of the columns that slots of a block read, which lie so far `further` (sph_solid_slots.h).
// Of gathered ones there are components [first, end) and [second, second_end), MOST of them.  Where
// they are is not read again after stores, which a compiler would do for members of the sweeps

template <int D, class Precision>
template <int MOST>
class ColumnSweeps<D, Precision>::SlotColumns {
 public:
  SlotColumns(const ColumnSweeps &s, const std::vector<int> &columns_of_gathered, int block,
              int from, int to, int from2, int to2) :
      of(s),
      gathered_columns(columns_of_gathered.data()), i(s.columns.at(block * LANES)), first(from),
      end(to), second(from2), second_end(to2)
  {
  }
  [[gnu::always_inline]] const Number *operator()(int further)
  {
    return further < GATHERED ? i + further : gathered(of_gathered(further));
  }
  // of a lane's neighbor
  int column(int further, int lane) const
  {
    if (further >= GATHERED) return of_gathered(further)[lane];
    return of.columns.column(i + further) + lane;
  }
  // ask for what the blocks to come read first, if this is a block's last slot: it lies behind
  void ask_behind(int further) const
  {
    if (!of.asks_ahead || further >= GATHERED) return;
    const Number *at = i + further;
    const bool leaves = Columns::left_of_chunk(of.columns.column(at)) <= AHEAD;
    at += AHEAD + (leaves ? of.columns.skipped() : 0);
    prefetch_components(at, first, end);
    prefetch_components(at, second, second_end);
  }

 private:
  const ColumnSweeps &of;
  const int *const gathered_columns;
  const Number *const i;
  const int first, end, second, second_end;
  // of gathered neighbors, as far apart as in columns.  No more than there can be: a stack is
  // touched page by page before it is used
  alignas(64) Number scratch[(MOST + BLOCK) * NEXT];

  const int *of_gathered(int further) const
  {
    return gathered_columns + std::size_t(further - GATHERED) * LANES;
  }
  // not inlined: a loop over other slots has registers for what it needs then
  [[gnu::noinline]] const Number *gathered(const int *from)
  {
    of.gather(from, first, end, scratch);
    of.gather(from, second, second_end, scratch);
    return scratch;
  }
};

// positions of particles, from which those of neighbors are so far apart.  Of a particle itself: in a
// sweep's loop the compiler would read it again for every neighbor

template <int D, class Precision> struct ColumnSweeps<D, Precision>::Places {
  Place x[D];
  const Ruler ruler;
  [[gnu::always_inline]] Places(const ColumnSweeps &s, const Number *i, int c) : ruler(s.ruler)
  {
    each_index<D>([&](auto a) {
      x[a] = Ruler::place(i + (c + a) * NEXT);
    });
  }
  [[gnu::always_inline]] void apart(const Number *j, int c, Pack *out) const
  {
    each_index<D>([&](auto a) {
      out[a] = ruler.apart(x[a], Ruler::place(j + (c + a) * NEXT));
    });
  }
};

// the same with velocities

template <int D, class Precision> struct ColumnSweeps<D, Precision>::Motion : Places {
  Pack v[D];
  [[gnu::always_inline]] Motion(const ColumnSweeps &s, const Number *i) : Places(s, i, X)
  {
    each_index<D>([&](auto a) {
      v[a] = component(i, V + a);
    });
  }
  [[gnu::always_inline]] Parts from(const Number *j) const
  {
    Parts d;
    this->apart(j, X, d.x);
    each_index<D>([&](auto a) {
      d.v[a] = v[a] - component(j, V + a);
    });
    return d;
  }
};

// viscosity.  For the switch of "front": the velocity gradient of a particle predicts the jump
// x_ij.D x_ij of a pair.  Weights -F_ij V_j/x_ij^2 with g_ij = F_ij x_ij, given without 1/x_ij^2

template <int D, class Precision> struct ColumnSweeps<D, Precision>::Jumps {
  const Number *const i;
  const Motion own;
  const Pack least;    // particles may meet
  Pack rest2 = 0.0, linear2 = 0.0;
  Jumps(const ColumnSweeps &s, const Number *at, Pack h) :
      i(at), own(s, at), least(MU_EPSILON * h * h)
  {
  }
  void add(const Number *j, int at_rate, Pack weight)
  {
    const Parts d = own.from(j);
    const Pack li = stretching(i, at_rate, d.x), lj = stretching(j, at_rate, d.x);
    const Pack rest = d.v_dot_x() - 0.5 * (li + lj);
    const Pack w = weight / (d.x_dot_x() + least);
    rest2 += w * rest * rest;
    linear2 += 0.5 * w * (li * li + lj * lj);
  }
  Pack unresolved() const { return unresolved_share(rest2, linear2); }
};

// what becomes heat of the correction's forces on nearest particles while they move by u, which is in V:
// compatible: -1/4 sum w_ij (u_i - u_j).(da_i - da_j) for symmetric weights;
// shepard weights leak momentum, there the loss of kinetic energy of the
// particle itself becomes heat (exact in total, not Galilean invariant);
// printed: the correction term of eq. 30, 1/2 sum w_ij (u_i - u_j).da_j;
// safe: half the work of each central pair force, none of it negative for u = v.
// Of a pair -4/m_i of it, without w_ij.  EVENLY: for heats_evenly()

template <int D, class Precision>
template <bool EVENLY>
struct ColumnSweeps<D, Precision>::CorrectionHeat {
  const bool safe;
  const int at;
  const Places place;
  Pack own_moved[D], own_force[D], minus_moved, minus_force;
  CorrectionHeat(const ColumnSweeps &s, const Number *i, int at_da) :
      safe(!EVENLY && s.safe()), at(at_da), place(s, i, X)
  {
    const bool printed = s.opt.heating == Heating::PRINTED && !safe,
               alone = s.opt.weights == Weights::SHEPARD && !printed;    // its own loss
    for (int a = 0; a < D; a++) {
      own_moved[a] = (alone ? 2.0 : 1.0) * component(i, V + a);
      own_force[a] = (printed ? 0.0 : 1.0) * component(i, at + a);
    }
    minus_moved = alone ? 0.0 : -1.0;
    minus_force = printed ? -2.0 : -1.0;
  }
  Pack of(const Number *j) const
  {
    Pack sum = 0.0;
    if (safe) {
      Pack force[D];
      place.apart(j, X, force);
      for (int a = 0; a < D; a++)
        sum = multiply_add(own_moved[a] - component(j, V + a), force[a], sum);
      return sum;
    }
    each_index<D>([&](auto a) {
      const Pack moved = component(j, V + a), force = component(j, at + a);
      if (EVENLY)
        sum = multiply_add(own_moved[a] - moved, own_force[a] - force, sum);
      else
        sum = multiply_add(multiply_add(minus_moved, moved, own_moved[a]),
                           multiply_add(minus_force, force, own_force[a]), sum);
    });
    return sum;
  }
};

// what the correction's force of a pair is along: with weights safe the distance, else the difference of
// viscous accelerations.  MAY_BE_SAFE: false where they are known to be others

template <int D, class Precision>
template <bool MAY_BE_SAFE>
class ColumnSweeps<D, Precision>::Along {
 public:
  Along(const ColumnSweeps &s, const Number *i, int at_da) :
      safe(MAY_BE_SAFE && s.safe()), at(at_da * std::ptrdiff_t(NEXT)), place(s, i, X)
  {
    each_index<D>([&](auto a) {
      own[a] = component(i + at, a);
    });
  }
  [[gnu::always_inline]] void from(const Number *j, Pack *out) const
  {
    if (safe)
      place.apart(j, X, out);
    else
      each_index<D>([&](auto a) {
        out[a] = own[a] - component(j + at, a);
      });
  }

 private:
  const bool safe;
  const std::ptrdiff_t at;
  const Places place;
  Pack own[D];
};

}    // namespace

#endif
