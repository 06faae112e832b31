/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// The largest time step that the reference configuration bears, for fix sph/solid/dt auto

#include "pair_sph_solid.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix_sph_solid_partners.h"
#include "force.h"
#include "sph_solid_fingerprint.h"
#include "sph_solid_ranks.h"
#include "sph_solid_sweeps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace LAMMPS_NS;
using namespace SPHSolid;

// Kick and drift, central differences, are stable up to dt = 2/omega, omega the highest frequency of a body (Belytschko, Liu &
// Moran, Nonlinear Finite Elements for Continua and Structures, 2000, chapter 6).  Inside a
// lattice it is that of a wave of two or three spacings, which bears 1.8 to 2 h/c_L; corners, edges
// and thin parts, where the gradient correction is large, and a light material on a heavy one bear
// less: 0.4 to 1.6

// this share of 2/omega: hourglass damping takes up to a tenth of it, plastic flow gives more
static constexpr double SAFETY = 0.85;

// power iteration: at least and at most so many times, or until so many times have added less
static constexpr int LEAST_ITERATIONS = 20, MOST_ITERATIONS = 200, LOOK_BACK = 5;
static constexpr double CONVERGED = 2.0e-3;

// once for the same bodies: commands between runs may delete some, give others another mass or type, or
// take a symmetry plane away

void PairSPHSolid::find_courant_number()
{
  const std::uint64_t mark = mark_of_bodies();
  if (mark == resonance_of) return;
  measure_resonance();
  resonance_of = mark;
}

std::uint64_t PairSPHSolid::mark_of_bodies() const
{
  auto add = [this](Fingerprint &print, int i) {
    for (const double value : {atom->rmass[i], atom->vfrac[i]}) print.add(value);
    print.add(atom->type[i]);
  };
  Fingerprint with_changes(fingerprint_of_particles(atom->nlocal, atom->tag, world, add));
  with_changes.add(partners->changes());
  for (const Plane &plane : sweeps->images.all_planes()) {
    with_changes.add(plane.dim);
    with_changes.add(plane.position);
  }
  return with_changes.value() | 1;
}

/* ----------------------------------------------------------------------
   The highest frequency of small elastic vibrations about the reference: omega^2 is the largest
   eigenvalue of u -> -f(u)/m, f the forces that displacements u cause
------------------------------------------------------------------------- */

void PairSPHSolid::measure_resonance()
{
  const int n = atom->nlocal;
  std::vector<double> u(3 * n, 0.0), force(3 * n);
  for (int i = 0; i < n; i++) start_vibration(i, &u[3 * i]);

  std::vector<double> rates;
  double norm = vibration_norm(u);
  while (norm > 0.0 && static_cast<int>(rates.size()) < MOST_ITERATIONS) {
    for (double &value : u) value /= norm;
    elastic_forces(u, force);
    for (int i = 0; i < n; i++)
      for (int k = 0; k < 3; k++)
        u[3 * i + k] = has_material(i) ? force[3 * i + k] / atom->rmass[i] : 0.0;
    norm = vibration_norm(u);
    rates.push_back(norm);
    const int done = static_cast<int>(rates.size());
    if (done < LEAST_ITERATIONS) continue;
    if (rates[done - 1] < (1.0 + CONVERGED) * rates[done - 1 - LOOK_BACK]) break;
  }
  take_courant_number(norm);
}

// anything with a share of all vibrations, the same on any number of ranks

void PairSPHSolid::start_vibration(int i, double *u) const
{
  Fingerprint random(static_cast<std::uint64_t>(atom->tag[i]));
  for (int k = 0; k < domain->dimension; k++) {
    random.add(k + 1.0);
    u[k] = static_cast<double>(random.value() >> 11) / 9007199254740992.0 - 0.5;
  }
}

double PairSPHSolid::vibration_norm(const std::vector<double> &u) const
{
  double mine = 0.0, all = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    if (has_material(i))
      for (int k = 0; k < 3; k++) mine += atom->rmass[i] * u[3 * i + k] * u[3 * i + k];
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return std::sqrt(all);
}

void PairSPHSolid::elastic_forces(const std::vector<double> &u, std::vector<double> &f)
{
  Particles p = particles();
  std::vector<double *> rows(atom->nlocal + 1);
  std::vector<const double *> displacements(atom->nlocal + 1);
  for (int i = 0; i < atom->nlocal; i++) {
    rows[i] = &f[3 * i];
    displacements[i] = &u[3 * i];
  }
  p.f = rows.data();
  std::fill(f.begin(), f.end(), 0.0);
  sweeps->displace(displacements.data());
  displacement_time = 0.0;
  forward(Message::DISPLACEMENT);
  sweeps->elastic_stress(p);
  forward(Message::STRESS);
  sweeps->mirror_stress();
  sweeps->elastic_force(p);
}

// rate: omega^2.  In three digits, so that it does not depend on the order of sums

void PairSPHSolid::take_courant_number(double rate)
{
  Range mine;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!has_material(i)) continue;
    const TypeData &type = types[atom->type[i]];
    // with the density that the particle has in the reference, as time_step_limit() has it
    const double share = reference_density(atom->rmass[i], atom->vfrac[i]) / type.material.rho0;
    mine.add(type.h * std::sqrt(share) / type.material.longitudinal_speed());
  }
  const Range h_over_c = over_ranks(mine, world);
  const double stable = 2.0 / (std::sqrt(rate * force->ftm2v) * h_over_c.least);
  const double taken = std::floor(1000.0 * SAFETY * stable) / 1000.0;
  courant_number = LARGEST_COURANT_NUMBER;
  limit_factors.clear();
  if (std::isfinite(stable)) {
    courant_number = std::min(courant_number, taken);
    if (h_over_c.wide()) find_limit_factors(taken / courant_number * h_over_c.least);
  }
  if (comm->me == 0 && std::isfinite(stable))
    utils::logmesg(lmp,
                   "sph/solid: the reference is stable up to a Courant number of {:.4g}, fix "
                   "sph/solid/dt auto takes {:.4g}\n",
                   stable, courant_number);
}

// Where materials differ nobody knows which of them vibrates fastest: it may be one that does not have
// the least h/c.  So the step becomes shorter by as much as any particle's own h/c has become less than it
// was in the reference: limits are multiplied by the least h/c over their own, h sqrt(m/V)/sqrt(K + 4/3 mu)

void PairSPHSolid::find_limit_factors(double h_over_c)
{
  for (int t = 0; t <= atom->ntypes; t++) {
    const Material &m = types[t].material;
    const bool used = t > 0 && setflag[t][t];
    limit_factors.push_back(
        used ? h_over_c * std::sqrt(m.rho0) * m.longitudinal_speed() / types[t].h : 0.0);
  }
}

double PairSPHSolid::usual_time_step_limit() const
{
  if (!partners || limit_factors.empty()) return time_step_limit();
  return sweeps->scaled_time_step_limit(particles(), limit_factors);
}
