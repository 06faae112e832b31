/* ----------------------------------------------------------------------
   Particles side by side: one array per component, in chunks.

   A pack has one component of as many particles as there are lanes.  On a
   lattice whose particles are numbered row by row, the partners of particles that
   lie side by side do so, too: what is read of them is one load per component,
   with no gather and no transposition, and sums over pairs need no sum over
   lanes.  Loads of a chunk's last columns go on into those of the next one, whose
   first columns each chunk therefore has as well.

   Chunks, and not one long array per component: all components of a few particles
   lie on few pages, and a component's place behind the first is a constant.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_COLUMNS_H
#define LMP_SPH_SOLID_COLUMNS_H

#include "sph_solid_vector.h"

namespace SPHSolid {

class Columns {
 public:
  static constexpr int LENGTH = 256;             // columns of a chunk, a multiple of LANES
  static constexpr int NEXT = LENGTH + LANES;    // from one component to the next [doubles]

  // ncolumns of ncomponents each, all 0
  void resize(int ncolumns, int ncomponents)
  {
    n = ncomponents;
    const std::size_t chunks = static_cast<std::size_t>((ncolumns + 2 * LANES) / LENGTH + 1);
    data.assign(chunks * size_of_chunk(), 0.0);
  }
  int components() const { return n; }

  // component 0 of a column, component c lies c NEXT doubles behind; from -LANES on to the one
  // behind the last, with LANES - 1 further columns behind it
  double *at(int column) { return data.data() + place(column); }
  const double *at(int column) const { return data.data() + place(column); }

  // LANES columns from a multiple of LANES on
  void store(int column, int component, Pack v)
  {
    double *to = at(column) + component * NEXT;
    SPHSolid::store(to, v);
    if (begins_chunk(column)) SPHSolid::store(to + LENGTH - size_of_chunk(), v);
  }
  double get(int column, int component) const { return at(column)[component * NEXT]; }
  void set(int column, int component, double v)
  {
    double *to = at(column) + component * NEXT;
    *to = v;
    if (begins_chunk(column)) to[LENGTH - size_of_chunk()] = v;
  }
  double memory_usage() const { return static_cast<double>(data.capacity() * sizeof(double)); }

 private:
  Rows data;
  int n = 0;

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

}    // namespace SPHSolid

#endif
