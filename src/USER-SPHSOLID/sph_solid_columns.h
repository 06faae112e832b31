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
   Particles side by side: one array per component, in chunks.

   A pack has one component of as many particles as there are lanes.  On a
   lattice whose particles are numbered row by row, the partners of particles that
   lie side by side do so, too: what is read of them is one load per component,
   with no gather and no transposition, and sums over pairs need no sum over
   lanes.  Loads of a chunk's last columns go on into those of the next one, whose
   first columns each chunk therefore has as well.

   Who has to gather neighbors from anywhere finds all components of one in a row, if
   rows are wanted: else each lies on a cache line of its own.

   Chunks, and not one long array per component: all components of a few particles
   lie on few pages, and a component's place behind the first is a constant.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_COLUMNS_H
#define LMP_SPH_SOLID_COLUMNS_H

#include "sph_solid_precision.h"
#include "sph_solid_storage.h"

#include <algorithm>

namespace SPHSolid {

template <class Precision> class ColumnsOf {
 public:
  using Number = typename Precision::Number;
  using Pack = typename Precision::Pack;
  static constexpr int LANES = lanes_of<Pack>;
  static constexpr int LENGTH = 256;             // columns of a chunk, a multiple of LANES
  static constexpr int NEXT = LENGTH + LANES;    // from one component to the next [numbers]

  // ncolumns of ncomponents each, all 0; with_rows: what a column has is kept in one place, too
  void resize(int ncolumns, int ncomponents, bool with_rows)
  {
    n = ncomponents;
    stride = (n + BLOCK - 1) / BLOCK * BLOCK;
    rows.assign(with_rows ? static_cast<std::size_t>(whole_blocks(ncolumns)) * stride : 0, 0.0);
    const std::size_t chunks = static_cast<std::size_t>((ncolumns + 2 * LANES) / LENGTH + 1);
    data.assign(chunks * size_of_chunk(), 0.0);
  }
  int components() const { return n; }
  // n rounded up to whole blocks
  static int whole_blocks(int n) { return (n + LANES - 1) / LANES * LANES; }

  // component 0 of a column, component c lies c NEXT numbers behind; from -LANES on to the one
  // behind the last, with LANES - 1 further columns behind it
  Number *at(int column) { return data.data() + place(column); }
  const Number *at(int column) const { return data.data() + place(column); }

  // numbers from one column to another, not more than FURTHEST away (sph_solid_slots.h)
  int from(int column, int other) const { return static_cast<int>(at(other) - at(column)); }

  // For who asks ahead: a column lies so many before the end of its chunk; those behind lie skipped() numbers
  // further on than that many columns
  static int left_of_chunk(int column) { return LENGTH - (column + LANES) % LENGTH; }
  std::ptrdiff_t skipped() const { return size_of_chunk() - LENGTH; }

  // LANES columns from a multiple of LANES on
  void store(int column, int component, Pack v) { store(column, component, &v, 1); }
  // of count components from first on
  void store(int column, int first, const Pack *v, int count)
  {
    write(column, [&](Number *to) {
      for (int c = 0; c < count; c++) SPHSolid::store(to + (first + c) * NEXT, v[c]);
    });
  }
  // call(component 0 of a column or of the first of LANES columns) wherever it is stored
  template <class Call> [[gnu::always_inline]] void write(int column, Call call)
  {
    call(at(column));
    if (begins_chunk(column)) call(at(column) + LENGTH - size_of_chunk());
  }
  // after stores: the same in rows, if there are any
  void copy_to_rows(int column, int first, int last)
  {
    if (!has_rows()) return;
    for (int c = first; c < last; c++)
      for (int m = 0; m < LANES; m++) row_of(column + m)[c] = at(column)[c * NEXT + m];
  }
  // the column that at() has found
  int column(const Number *at) const
  {
    const std::ptrdiff_t place = at - data.data(), chunk = place / size_of_chunk();
    return static_cast<int>(chunk * LENGTH + place % size_of_chunk()) - LANES;
  }
  double get(int column, int component) const { return at(column)[component * NEXT]; }
  void set(int column, int component, double v) { set(column, component, &v, 1); }
  // count components from first on of one column
  template <class T> void set(int column, int first, const T *v, int count)
  {
    write(column, [&](Number *to) {
      for (int c = 0; c < count; c++) to[(first + c) * NEXT] = static_cast<Number>(v[c]);
    });
    if (has_rows()) std::copy(v, v + count, row_of(column) + first);
  }

  bool has_rows() const { return !rows.empty(); }
  const Number *row(int column) const { return &rows[static_cast<std::size_t>(column) * stride]; }
  double memory_usage() const
  {
    return static_cast<double>((data.capacity() + rows.capacity()) * sizeof(Number));
  }

 private:
  AlignedRows<Number> data, rows;
  int n = 0, stride = 0;

  Number *row_of(int column) { return &rows[static_cast<std::size_t>(column) * stride]; }

  std::ptrdiff_t size_of_chunk() const { return static_cast<std::ptrdiff_t>(n) * NEXT; }
  std::ptrdiff_t place(int column) const
  {
    const unsigned c = static_cast<unsigned>(column + LANES);
    return static_cast<std::ptrdiff_t>(c / LENGTH) * size_of_chunk() + c % LENGTH;
  }
  // one of the first columns of a chunk that are the last of the one before it as well
  static bool begins_chunk(int column)
  {
    const unsigned c = static_cast<unsigned>(column + LANES);
    return c % LENGTH < LANES && c >= LENGTH;
  }
};

using Columns = ColumnsOf<DoublePrecision>;

}    // namespace SPHSolid

#endif
