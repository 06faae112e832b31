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
   The Lagrangian frame: what neighbors read of a particle, sent to ghosts and
   mirrored to images.  Members of LagrangianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_ROWS_H
#define LMP_SPH_SOLID_LAGRANGIAN_ROWS_H

#include "sph_solid_lagrangian.h"

namespace {

template <int D>
void LagrangianSweeps<D>::pack_kinematics(const Particles &p, const double *const *v)
{
  each_block([&](int block, const Batch &batch, Totals &) {
    pack_vectors(block, batch, X, p.x);
    pack_vectors(block, batch, V, v);
    columns.copy_to_rows(block * LANES, X, REFERENCE);
  });
  each_share(nthreads, p.nall - p.nlocal, [&](int first, int end) {
    for (int i = p.nlocal + first; i < p.nlocal + end; i++) {
      const int column = column_of[i];
      if (column < 0) continue;
      columns.set(column, X, p.x[i], D);
      columns.set(column, V, v[i], D);
    }
  });
  for (int k = 0; k < images.count(); k++) {
    const int column = column_of[nparticles + k];
    double at[D];
    images.template position<D>(k, p.x[images.source_of(k)], at);
    columns.set(column, X, at, D);
  }
  mirror_vectors(V);
}

// LAMMPS's vectors of a block; behind the last particle those of the last one again

template <int D>
void LagrangianSweeps<D>::pack_vectors(int block, const Batch &batch, int component,
                                       const double *const *of)
{
  Pack v[D];
  if (batch.consecutive)
    load_components<D>(of[batch.i[0]], v);
  else
    for (int a = 0; a < D; a++)
      v[a] = pack_of([&](int m) {
        return of[batch.i[m]][a];
      });
  columns.store(block * LANES, component, v, D);
}

// of images

template <int D> void LagrangianSweeps<D>::mirror_vectors(int component)
{
  for (int k = 0; k < images.count(); k++) {
    const int from = column_of[images.source_of(k)], to = column_of[nparticles + k];
    double sign[3];
    images.signs(k, sign);
    for (int a = 0; a < D; a++)
      columns.set(to, component + a, sign[a] * columns.get(from, component + a));
  }
}

template <int D> void LagrangianSweeps<D>::velocity(int i, double *v) const
{
  const int column = column_of[i];
  for (int a = 0; column >= 0 && a < D; a++) v[a] = columns.get(column, V + a);
}

// columns from[0], from[1], ... side by side

template <int D>
const double *LagrangianSweeps<D>::gather(const int *from, int last, Scratch &scratch) const
{
  const bool rows = columns.has_rows();
  const double *at[LANES];
  for (int m = 0; m < LANES; m++) at[m] = rows ? columns.row(from[m]) : columns.at(from[m]);
  auto copy = [&](int c, int end) {
    if (rows)
      for (c = c / BLOCK * BLOCK; c < end; c += BLOCK) {
        Pack of[BLOCK];
        for (int m = 0; m < BLOCK; m++)
          of[m] = load(Addresses(at[m] + c, at[m + LANES - BLOCK] + c));
        transpose(of[0], of[1], of[2], of[3]);
        for (int k = 0; k < BLOCK; k++) store(scratch.of + (c + k) * NEXT, of[k]);
      }
    else
      for (; c < end; c++)
        store(scratch.of + c * NEXT, pack_of([&](int m) {
                return at[m][c * NEXT];
              }));
  };
  copy(0, last);
  copy(std::max(last, at_da), columns.components());
  return scratch.of;
}

/* ----------------------------------------------------------------------
   messages: a few components each
------------------------------------------------------------------------- */

template <int D> int LagrangianSweeps<D>::message_size(Message what) const
{
  if (what == Message::STRESS) return at_da - T;
  return what == Message::SWITCH ? 1 : D;
}

template <int D> int LagrangianSweeps<D>::place_of(Message what) const
{
  if (what == Message::STRESS) return T;
  if (what == Message::SWITCH) return LAST;
  return what == Message::VISCOUS ? at_da : V;
}

template <int D> void LagrangianSweeps<D>::pack(Message what, int i, double *out) const
{
  const int column = column_of[i], n = message_size(what);    // none of who has no material
  const double *from = columns.at(std::max(column, 0)) + place_of(what) * NEXT;
  for (int c = 0; c < n; c++) out[c] = column < 0 ? 0.0 : from[c * NEXT];
}

template <int D>
void LagrangianSweeps<D>::unpack(Message what, const Particles &, int i, const double *in)
{
  const int column = column_of[i], first = place_of(what);
  if (column < 0) return;
  columns.set(column, first, in, message_size(what));
}

// a tensor of an image is Q T Q^T with Q = diag(sign): component (a,b) times
// both signs

template <int D> void LagrangianSweeps<D>::mirror_stress()
{
  for (int k = 0; k < images.count(); k++) {
    const int from = column_of[images.source_of(k)], to = column_of[nparticles + k];
    double sign[3];
    images.signs(k, sign);
    auto copy = [&](int c, double factor) {
      columns.set(to, c, factor * columns.get(from, c));
    };
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) copy(T + D * a + b, sign[a] * sign[b]);
    for (const int c : {IMPEDANCE, SOUND, DENSITY, LAST}) copy(c, 1.0);
    for (int a = 0, c = at_rate; keeps_rates() && a < D; a++)
      for (int b = a; b < D; b++) copy(c++, sign[a] * sign[b]);
  }

  if (needs_correction() && !weights_known) {    // as long as weights are known, so is this
    lonely = false;
    for (const int column : column_of)
      lonely = lonely || (column >= 0 && !(columns.get(column, LAST) > 0.0));
  }
  // not sooner, when lists of partners take room as well
  if (opt.hourglass > 0.0) damp.resize(slots.pairs());
  if (keeps_pairs()) pull.resize(slots.pairs());
}

template <int D> void LagrangianSweeps<D>::mirror_switch()
{
  for (int k = 0; k < images.count(); k++)
    columns.set(column_of[nparticles + k], LAST, columns.get(column_of[images.source_of(k)], LAST));
}

}    // namespace

#endif
