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
   The Eulerian frame: switch of a viscosity, acceleration correction.  Members of EulerianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EULERIAN_VISCOUS_H
#define LMP_SPH_SOLID_EULERIAN_VISCOUS_H

#include "sph_solid_eulerian.h"

namespace {

// that of "front": the velocity gradient R of a particle predicts the jump x_ij.R x_ij of a pair

template <int D> void EulerianSweeps<D>::find_switch(const Particles &p, const NeighborRows &list)
{
  const int R_AT = at_rate();
  each_share(nthreads, list.inum, [&](int first, int end) {
    for (int ii = first; ii < end; ii++) {
      const int i = list.ilist[ii];
      const Motion<D> own(kin(i));
      const Several<D> rate = load_tensor<D>(str(i) + R_AT);
      const double h = types[p.type[i]].h, least = MU_EPSILON * h * h;    // particles may meet
      Pack rest2 = 0.0, linear2 = 0.0;
      each_vector(pairs.count[i], [&](int k, auto left) {
        const int *j = &pairs.j[pairs.first[i] + k];
        Motion<D> d[BLOCK];
        Pack l_i[BLOCK], l_j[BLOCK];
        for (int m = 0; m < BLOCK; m++) {
          d[m] = own - Motion<D>(Addresses(krow.data(), j + m, stride));
          const Several<D> X = d[m].spread_x();
          const Addresses sj(srow.data(), j + m, stress_stride);
          l_i[m] = d[m].expanded_x() * times(rate, X);
          l_j[m] = d[m].expanded_x() * times(load_tensor<D>(sj + R_AT), X);
        }
        const Pack volume = pack_of([&](int m) {
          return kin(j[m])[Kin::VOLUME];
        });
        const Pack weight = -of_row(volume * load(&pairs.factor[pairs.first[i] + k]), left);
        const Components<D> apart = Motion<D>::components(d);
        const Pack r2 = apart.x_dot_x(), vr = apart.v_dot_x();
        const Pack li = sums(l_i[0], l_i[1], l_i[2], l_i[3]);
        const Pack lj = sums(l_j[0], l_j[1], l_j[2], l_j[3]);
        const Pack rest = vr - 0.5 * (li + lj), w = weight / (r2 + least);
        rest2 += w * rest * rest;
        linear2 += 0.5 * w * (li * li + lj * lj);
      });
      str(i)[Str::SWITCH] *= unresolved_share(sum(rest2), sum(linear2));
    }
  });
}

template <int D> void EulerianSweeps<D>::mirror_switch()
{
  for (int k = 0; k < nrows - nparticles; k++)
    str(nparticles + k)[Str::SWITCH] = str(images.source_of(k))[Str::SWITCH];
}

/* ----------------------------------------------------------------------
   correction sweep: replaces the viscous acceleration by its grid-scale part
------------------------------------------------------------------------- */

template <int D> void EulerianSweeps<D>::correction(const Particles &p, const NeighborRows &list)
{
  mirror_vectors(da(0), da_stride);
  each_share(nthreads, list.inum, [&](int first, int end) {
    for (int ii = first; ii < end; ii++) {
      const int i = list.ilist[ii];
      Pack sum = 0.0;
      if (safe())
        sum = central_correction(i);
      else
        each_few(i, [&](Pack w, const int *, Pack difference) {
          sum += w * difference;
        });
      sum = sum_of_blocks(sum);
      for (int a = 0; a < D; a++) p.f[i][a] += 0.5 * kin(i)[Kin::MASS] * few_summed<D>(sum, a);
    }
  });
}

// the same with weights safe; the sum in the first lanes

template <int D> Pack EulerianSweeps<D>::central_correction(int i)
{
  double sum[LANES] = {};
  for (int n = 0; n < pairs.nearest[i]; n++) {
    const int j = pairs.j[pairs.first[i] + n], k = pairs.near_first[i] + n;
    const double *dai = da(i), *daj = da(j);
    const Vector<D> x = separation(i, j);
    double ax = 0.0, vx = 0.0, x2 = 0.0;
    for (int a = 0; a < D; a++) {
      ax += (dai[a] - daj[a]) * x[a];
      vx += (kin(i)[Kin::V + a] - kin(j)[Kin::V + a]) * x[a];
      x2 += x[a] * x[a];
    }
    near_pull[k] = near_weight[k] * safe_pull(ax, vx, x2);
    for (int a = 0; a < D; a++) sum[a] += near_pull[k] * x[a];
  }
  return load(sum);
}

// the force coefficient of pairs that no correction replaces

template <int D> double EulerianSweeps<D>::whole_pull(int i, int pair) const
{
  if (!keeps_pairs()) return 0.0;
  if (needs_correction() && !is_lonely(i) && !is_lonely(pairs.j[pair])) return 0.0;
  return kin(i)[Kin::MASS] * unit_factor * pull[pair];
}

// standard viscosity of the pairs that the correction must not touch: one of
// the two has no nearest neighbor.  Symmetric, so momentum stays exact

template <int D> void EulerianSweeps<D>::lonely_pairs(const Particles &p, int i)
{
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
    const double s = whole_pull(i, k);
    const Vector<D> d = separation(i, pairs.j[k]);
    for (int a = 0; a < D; a++) p.f[i][a] -= s * d[a];
  }
}

}    // namespace

#endif
