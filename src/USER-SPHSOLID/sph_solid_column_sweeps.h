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
  // of the columns and their numbers [bytes]
  double memory_of_columns() const
  {
    const std::size_t ints = own.capacity() + column_of.capacity() + first_of_run.capacity();
    return columns.memory_usage() + static_cast<double>(ints * sizeof(int));
  }

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

  // what a sweep sees of columns: sph_solid_column_views.h
  template <int MOST> class SlotColumns;
  struct Places;
  struct Motion;
  struct Jumps;
  template <bool EVENLY> struct CorrectionHeat;
  template <bool MAY_BE_SAFE> class Along;

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

  void find_lonely();
  Pack whole_pull(const Number *i, const Number *j, int last, Pack pull) const;
  // the part of a pair's viscous force that is heat as it is: a compatible correction heats in a
  // way of its own, but for pairs that it must not touch
  Pack heated_pull(const Number *i, const Number *j, int last, Pack pull) const
  {
    const bool all = !needs_correction() || opt.heating == Heating::PRINTED;
    return all ? pull : whole_pull(i, j, last, pull);
  }
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
