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
   Between LAMMPS' rows of particles and columns: positions and velocities, forces, messages to ghosts,
   mirror images.  Members of ColumnSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_COLUMN_ROWS_H
#define LMP_SPH_SOLID_COLUMN_ROWS_H

#include "sph_solid_column_sweeps.h"

namespace {

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

}    // namespace

#endif
