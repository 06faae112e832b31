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
   The Eulerian frame: storage, and what neighbors read of a particle, sent to ghosts and
   mirrored to images.  Members of EulerianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EULERIAN_ROWS_H
#define LMP_SPH_SOLID_EULERIAN_ROWS_H

#include "sph_solid_eulerian.h"

namespace {

/* ----------------------------------------------------------------------
   storage
------------------------------------------------------------------------- */

template <int D>
void EulerianSweeps<D>::new_neighbors(const Particles &p, const NeighborRows &list, double reach)
{
  Base::find_image_candidates(p, list, p.x, reach);
  size_rows(p);
  make_room_for_pairs(list);
}

template <int D> void EulerianSweeps<D>::size_rows(const Particles &p)
{
  nown = p.nlocal;
  nparticles = p.nall;
  nrows = p.nall + (images.any() ? images.count() : 0);
  krow.resize(static_cast<std::size_t>(nrows) * stride);
  srow.resize(static_cast<std::size_t>(nrows) * stress_stride);
  if (needs_correction() && !da_in_rows) da_rows.resize(static_cast<std::size_t>(nrows) * VECTOR);
  if (this->limits_step) mu_max.assign(p.nlocal, 0.0);
  for (std::vector<int> *of : {&pairs.first, &pairs.count, &pairs.near_first, &pairs.nearest})
    of->assign(p.nlocal, 0);
  each_share(nthreads, nrows, [&](int first, int end) {
    for (int row = first; row < end; row++) {
      pack_constants(p, source_of(row), kin(row));
      // who has no material (in a hybrid) has no stress either, and is not lonely
      if (!Base::has_material(p, source_of(row))) str(row)[Str::NSUM] = 1.0;
    }
  });
}

// for all candidates of a batch: as many pairs as there may be until neighbors are new

template <int D> void EulerianSweeps<D>::make_room_for_pairs(const NeighborRows &list)
{
  std::size_t n = 0;
  pairs.begin.clear();
  pairs.most = 0;
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    if (ii % LANES == 0) {
      pairs.begin.push_back(static_cast<int>(n));
      n += LANES;    // which may be written to behind the last candidate
    }
    n += whole_vectors(list.numneigh[i] + images_of(i));
    pairs.most = std::max(pairs.most, static_cast<int>(n) - pairs.begin.back());
  }
  make_room(pairs.j, n);
  make_room(pairs.factor, n);
  if (needs_correction()) make_room(near_weight, n);
  if (safe()) make_room(near_pull, n);
  if (opt.tensile) make_room(crowd, n);
}

// what a kinematic row has of a particle besides its motion

template <int D>
void EulerianSweeps<D>::pack_constants(const Particles &p, int i, double *row) const
{
  const TypeData &t = types[p.type[i]];
  row[Kin::MASS] = p.mass[i];
  if (uniform) return;
  row[Kin::H] = t.h;
  row[Kin::NEAR] = opt.hbar * t.spacing;
}

/* ---------------------------------------------------------------------- */

template <int D> void EulerianSweeps<D>::pack_kinematics(const Particles &p, const double *const *v)
{
  each_share(nthreads, p.nall, [&](int first, int end) {
    for (int i = first; i < end; i++) {
      double *row = kin(i);
      const double *x = p.x[i], *vi = v[i];
      for (int a = 0; a < D; a++) {
        row[Kin::X + a] = x[a];
        row[Kin::V + a] = vi[a];
      }
      row[Kin::VOLUME] = unit_factor * p.mass[i] / p.rho_weight[i];
    }
  });
  for (int k = 0; k < nrows - p.nall; k++) {
    const double *from = kin(images.source_of(k));
    double *row = kin(p.nall + k);
    double sign[3];
    images.signs(k, sign);
    images.template position<D>(k, from + Kin::X, row + Kin::X);
    for (int a = 0; a < D; a++) row[Kin::V + a] = sign[a] * from[Kin::V + a];
    row[Kin::VOLUME] = from[Kin::VOLUME];
  }
}

template <int D>
void EulerianSweeps<D>::write_rows(const Batch &batch, const Points &points,
                                   const Tensor<D, Pack> &T, Pack K, Pack nsum)
{
  write_tensors(batch, Str::T, T);
  Pack rho = points.state.rho, c = square_root(maximum(points.eos.c2, Pack(0.0)));
  transpose(K, rho, c, nsum);
  const Pack state[BLOCK] = {K, rho, c, nsum};
  for (int m = 0; m < BLOCK; m++)
    store(batch.rows(srow.data(), m, stress_stride) + Str::K, state[m]);
}

// one tensor of the rows

template <int D>
void EulerianSweeps<D>::write_tensors(const Batch &batch, int at, const Tensor<D, Pack> &t)
{
  Several<D> rows[BLOCK];
  from_lanes<D>(t, rows);
  for (int m = 0; m < BLOCK; m++)
    store_tensor(batch.rows(srow.data(), m, stress_stride) + at, rows[m]);
}

// what the next batch needs, if it lies behind this one

template <int D>
void EulerianSweeps<D>::prefetch_points(const Particles &p, const Batch &batch) const
{
  const int next = batch.i[0] + LANES;
  if (next + LANES > nown) return;
  Base::prefetch_state(p, next);
  prefetch(str(next), LANES * stress_stride);
}

/* ----------------------------------------------------------------------
   rows of ghosts and images
------------------------------------------------------------------------- */

template <int D> int EulerianSweeps<D>::message_size(Message what) const
{
  if (what == Message::STRESS) return stress_stride;
  return what == Message::SWITCH ? 1 : D;
}

template <int D> double *EulerianSweeps<D>::place_of(Message what, int i)
{
  if (what == Message::STRESS) return str(i);
  if (what == Message::SWITCH) return str(i) + Str::SWITCH;
  return what == Message::VISCOUS ? da(i) : kin(i) + Kin::V;
}

template <int D> void EulerianSweeps<D>::pack(Message what, int i, double *out) const
{
  const double *from = const_cast<EulerianSweeps *>(this)->place_of(what, i);
  std::copy(from, from + message_size(what), out);
}

template <int D>
void EulerianSweeps<D>::unpack(Message what, const Particles &p, int i, const double *in)
{
  if (what == Message::DISPLACEMENT) return displace(p, i, 1, in);
  if (what == Message::STRESS && !Base::has_material(p, i)) return;    // the row's owner has none
  std::copy(in, in + message_size(what), place_of(what, i));
  if (what == Message::STRESS) p.rho[i] = in[Str::RHO];
}

// K of the stress row comes next to what else heat reads of a neighbor, where its volume lies until
// velocities are new

template <int D>
void EulerianSweeps<D>::displace(const Particles &, int first, int n, const double *displacements)
{
  for (int k = 0; k < n; k++) {
    double *row = kin(first + k);
    for (int a = 0; a < D; a++) row[Kin::V + a] = displacements[3 * k + a];
    row[Kin::VOLUME] = str(first + k)[Str::K];
  }
}

// a tensor of an image is Q T Q^T with Q = diag(sign): component (a,b) times
// both signs

template <int D> void EulerianSweeps<D>::mirror_stress()
{
  for (int k = 0; k < nrows - nparticles; k++) {
    const double *from = str(images.source_of(k));
    double *row = str(nparticles + k);
    double sign[3];
    images.signs(k, sign);
    std::copy(from, from + stress_stride, row);
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) {
        row[Str::T + Blocks<D>::at(a, b)] *= sign[a] * sign[b];
        for (int t = 0; t < ntensors; t++) row[extra(t) + Blocks<D>::at(a, b)] *= sign[a] * sign[b];
      }
  }

  if (needs_correction()) {
    lonely = false;
    for (int i = 0; i < nrows; i++) lonely = lonely || !(str(i)[Str::NSUM] > 0.0);
  }
  if (keeps_pairs()) make_room(pull, pairs.j.size());
}

template <int D> void EulerianSweeps<D>::mirror_vectors(double *rows, int step) const
{
  for (int k = 0; k < nrows - nparticles; k++) {
    double sign[3];
    images.signs(k, sign);
    for (int a = 0; a < D; a++)
      rows[(nparticles + k) * step + a] = sign[a] * rows[images.source_of(k) * step + a];
  }
}

template <int D>
double EulerianSweeps<D>::time_step_limit(const Particles &p, const NeighborRows &list) const
{
  return Base::least_of(list.inum, NO_LIMIT, [&](int first, int end) {
    double limit = NO_LIMIT;
    for (int ii = first; ii < end; ii++) {
      const int i = list.ilist[ii];
      const double *row = str(i);
      const TypeData &type = types[p.type[i]];
      limit = std::min(
          limit,
          Base::step_limit(type.h, type.material.shear, row[Str::RHO], row[Str::C], mu_max[i]));
    }
    return limit;
  });
}

template <int D> double EulerianSweeps<D>::memory_usage() const
{
  std::size_t all = 0, near = 0;    // pairs: what is in use of the room for candidates
  for (const int n : pairs.count) all += n;
  for (const int n : pairs.nearest) near += whole_vectors(n);
  auto used = [](const Room<double> &of, std::size_t n) {
    return of.empty() ? 0 : n;
  };
  const std::size_t doubles = krow.capacity() + srow.capacity() + da_rows.capacity() +
      mu_max.capacity() + used(pull, all) + used(crowd, all) + used(near_weight, near) +
      used(near_pull, near);
  const std::size_t ints = 2 * all + 4 * pairs.first.capacity() + pairs.begin.capacity() +
      image_first.capacity() + image_j.capacity();
  return static_cast<double>(doubles * sizeof(double) + ints * sizeof(int));
}

}    // namespace

#endif
