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
   Particles side by side, as the sweeps of both frames have them: own ones in blocks of as many
   as there are lanes, all that is read of them in columns (sph_solid_columns.h), own, ghosts
   and mirror images.  A frame says which components a column has, and which particles are pairs.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_COLUMN_SWEEPS_H
#define LMP_SPH_SOLID_COLUMN_SWEEPS_H

#include "sph_solid_columns.h"
#include "sph_solid_points.h"
#include "sph_solid_slots.h"
#include "sph_solid_space.h"

#include <utility>

using namespace SPHSolid;

// of one source file each time, as the compiler should know

namespace {

template <int D, class Precision> class ColumnSweeps : public PointSweeps<D> {
 public:
  ColumnSweeps(const Options &o, const std::vector<TypeData> &t) :
      PointSweeps<D>(o, t), ruler(Base::least_h(t))
  {
  }

  int message_size(Message) const override;
  void pack(Message, int, double *) const override;
  void unpack(Message, const Particles &, int, const double *) override;
  void displace(const double *const *u) override;
  void displace(const Particles &, const Kick &) override;
  void velocity(int i, double *v) const override;
  void mirror_switch() override;
  void virial(const Particles &, const NeighborRows &, double *) override;

 protected:
  using Base = PointSweeps<D>;
  using Base::images, Base::lonely, Base::needs_correction, Base::nparticles, Base::nthreads,
      Base::opt;
  using Totals = typename Base::Totals;

  // of pairs, in their precision
  using Number = typename Precision::Number;
  using Numbers = AlignedRows<Number>;
  using Pack = typename Precision::Pack;
  using Single = typename Precision::Single;
  using Place = typename Precision::Place;
  using Ruler = typename Precision::Ruler;
  using Batch = typename Base::template BatchOf<Pack>;
  using Tensors = Tensor<D, Pack>;
  using Parts = Components<D, Pack>;
  static constexpr int LANES = lanes_of<Pack>;
  static Pack load(const Number *from) { return Precision::load(from); }

  // the first components of a column: positions, velocities (for heat: displacements)
  static constexpr int X = 0, V = D, SYMMETRIC = D * (D + 1) / 2;
  using Columns = ColumnsOf<Precision>;
  static constexpr int NEXT = Columns::NEXT;

  Columns columns;
  const Ruler ruler;
  // what lies in the second-level cache need not be asked for ahead: 4 % of a step of a Taylor rod
  static constexpr double IN_CACHE = 512.0 * 1024.0;    // [bytes]
  bool asks_ahead = false;
  // columns from what is read to what is asked for, two cache lines
  static constexpr int AHEAD = 128 / sizeof(Number);
  bool with_rows = false;        // for bodies that are no lattice
  std::vector<int> own;          // own particles in the order of columns
  std::vector<int> column_of;    // of every own particle, ghost and image, -1: none
  int end_of_own = 0, end_of_columns = 0;
  std::vector<int> first_of_run;    // of each block whose particles lie one after the other, or -1

  // components that messages fill: what ghosts are sent of the constitutive update lies from stress
  // to da, n of the correction or the switch of a viscosity at last, the viscous acceleration at da
  struct Sent {
    int stress, last, da;
  };
  virtual Sent sent() const = 0;
  struct Part {
    int first, size;
  };
  Part sent_with(Message) const;

  // blocks
  int blocks() const { return end_of_own / LANES; }
  NeighborRows own_list() const
  {
    return {static_cast<int>(own.size()), const_cast<int *>(own.data()), nullptr, nullptr};
  }
  int particles_of(int block) const
  {
    return std::min(LANES, static_cast<int>(own.size()) - block * LANES);
  }
  // the particles of a block
  Batch batch(int block) const
  {
    return first_of_run[block] >= 0 ? Batch(first_of_run[block]) : Batch(own_list(), block * LANES);
  }
  template <class Call> Totals each_block(Call call);

  // columns of own particles, of ghosts and of images, in these orders, among so many rows
  void number_columns(const std::vector<int> &owned, const std::vector<int> &ghosts,
                      const std::vector<int> &mirrored, std::size_t rows)
  {
    own = owned;
    column_of.assign(rows, -1);
    int column = 0;
    for (const int i : own) column_of[i] = column++;
    end_of_own = column = Columns::whole_blocks(column);
    first_of_run.assign(blocks(), -1);
    for (int block = 0; block < blocks(); block++)
      if (const Batch of_block = batch(block); of_block.n == LANES && of_block.consecutive)
        first_of_run[block] = of_block.i[0];
    for (const std::vector<int> *of : {&ghosts, &mirrored})
      for (const int row : *of) column_of[row] = column++;
    end_of_columns = column;
  }

  // room for all columns
  void size_columns(int components, bool rows)
  {
    columns.resize(end_of_columns, components, rows);
    asks_ahead = columns.memory_usage() > IN_CACHE;
  }

  // room for so many components of gathered neighbors, as far apart as in columns.  No more than
  // there can be: a stack is touched page by page before it is used
  template <int MOST> struct Scratch {
    alignas(64) Number of[(MOST + BLOCK) * NEXT];
  };
  void gather(const int *from, int first, int end, Number *to) const;
  template <int... C>
  static void prefetch_components(const Number *at, std::integer_sequence<int, C...>)
  {
    (prefetch(at + C * NEXT, 1), ...);
  }

  // the same of components [first, end)
  static void prefetch_components(const Number *at, int first, int end)
  {
    for (int c = first; c < end; c++) prefetch(at + c * NEXT, 1);
  }
  // is what sweeps read of the block after the next one to be asked for?
  bool asks_for_block(int block) const { return asks_ahead && block + 2 < blocks(); }
  bool ask_points_ahead(const Particles &, int block, const Batch &, int first, int end) const;
  // of what particles have, for the block after the next one
  void ask_for(const double *array, const Batch &batch) const
  {
    if (asks_ahead) prefetch(array + batch.i[0] + 2 * LANES, LANES);
  }

  // a sweep's view of the columns that slots of a block read, which lie so far `further` (sph_solid_slots.h).
  // Of gathered ones there are components [first, end) and [second, second_end), MOST of them.  Where
  // they are is not read again after stores, which a compiler would do for members of the sweeps
  template <int MOST> class SlotColumns {
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
    Scratch<MOST> scratch;

    const int *of_gathered(int further) const
    {
      return gathered_columns + std::size_t(further - GATHERED) * LANES;
    }
    // not inlined: a loop over other slots has registers for what it needs then
    [[gnu::noinline]] const Number *gathered(const int *from)
    {
      of.gather(from, first, end, scratch.of);
      of.gather(from, second, second_end, scratch.of);
      return scratch.of;
    }
  };

  // of the particles of a block, or of a slot's neighbors
  static Pack component(const Number *at, int c) { return load(at + c * NEXT); }
  static Tensors tensor(const Number *at, int c)
  {
    Tensors t;
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) t(a, b) = component(at, c + D * a + b);
    return t;
  }
  // D components from c on
  static void load_own(const Number *i, int c, Pack *out)
  {
    for (int a = 0; a < D; a++) out[a] = component(i, c + a);
  }
  static void difference(const Pack *own, const Number *j, int c, Pack *out)
  {
    for (int a = 0; a < D; a++) out[a] = own[a] - component(j, c + a);
  }
  static void difference(const Number *i, const Number *j, int c, Pack *out)
  {
    Pack own[D];
    load_own(i, c, own);
    difference(own, j, c, out);
  }
  // positions of particles, from which those of neighbors are so far apart.  Of a particle itself: in a
  // sweep's loop the compiler would read it again for every neighbor
  struct Places {
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
  struct Motion : Places {
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
  Parts motion(const Number *i, const Number *j) const { return Motion(*this, i).from(j); }
  // of two columns
  double apart(int column, int other, int component) const
  {
    return ruler.apart(columns.at(column) + component * NEXT, columns.at(other) + component * NEXT);
  }
  void store_tensor(int column, int c, const Tensors &t)
  {
    Pack components[D * D];
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) components[D * a + b] = t(a, b);
    columns.store(column, c, components, D * D);
  }
  static void add_forces(const Particles &, const Batch &, const Pack *f);
  static void repeat_last(Pack &, int n);
  static void repeat_last(Tensors &t, int n)
  {
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) repeat_last(t(a, b), n);
  }
  template <int part>
  static void load_vectors(const Batch &, const double *const *of, SPHSolid::Pack *v);
  static void load_vectors(const Batch &, const double *const *of, Pack *v);
  void pack_vectors(int block, const Batch &, int component, const double *const *of);
  void pack_places(int block, const Batch &, const double *const *x);
  void set_places(int column, int component, const double *x);
  void store_displacement(int block, const Pack *u);
  void pack_ghosts(const Particles &, const double *const *v);
  void mirror_vectors(int component);
  void mirror_component(int component, double factor, int image);
  void mirror_tensor(int component, const double *sign, int image);
  void mirror_rate(int component, const double *sign, int image);

  // rates of deformation D: what lies on and above the diagonal, twice what lies above
  void store_rate(int column, int at, const Tensors &L)
  {
    Pack components[SYMMETRIC], *to = components;
    for (int a = 0; a < D; a++) {
      *to++ = L(a, a);
      for (int b = a + 1; b < D; b++) *to++ = L(a, b) + L(b, a);
    }
    columns.store(column, at, components, SYMMETRIC);
  }
  // x.Dx: of one particle, or the sum of two
  static Pack stretching(const Number *i, int at, const Pack *x)
  {
    return stretching(x, [=](int c) {
      return component(i, at + c);
    });
  }
  static Pack stretching(const Number *i, const Number *j, int at, const Pack *x)
  {
    return stretching(x, [=](int c) {
      return component(i, at + c) + component(j, at + c);
    });
  }
  template <class Rate> static Pack stretching(const Pack *x, Rate rate)
  {
    Pack sum = 0.0;
    for (int a = 0, c = 0; a < D; a++) {
      Pack t = rate(c++) * x[a];
      for (int b = a + 1; b < D; b++) t = multiply_add(rate(c++), x[b], t);
      sum = multiply_add(x[a], t, sum);
    }
    return sum;
  }

  // viscosity.  For the switch of "front": the velocity gradient of a particle predicts the jump
  // x_ij.D x_ij of a pair.  Weights -F_ij V_j/x_ij^2 with g_ij = F_ij x_ij, given without 1/x_ij^2
  struct Jumps {
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
  void find_lonely();
  Pack whole_pull(const Number *i, const Number *j, int last, Pack pull) const;
  // the part of a pair's viscous force that is heat as it is: a compatible correction heats in a
  // way of its own, but for pairs that it must not touch
  Pack heated_pull(const Number *i, const Number *j, int last, Pack pull) const
  {
    const bool all = !needs_correction() || opt.heating == Heating::PRINTED;
    return all ? pull : whole_pull(i, j, last, pull);
  }
  // what becomes heat of the correction's forces on nearest particles while they move by u, which is in V:
  // compatible: -1/4 sum w_ij (u_i - u_j).(da_i - da_j) for symmetric weights;
  // shepard weights leak momentum, there the loss of kinetic energy of the
  // particle itself becomes heat (exact in total, not Galilean invariant);
  // printed: the correction term of eq. 30, 1/2 sum w_ij (u_i - u_j).da_j;
  // safe: half the work of each central pair force, none of it negative for u = v.
  // Of a pair -4/m_i of it, without w_ij.  EVENLY: for heats_evenly()
  template <bool EVENLY> struct CorrectionHeat {
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
  template <bool MAY_BE_SAFE> class Along {
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
  // weights safe, without the weight
  Pack safe_pull_of(const Number *i, const Number *j, int at_da) const
  {
    const Parts d = motion(i, j);
    Pack a[D];
    difference(i, j, at_da, a);
    return safe_pull(dot<D>(a, d.x), d.v_dot_x(), d.x_dot_x());
  }
  Pack standard_power(const Number *i, Pack mass) const;
  // what heat() does with the energy of a block
  static void give_heat(const Particles &p, const Batch &batch, Pack mass, double *heat,
                        Pack energy)
  {
    if (heat)
      batch.store(heat, energy);
    else
      add_heat(p, batch, mass, energy);
  }
  static void add_heat(const Particles &p, const Batch &batch, Pack mass, Pack energy)
  {
    batch.add(p.e, energy / mass);
  }

  // of a block the sum of f_ij (x) x_ij
  virtual Tensors block_virial(const Particles &, int block, const Batch &) const = 0;
};

// call(block, its particles, totals); the totals of all blocks

template <int D, class Precision>
template <class Call>
typename ColumnSweeps<D, Precision>::Totals ColumnSweeps<D, Precision>::each_block(Call call)
{
  return join_shares(
      nthreads, blocks(), Totals(),
      [&](int first, int end) {
        Totals totals;
        for (int block = first; block < end; block++) call(block, batch(block), totals);
        return totals;
      },
      Totals::add);
}

// of the block after the next one, if its particles lie behind these, what the constitutive update reads
// and the components [first, end) that it writes; was it asked for?

template <int D, class Precision>
bool ColumnSweeps<D, Precision>::ask_points_ahead(const Particles &p, int block, const Batch &batch,
                                                  int first, int end) const
{
  const int next = batch.i[0] + 2 * LANES;
  if (!asks_for_block(block) || !batch.consecutive || next + LANES > p.nlocal) return false;
  Base::prefetch_state(p, next, LANES);
  prefetch_components(columns.at((block + 2) * LANES), first, end);
  return true;
}

// behind the last particle the last one again

template <int D, class Precision> void ColumnSweeps<D, Precision>::repeat_last(Pack &v, int n)
{
  v = where_lanes(first_lanes(n), v, Pack(v[n - 1]));
}

/* ----------------------------------------------------------------------
   what is read of neighbors
------------------------------------------------------------------------- */

// LAMMPS's vectors of a part of a block; behind the last particle those of the last one again

template <int D, class Precision>
template <int part>
void ColumnSweeps<D, Precision>::load_vectors(const Batch &batch, const double *const *of,
                                              SPHSolid::Pack *v)
{
  const int *i = batch.i + part * SPHSolid::LANES;
  if (batch.consecutive)
    load_components<D>(of[0] + SPACE * std::ptrdiff_t(i[0]), v);
  else
    for (int a = 0; a < D; a++)
      v[a] = pack_of([&](int m) {
        return of[i[m]][a];
      });
}

// of a block

template <int D, class Precision>
void ColumnSweeps<D, Precision>::load_vectors(const Batch &batch, const double *const *of, Pack *v)
{
  SPHSolid::Pack all[2][D];
  each_part<Pack>([&](auto part) {
    load_vectors<part()>(batch, of, all[part()]);
  });
  for (int a = 0; a < D; a++)
    v[a] = of_parts<Pack>([&](auto part) {
      return all[part()][a];
    });
}

template <int D, class Precision>
void ColumnSweeps<D, Precision>::pack_vectors(int block, const Batch &batch, int component,
                                              const double *const *of)
{
  Pack v[D];
  load_vectors(batch, of, v);
  columns.store(block * LANES, component, v, D);
}

template <int D, class Precision>
void ColumnSweeps<D, Precision>::pack_places(int block, const Batch &batch, const double *const *x)
{
  each_part<Pack>([&](auto part) {
    SPHSolid::Pack of_part[D];
    load_vectors<part()>(batch, x, of_part);
    columns.write(block * LANES, [&](Number *to) {
      for (int a = 0; a < D; a++)
        ruler.store_place(to + (X + a) * NEXT + part() * SPHSolid::LANES, of_part[a]);
    });
  });
}

// of one column

template <int D, class Precision>
void ColumnSweeps<D, Precision>::set_places(int column, int component, const double *x)
{
  Number of_column[D];
  for (int a = 0; a < D; a++) of_column[a] = ruler.number_of(x[a]);
  columns.set(column, component, of_column, D);
}

// positions and velocities of ghosts and images

template <int D, class Precision>
void ColumnSweeps<D, Precision>::pack_ghosts(const Particles &p, const double *const *v)
{
  each_share(nthreads, p.nall - p.nlocal, [&](int first, int end) {
    for (int i = p.nlocal + first; i < p.nlocal + end; i++) {
      const int column = column_of[i];
      if (column < 0) continue;
      set_places(column, X, p.x[i]);
      columns.set(column, V, v[i], D);
    }
  });
  for (int k = 0; k < images.count(); k++) {
    const int column = column_of[nparticles + k];
    double at[D];
    images.template position<D>(k, p.x[images.source_of(k)], at);
    set_places(column, X, at);
  }
  mirror_vectors(V);
}

// of images

template <int D, class Precision> void ColumnSweeps<D, Precision>::mirror_vectors(int component)
{
  for (int k = 0; k < images.count(); k++) {
    double sign[3];
    images.signs(k, sign);
    for (int a = 0; a < D; a++) mirror_component(component + a, sign[a], k);
  }
}

template <int D, class Precision>
void ColumnSweeps<D, Precision>::mirror_component(int component, double factor, int image)
{
  const int from = column_of[images.source_of(image)], to = column_of[nparticles + image];
  columns.set(to, component, factor * columns.get(from, component));
}

// a tensor of an image is Q T Q^T with Q = diag(sign): component (a,b) times
// both signs

template <int D, class Precision>
void ColumnSweeps<D, Precision>::mirror_tensor(int component, const double *sign, int image)
{
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) mirror_component(component + D * a + b, sign[a] * sign[b], image);
}

template <int D, class Precision>
void ColumnSweeps<D, Precision>::mirror_rate(int component, const double *sign, int image)
{
  for (int a = 0; a < D; a++)
    for (int b = a; b < D; b++) mirror_component(component++, sign[a] * sign[b], image);
}

template <int D, class Precision>
void ColumnSweeps<D, Precision>::store_displacement(int block, const Pack *u)
{
  columns.store(block * LANES, V, u, D);
  columns.copy_to_rows(block * LANES, V, V + D);
}

template <int D, class Precision> void ColumnSweeps<D, Precision>::displace(const double *const *u)
{
  each_block([&](int block, const Batch &batch, Totals &) {
    Pack of_block[D];
    load_vectors(batch, u, of_block);
    store_displacement(block, of_block);
  });
}

template <int D, class Precision>
void ColumnSweeps<D, Precision>::displace(const Particles &p, const Kick &kick)
{
  each_block([&](int block, const Batch &batch, Totals &) {
    Pack v[D], f[D], u[D], a = kick.a_scale / batch.load(p.mass);
    load_vectors(batch, p.v, v);
    load_vectors(batch, p.f, f);
    int of_all = kick.kicked;
    for (int m = 0; m < LANES; m++) of_all &= kick.mask[batch.i[m]];
    if (!of_all)
      a = pack_of<Pack>([&](int m) {
        return kick.mask[batch.i[m]] & kick.kicked ? a[m] : 0.0;
      });
    for (int c = 0; c < D; c++) u[c] = kick.v_scale * v[c] + a * f[c];
    store_displacement(block, u);
  });
}

template <int D, class Precision> void ColumnSweeps<D, Precision>::velocity(int i, double *v) const
{
  const int column = column_of[i];
  for (int a = 0; column >= 0 && a < D; a++) v[a] = columns.get(column, V + a);
}

// components of columns from[0], from[1], ... side by side

template <int D, class Precision>
void ColumnSweeps<D, Precision>::gather(const int *from, int first, int end, Number *to) const
{
  const bool rows = columns.has_rows();
  const Number *at[LANES];
  for (int m = 0; m < LANES; m++) at[m] = rows ? columns.row(from[m]) : columns.at(from[m]);
  if (!rows)
    for (int c = first; c < end; c++)
      store(to + c * NEXT, Precision::pack_of_numbers([&](int m) {
              return at[m][c * NEXT];
            }));
  else
    for (int c = first / BLOCK * BLOCK; c < end; c += BLOCK) {
      Pack of[BLOCK];
      for (int m = 0; m < BLOCK; m++) of[m] = load_blocks(at + m, c);
      transpose(of[0], of[1], of[2], of[3]);
      for (int k = 0; k < BLOCK; k++) store(to + (c + k) * NEXT, of[k]);
    }
}

template <int D, class Precision>
void ColumnSweeps<D, Precision>::add_forces(const Particles &p, const Batch &batch, const Pack *f)
{
  each_part<Pack>([&](auto part) {
    SPHSolid::Pack of_part[D];
    for (int a = 0; a < D; a++) of_part[a] = part_of<part()>(f[a]);
    const int *i = batch.i + part() * SPHSolid::LANES;
    if (batch.consecutive) return add_components<D>(p.f[0] + SPACE * std::ptrdiff_t(i[0]), of_part);
    const int end = std::min(batch.template left<part()>(), SPHSolid::LANES);
    for (int m = 0; m < end; m++)
      for (int a = 0; a < D; a++) p.f[i[m]][a] += of_part[a][m];
  });
}

/* ----------------------------------------------------------------------
   messages: a few components each
------------------------------------------------------------------------- */

template <int D, class Precision>
typename ColumnSweeps<D, Precision>::Part ColumnSweeps<D, Precision>::sent_with(Message what) const
{
  const Sent at = sent();
  if (what == Message::STRESS) return {at.stress, at.da - at.stress};
  if (what == Message::SWITCH) return {at.last, 1};
  return {what == Message::VISCOUS ? at.da : V, D};
}

template <int D, class Precision> int ColumnSweeps<D, Precision>::message_size(Message what) const
{
  return sent_with(what).size;
}

template <int D, class Precision>
void ColumnSweeps<D, Precision>::pack(Message what, int i, double *out) const
{
  const int column = column_of[i];    // none of who has no material
  const Part part = sent_with(what);
  const Number *from = columns.at(std::max(column, 0)) + part.first * NEXT;
  for (int c = 0; c < part.size; c++) out[c] = column < 0 ? 0.0 : from[c * NEXT];
}

template <int D, class Precision>
void ColumnSweeps<D, Precision>::unpack(Message what, const Particles &, int i, const double *in)
{
  const Part part = sent_with(what);
  if (column_of[i] >= 0) columns.set(column_of[i], part.first, in, part.size);
}

/* ----------------------------------------------------------------------
   viscosity
------------------------------------------------------------------------- */

template <int D, class Precision> void ColumnSweeps<D, Precision>::mirror_switch()
{
  for (int k = 0; k < images.count(); k++) mirror_component(sent().last, 1.0, k);
}

// is there a particle without a nearest neighbor?

template <int D, class Precision> void ColumnSweeps<D, Precision>::find_lonely()
{
  const int last = sent().last;
  lonely = false;
  int column = 0;
  for (; column + LANES <= end_of_columns && !lonely; column += LANES)
    lonely = !all_positive(component(columns.at(column), last));
  for (; column < end_of_columns; column++) lonely = lonely || !(columns.get(column, last) > 0.0);
}

// of the pairs that the correction must not touch since one of the two has no nearest neighbor,
// the whole viscous force: what is left of a pair's pull there, 0 elsewhere

template <int D, class Precision>
typename ColumnSweeps<D, Precision>::Pack
ColumnSweeps<D, Precision>::whole_pull(const Number *i, const Number *j, int last, Pack pull) const
{
  if (!needs_correction()) return pull;
  const Pack zero(0.0);
  const Pack both = where_positive(component(i, last), component(j, last), zero);
  return where_positive(both, zero, pull);
}

// what the standard viscosity would heat, apart from pairs that are heated as they are

template <int D, class Precision>
typename ColumnSweeps<D, Precision>::Pack
ColumnSweeps<D, Precision>::standard_power(const Number *i, Pack mass) const
{
  Pack power = 0.0;
  if (!needs_correction() || opt.heating != Heating::COMPATIBLE) return power;
  const int at_da = sent().da;
  for (int a = 0; a < D; a++) power -= mass * component(i, at_da + a) * component(i, V + a);
  return power;
}

/* ----------------------------------------------------------------------
   virial, only on steps that ask for it: half of each pair's sum x_ij f_ij
------------------------------------------------------------------------- */

template <int D, class Precision>
void ColumnSweeps<D, Precision>::virial(const Particles &p, const NeighborRows &, double *six)
{
  Base::add_virial(blocks(), six, [&](int first, int end) {
    typename Base::Six total = {};
    for (int block = first; block < end; block++) {
      const Tensors sum = block_virial(p, block, batch(block));
      for (int a = 0; a < D; a++)
        for (int b = a; b < D; b++)
          total[VOIGT[a][b]] += 0.5 * Base::sum_of_first(sum(b, a), particles_of(block));
    }
    return total;
  });
}

}    // namespace

#endif
