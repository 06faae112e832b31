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
   The Eulerian frame: heat and virial.  Members of EulerianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EULERIAN_HEAT_H
#define LMP_SPH_SOLID_EULERIAN_HEAT_H

#include "sph_solid_eulerian.h"

namespace {

/* ----------------------------------------------------------------------
   heat: compatible with the pair forces, so that kinetic plus internal
   energy is constant to rounding for any displacement that the kick makes
------------------------------------------------------------------------- */

template <int D>
void EulerianSweeps<D>::heat(const Particles &, const NeighborRows &list, double *heat, bool book)
{
  mirror_vectors(&krow[Kin::V], stride);
  for (int row = nparticles; row < nrows; row++) kin(row)[Kin::VOLUME] = str(row)[Str::K];
  typename Base::Totals totals;
  with_flags(
      [&](auto pull, auto tensile, auto correct, auto same) {
        totals = sum_heat(list, heat, [this](int i) {
          return pair_power<decltype(pull)::value, decltype(tensile)::value,
                            decltype(correct)::value, decltype(same)::value>(i);
        });
      },
      heats_pairs(), opt.tensile, heats_with_pairs(), uniform);
  if (book) Base::enter(totals, 1.0);
}

// of_row(i): the Power of the pairs of i

template <int D>
template <class OfRow>
typename EulerianSweeps<D>::Base::Totals
EulerianSweeps<D>::sum_heat(const NeighborRows &list, double *heat, OfRow of_row) const
{
  using Totals = typename Base::Totals;
  return join_shares(
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
}

// stress power K_i T_i : sum_j K_j (u_j - u_i) (x) g: the sigma_i half of
// eq. 20, exact adjoint of the force

template <int D>
template <bool PULL, bool TENSILE, bool CORRECT, bool UNIFORM>
typename EulerianSweeps<D>::Power EulerianSweeps<D>::pair_power(int i) const
{
  constexpr int R_AT = extra(0);
  const double *kall = krow.data(), *si = str(i), *all_da = CORRECT ? da(0) : nullptr;
  const Motion<D> own(kin(i));
  const Pack own_da = Motion<D>::load_vector(Addresses(CORRECT ? da(i) : kin(i)));
  Several<D> gradient = Several<D>::zero(), crowded = gradient;
  Pack viscous(0.0), corrected(0.0);
  const int first = pairs.first[i], count = pairs.count[i],
            nearest = CORRECT ? pairs.nearest[i] : 0;
  const double *weights = near_weight.data() + pairs.near_first[i];
  auto add = [&](auto near, int k, auto left) {
    const int *j = &pairs.j[first + k];
    const Pack none(0.0);
    const Spread factor(of_row(load(&pairs.factor[first + k]), left)),
        tensile(TENSILE ? of_row(load(&crowd[first + k]), left) : none),
        pulled(PULL ? of_row(load(&pull[first + k]), left) : none),
        weight(near() && k < nearest ? load(weights + k) : none);
    for (int m = 0; m < BLOCK; m++) {
      const Addresses kj(kall, j + m, stride_of<UNIFORM>());
      const Motion<D> d = own - Motion<D>(kj);
      const Several<D> X = d.spread_x();
      const Pack v = d.expanded_v() * (minus_volume<D>(d, kj) * factor[m]);
      add_outer(gradient, v, X);
      if (TENSILE) add_outer(crowded, v * tensile[m], X);
      if (PULL) viscous = multiply_add(pulled[m], d.products(), viscous);
      if (near()) {
        const Pack da_j = Motion<D>::load_vector(Addresses(all_da, j + m, da_stride_of<UNIFORM>()));
        corrected = multiply_add(weight[m], d.products(own_da - da_j), corrected);
      }
    }
  };
  const std::bool_constant<CORRECT> near;
  const std::false_type far;
  int k = 0;
  for (; k < nearest && k + LANES <= count; k += LANES) add(near, k, Whole());
  for (; k + LANES <= count; k += LANES) add(far, k, Whole());
  if (k < count) add(near, k, count - k);
  double stress = contract(gradient, load_tensor<D>(si));
  if (TENSILE) stress += contract(crowded, load_tensor<D>(si + R_AT));
  const double mass = kin(i)[Kin::MASS];
  return {unit_factor * si[Str::K] * stress, 0.5 * unit_factor * mass * Motion<D>::v_dot_x(viscous),
          -0.25 * mass * Motion<D>::v_dot_x(corrected)};
}

// what the standard viscosity would heat, apart from pairs that are heated as they are

template <int D> double EulerianSweeps<D>::standard_power(int i, const double *u) const
{
  if (opt.heating != Heating::COMPATIBLE) return 0.0;
  double power = 0.0;
  for (int a = 0; a < D; a++) power -= kin(i)[Kin::MASS] * da(i)[a] * u[a];
  return power;
}

// half the work of the pairs that a compatible correction leaves alone

template <int D> double EulerianSweeps<D>::lonely_power(int i) const
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

template <int D> double EulerianSweeps<D>::heat_correction(int i) const
{
  const bool printed = opt.heating == Heating::PRINTED;
  if (safe()) {
    const int *j = pairs.j.data() + pairs.first[i];
    const double *pulls = near_pull.data() + pairs.near_first[i];
    double power = 0.0;
    for (int k = 0; k < pairs.nearest[i]; k++)
      for (int a = 0; a < D; a++)
        power -= pulls[k] * (u(i)[a] - u(j[k])[a]) * (kin(i)[a] - kin(j[k])[a]);
    return 0.25 * kin(i)[Kin::MASS] * power;
  }
  const Pack ui = load_few<D>(u(i));
  Pack power = 0.0;
  each_few(i, [&](Pack w, const int *j, Pack difference) {
    const Pack uj = load_few<D>(u(0), j, stride);
    if (printed)
      power += w * 0.5 * (ui - uj) * load_few<D>(da(0), j, da_stride);
    else
      power -= w * 0.5 * ui * difference;
  });
  return kin(i)[Kin::MASS] * SPHSolid::sum(power);
}

/* ----------------------------------------------------------------------
   virial, only on steps that ask for it: half of each pair's sum x_ij f_ij
------------------------------------------------------------------------- */

template <int D>
void EulerianSweeps<D>::virial(const Particles &, const NeighborRows &list, double *six)
{
  Base::add_virial(list.inum, six, [&](int begin, int end) {
    typename Base::Six total = {};
    for (int ii = begin; ii < end; ii++) {
      double rows[Blocks<D>::TENSOR];    // (a,b): f_a x_b
      store_tensor<D>(Addresses(rows), row_virial(list.ilist[ii]));
      for (int a = 0; a < D; a++)
        for (int b = a; b < D; b++) total[VOIGT[a][b]] += 0.5 * rows[Blocks<D>::at(b, a)];
    }
    return total;
  });
}

// sum of f_ij (x) x_ij

template <int D> Several<D> EulerianSweeps<D>::row_virial(int i) const
{
  const Motion<D> own(kin(i));
  Several<D> sum = Several<D>::zero();
  for (int k = 0; k < pairs.count[i]; k++) {
    const int pair = pairs.first[i] + k;
    const Motion<D> d = own - Motion<D>(kin(pairs.j[pair]));
    Pack force = pair_force(i, pair, d);
    if (k < pairs.nearest[i]) force += near_force(i, pairs.j[pair], pairs.near_first[i] + k, d);
    add_outer(sum, force, d.spread_x());
  }
  return sum;
}

// forces of a pair on i without the correction, expanded

template <int D>
inline Pack EulerianSweeps<D>::pair_force(int i, int pair, const Motion<D> &d) const
{
  const double *si = str(i), *sj = str(pairs.j[pair]);
  Several<D> T = load_tensor<D>(si) + load_tensor<D>(sj);
  if (opt.tensile)
    T = T + (load_tensor<D>(si + extra(0)) + load_tensor<D>(sj + extra(0))) * Pack(crowd[pair]);
  const Several<D> g =
      d.spread_x() * Pack(unit_factor * si[Str::K] * sj[Str::K] * pairs.factor[pair]);
  return expanded<D>(times(T, g)) - Pack(whole_pull(i, pair)) * d.expanded_x();
}

// what the correction puts on i for its nearest neighbor j, number `near` of all, expanded

template <int D>
inline Pack EulerianSweeps<D>::near_force(int i, int j, int near, const Motion<D> &d) const
{
  const double half = 0.5 * kin(i)[Kin::MASS];
  if (safe()) return Pack(half * near_pull[near]) * d.expanded_x();
  const Pack difference = load_expanded<D>(Addresses(da(i))) - load_expanded<D>(Addresses(da(j)));
  return Pack(half * near_weight[near]) * difference;
}

}    // namespace

#endif
