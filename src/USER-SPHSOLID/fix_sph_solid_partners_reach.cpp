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

// Stretched pairs: the ghost cutoff follows the largest distance of partners

#include "fix_sph_solid_partners.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix_sph_solid.h"
#include "neighbor.h"
#include "pair_sph_solid.h"
#include "sph_solid_sweeps.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// when partners outgrow the ghost cutoff, it grows by this much more than needed
static constexpr double MORE_THAN_NEEDED = 1.25;

/* ---------------------------------------------------------------------- */

double FixSPHSolidPartners::largest_distance() const
{
  double mine = 0.0, all = 0.0;
  for (const int i : own)
    for (int k = 0; k < count[i]; k++) {
      const double r2 = SPHSolid::square_of_distance(atom->x[i], atom->x[row[i][k]]);
      if (!(r2 <= mine)) require_near(i, row[i][k]);    // no ghost cutoff reaches further
      mine = std::max(mine, r2);
    }
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return std::sqrt(all);
}

// the same without ghosts: who has a particle that is a partner elsewhere tells where it is

double FixSPHSolidPartners::largest_distance_by_id() const
{
  const std::vector<tagint> all = partners_elsewhere();
  const std::size_t n = all.size();
  std::vector<double> mine(4 * n, 0.0), places(4 * n, 0.0);    // the fourth: is there one?
  for (std::size_t k = 0; k < n; k++) {
    const int i = where_own(all[k]);
    if (i < 0) continue;
    std::copy(atom->x[i], atom->x[i] + 3, &mine[4 * k]);
    mine[4 * k + 3] = 1.0;
  }
  MPI_Allreduce(mine.data(), places.data(), static_cast<int>(4 * n), MPI_DOUBLE, MPI_SUM, world);

  double most = 0.0, most_all = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < npartner[i]; k++) {
      const tagint of = partner[i][k];
      const int j = where_own(of);
      const double *place = j >= 0 ? atom->x[j] : nullptr;
      if (!place) {
        const auto at = std::lower_bound(all.begin(), all.end(), of) - all.begin();
        if (places[4 * at + 3] == 0.0) continue;    // it has been deleted
        place = &places[4 * at];
      }
      most = std::max(most, square_of_nearest(atom->x[i], place));
    }
  MPI_Allreduce(&most, &most_all, 1, MPI_DOUBLE, MPI_MAX, world);
  return std::sqrt(most_all);
}

// of the nearest images

double FixSPHSolidPartners::square_of_nearest(const double *a, const double *b) const
{
  double r2 = 0.0;
  for (int d = 0; d < 3; d++) {
    double apart = a[d] - b[d];
    if (domain->periodicity[d]) apart -= domain->prd[d] * std::rint(apart / domain->prd[d]);
    r2 += apart * apart;
  }
  return r2;
}

bool FixSPHSolidPartners::follows_partners() const
{
  if (kept_ledger) return false;
  return comm->nprocs > 1 || periodic();
}

void FixSPHSolidPartners::enlarge_ghost_cutoff(double distance)
{
  distance += 0.5 * neighbor->skin;    // ghosts lag one step
  if (distance < comm->get_comm_cutoff() || !std::isfinite(distance)) return;
  comm->cutghostuser = MORE_THAN_NEEDED * distance;
  reach_is_new = true;
  if (comm->me == 0)
    utils::logmesg(lmp,
                   "sph/solid: ghost cutoff enlarged to {:.6g} in step {}: partners have moved "
                   "apart\n",
                   comm->cutghostuser, update->ntimestep);
}

// the next borders have to reach the partners as they are now, and the bins the ghosts that come.
// Heat on the way goes to ghosts of the last borders, which Comm forgets

void FixSPHSolidPartners::pre_exchange()
{
  if (!follows_partners()) return;
  // rows are no longer right where others came first
  enlarge_ghost_cutoff(FixSPHSolid::exchanged_before(lmp, this) ? largest_distance_by_id()
                                                                : largest_distance());
  if (!reach_is_new) return;
  if (auto *pair = PairSPHSolid::ready(lmp)) pair->add_left_heat();
  reach_is_new = false;
  comm->setup();
  if (neighbor->style) neighbor->setup_bins();
}

void FixSPHSolidPartners::post_run()
{
  if (follows_partners()) enlarge_ghost_cutoff(largest_distance());
}

// before the first borders of a run: partners may have come apart by a command, or on the one rank
// of the run that wrote the restart file

void FixSPHSolidPartners::setup_pre_exchange()
{
  if (follows_partners()) enlarge_ghost_cutoff(largest_distance_by_id());
  reach_is_new = false;    // the setup goes on with that of Comm
}
