/* ----------------------------------------------------------------------
   Sweeps over rows, second part: switch of a viscosity, acceleration correction, heat.
   Members of RowSweeps, which includes it.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_ROW_SWEEPS_VISCOUS_H
#define LMP_SPH_SOLID_ROW_SWEEPS_VISCOUS_H

#include "sph_solid_row_sweeps.h"

namespace SPHSolid {

// at_rate: where in a row the tensor R is that predicts the jump x_ij.R x_ij of a pair

template <int D>
void RowSweeps<D>::sum_switch(const Particles &p, const NeighborRows &list, int at_rate)
{
  each_share(nthreads, list.inum, [&](int first, int end) {
    for (int ii = first; ii < end; ii++) {
      const int i = list.ilist[ii];
      const Motion<D> own(kin(i));
      const Several<D> rate = load_tensor<D>(str(i) + at_rate);
      const double h = types[p.type[i]].h, least = MU_EPSILON * h * h;    // particles may meet
      Pack rest2 = 0.0, linear2 = 0.0;
      for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k += LANES) {
        const int *j = &pairs.j[k];
        Motion<D> d[BLOCK];
        Pack l_i[BLOCK], l_j[BLOCK];
        for (int m = 0; m < BLOCK; m++) {
          d[m] = own - Motion<D>(Addresses(krow.data(), j + m, Kin::STRIDE));
          const Several<D> X = d[m].spread_x();
          const Addresses sj(srow.data(), j + m, stress_stride);
          l_i[m] = d[m].expanded_x() * times(rate, X);
          l_j[m] = d[m].expanded_x() * times(load_tensor<D>(sj + at_rate), X);
        }
        const Pack weight = pack_of([&](int m) {
          return -kin(j[m])[Kin::VOLUME] * pairs.factor[k + m];
        });
        const Components<D> apart = Motion<D>::components(d);
        const Pack r2 = apart.x_dot_x(), vr = apart.v_dot_x();
        const Pack li = sums(l_i[0], l_i[1], l_i[2], l_i[3]);
        const Pack lj = sums(l_j[0], l_j[1], l_j[2], l_j[3]);
        const Pack rest = vr - 0.5 * (li + lj), w = weight / (r2 + least);
        rest2 += w * rest * rest;
        linear2 += 0.5 * w * (li * li + lj * lj);
      }
      str(i)[Str::SWITCH] *= unresolved_share(sum(rest2), sum(linear2));
    }
  });
}

template <int D> void RowSweeps<D>::mirror_switch()
{
  for (int k = 0; k < nrows - nparticles; k++)
    str(nparticles + k)[Str::SWITCH] = str(images.source_of(k))[Str::SWITCH];
}

/* ----------------------------------------------------------------------
   correction sweep: replaces the viscous acceleration by its grid-scale part
------------------------------------------------------------------------- */

template <int D> void RowSweeps<D>::correction(const Particles &p, const NeighborRows &list)
{
  mirror_vectors(da.data(), VECTOR);
  if (safe()) near_pull.resize(near_weight.size());
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

template <int D> Pack RowSweeps<D>::central_correction(int i)
{
  double sum[LANES] = {};
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.nearest[i]; k++) {
    const int j = pairs.j[k];
    const double *dai = &da[i * VECTOR], *daj = &da[j * VECTOR];
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

/* ----------------------------------------------------------------------
   virial, only on steps that ask for it: half of each pair's sum x_ij f_ij.
   of_row(i) gives a function of pair k and d = x_ij, force of the pair on i without the
   correction, expanded
------------------------------------------------------------------------- */

template <int D>
template <class OfRow>
void RowSweeps<D>::sum_virial(const NeighborRows &list, double *six, OfRow of_row) const
{
  const double *kall = krow.data();
  const int *neighbor = pairs.j.data();
  auto away = [kall, neighbor](const Motion<D> &own, int k) {
    return own - Motion<D>(kall + static_cast<std::int64_t>(neighbor[k]) * Kin::STRIDE);
  };
  Base::add_virial(list.inum, six, [&](int begin, int end) {
    typename Base::Six total = {};
    for (int ii = begin; ii < end; ii++) {
      const int i = list.ilist[ii], first = pairs.first[i];
      const Motion<D> own(kin(i));
      const auto force = of_row(i);
      Several<D> sum = Several<D>::zero();    // (a,b): f_a x_b
      for (int k = first; k < first + pairs.count[i]; k++) {
        const Motion<D> d = away(own, k);
        add_outer(sum, force(k, d), d.spread_x());
      }
      for (int k = first; k < first + pairs.nearest[i]; k++) {
        const Motion<D> d = away(own, k);
        add_outer(sum, near_force(i, k, d), d.spread_x());
      }
      double rows[Blocks<D>::TENSOR];
      store_tensor<D>(Addresses(rows), sum);
      for (int a = 0; a < D; a++)
        for (int b = a; b < D; b++) total[VOIGT[a][b]] += 0.5 * rows[Blocks<D>::at(b, a)];
    }
    return total;
  });
}

// what the correction puts on i for its nearest neighbor in a pair, expanded

template <int D> inline Pack RowSweeps<D>::near_force(int i, int pair, const Motion<D> &d) const
{
  const double half = 0.5 * kin(i)[Kin::MASS];
  if (safe()) return Pack(half * near_pull[pair]) * d.expanded_x();
  const Pack difference = load_expanded<D>(Addresses(&da[i * VECTOR])) -
      load_expanded<D>(Addresses(&da[pairs.j[pair] * VECTOR]));
  return Pack(half * near_weight[pair]) * difference;
}

/* ----------------------------------------------------------------------
   heat: compatible with the pair forces, so that kinetic plus internal
   energy is constant to rounding for any displacement that the kick makes
------------------------------------------------------------------------- */

// of_row(i): the Power of the pairs of i

template <int D>
template <class OfRow>
void RowSweeps<D>::sum_heat(const NeighborRows &list, double *heat, bool book, OfRow of_row)
{
  mirror_vectors(&krow[Kin::V], Kin::STRIDE);
  using Totals = typename Base::Totals;
  const Totals totals = join_shares(
      nthreads, list.inum, Totals(),
      [&](int first, int end) {
        Totals share;
        for (int ii = first; ii < end; ii++) {
          const int i = list.ilist[ii];
          const Power power = of_row(i);
          double q = power.viscous;
          if (needs_correction()) {
            // what the standard viscosity would heat: q has all of it for eq. 30,
            // else the pairs that no correction touches
            q += lonely_power(i);
            share.standard += q + standard_power(i, u(i));
            q += heats_with_pairs() ? power.corrected : heat_correction(i);
          }
          heat[i] = power.stress + q;
          share.viscous += q;
        }
        return share;
      },
      Totals::add);
  if (book) Base::enter(totals, 1.0);
}

// what the standard viscosity would heat, apart from pairs that are heated as they are

template <int D> double RowSweeps<D>::standard_power(int i, const double *u) const
{
  if (opt.heating != Heating::COMPATIBLE) return 0.0;
  double power = 0.0;
  for (int a = 0; a < D; a++) power -= kin(i)[Kin::MASS] * da[i * VECTOR + a] * u[a];
  return power;
}

// the force coefficient of pairs that no correction replaces

template <int D> double RowSweeps<D>::whole_pull(int i, int pair) const
{
  if (!keeps_pairs()) return 0.0;
  if (needs_correction() && !is_lonely(i) && !is_lonely(pairs.j[pair])) return 0.0;
  return kin(i)[Kin::MASS] * pull[pair];
}

// standard viscosity of the pairs that the correction must not touch: one of
// the two has no nearest neighbor.  Symmetric, so momentum stays exact

template <int D> void RowSweeps<D>::lonely_pairs(const Particles &p, int i)
{
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
    const double s = whole_pull(i, k);
    const Vector<D> d = separation(i, pairs.j[k]);
    for (int a = 0; a < D; a++) p.f[i][a] -= s * d[a];
  }
}

// half the work of the pairs that a compatible correction leaves alone

template <int D> double RowSweeps<D>::lonely_power(int i) const
{
  if (!lonely || opt.heating != Heating::COMPATIBLE) return 0.0;
  double sum = 0.0;
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
    const int j = pairs.j[k];
    const double s = whole_pull(i, k);
    for (int a = 0; a < D; a++) sum += s * (u(i)[a] - u(j)[a]) * (kin(i)[a] - kin(j)[a]);
  }
  return 0.5 * sum;
}

// compatible: for symmetric weights, heats_with_pairs();
// shepard weights leak momentum, there the loss of kinetic energy of the
// particle itself becomes heat (exact in total, not Galilean invariant);
// printed: the correction term of eq. 30, 1/2 sum w_ij (u_i - u_j).da_j;
// safe: half the work of each central pair force, none of it negative for u = v

template <int D> double RowSweeps<D>::heat_correction(int i) const
{
  const bool printed = opt.heating == Heating::PRINTED;
  if (safe()) {
    double power = 0.0;
    for (int k = pairs.first[i]; k < pairs.first[i] + pairs.nearest[i]; k++)
      for (int a = 0; a < D; a++)
        power -= near_pull[k] * (u(i)[a] - u(pairs.j[k])[a]) * (kin(i)[a] - kin(pairs.j[k])[a]);
    return 0.25 * kin(i)[Kin::MASS] * power;
  }
  const Pack ui = load_few<D>(u(i));
  Pack power = 0.0;
  each_few(i, [&](Pack w, const int *j, Pack difference) {
    const Pack uj = load_few<D>(u(0), j, Kin::STRIDE);
    if (printed)
      power += w * 0.5 * (ui - uj) * load_few<D>(da.data(), j, VECTOR);
    else
      power -= w * 0.5 * ui * difference;
  });
  return kin(i)[Kin::MASS] * SPHSolid::sum(power);
}

}    // namespace SPHSolid

#endif
