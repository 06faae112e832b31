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

// Where the partners of a reference are now: local indices, and what became of those that are missing

#include "fix_sph_solid_partners.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "sph_solid_fingerprint.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

static void order_once(std::vector<tagint> &ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

// partners may be so much of a periodic box apart
static constexpr double LARGEST_SHARE = 0.45;

/* ---------------------------------------------------------------------- */

void FixSPHSolidPartners::find(bool setup, int **setflag)
{
  nlocal = atom->nlocal;
  own.clear();
  index.clear();
  count.assign(nlocal, 0);
  row.assign(nlocal, nullptr);
  std::vector<int> start(nlocal, 0);
  std::vector<tagint> missing;
  std::size_t most = 0;
  for (int i = 0; i < nlocal; i++) most += std::max(npartner[i], 0);
  if (most > MAXSMALLINT)
    error->one(
        FLERR,
        "sph/solid, frame lagrangian: the particles of rank {} have {} partners, and at most "
        "{} can be counted: expected more ranks",
        comm->me, most, MAXSMALLINT);
  index.reserve(most);
  own.reserve(nlocal);
  for (int i = 0; i < nlocal; i++) {
    if (!setflag[atom->type[i]][atom->type[i]]) continue;
    own.push_back(i);
    start[i] = static_cast<int>(index.size());
    for (int k = 0; k < npartner[i]; k++) {
      const int j = where(partner[i][k]);
      if (j < 0)
        missing.push_back(partner[i][k]);
      else
        index.push_back(near_image(i, j));
    }
    count[i] = static_cast<int>(index.size()) - start[i];
  }
  for (const int i : own) row[i] = index.data() + start[i];
  resolve_missing(missing, setup);
  seen = fingerprint_of_ids();
}

// after find(): a symmetry plane may have come that is behind the body, and not behind its reference

void FixSPHSolidPartners::require_on_one_side(int d, double plane, double tolerance) const
{
  const tagint *tag = atom->tag;
  for (const int i : own)
    for (int k = 0; k < count[i]; k++) {
      const int j = row[i][k];
      const double a = xref[i][d] - plane, b = xref[j][d] - plane;
      if (a < -tolerance && b > tolerance)
        error->one(
            FLERR, Error::NOLASTLINE,
            "sph/solid, frame lagrangian: the symmetry plane {} = {} passes between partners "
            "{} and {} as they lie in the reference: expected one beside the body, or "
            "fix_modify ... reference renew",
            "xyz"[d], plane, tag[i], tag[j]);
    }
}

// a quarter of the memory of a particle's partners, kept only for enlarge_ghost_cutoff()

bool FixSPHSolidPartners::forget_rows()
{
  if (follows_partners()) return false;
  for (std::vector<int> *of : {&count, &index}) std::vector<int>().swap(*of);
  std::vector<int *>().swap(row);
  return true;
}

bool FixSPHSolidPartners::in_place() const
{
  return !periodic() && atom->nlocal == nlocal && seen == fingerprint_of_ids();
}

std::uint64_t FixSPHSolidPartners::fingerprint_of_ids() const
{
  const int n = atom->nlocal + atom->nghost;
  SPHSolid::Fingerprint print(n);
  for (int i = 0; i < n; i++) print.add(static_cast<double>(atom->tag[i]));
  return print.value();
}

// local index of an ID, or -1.  An array, and no other map, ends with the largest ID that there was when
// it was made

int FixSPHSolidPartners::where(tagint of) const
{
  if (atom->map_style == Atom::MAP_ARRAY && of >= atom->get_map_size()) return -1;
  return atom->map(of);
}

// the same of own particles only

int FixSPHSolidPartners::where_own(tagint of) const
{
  const int i = where(of);
  return i < atom->nlocal ? i : -1;
}

// IDs of partners that are not on the rank of the particle whose partners they are, of all ranks, ascending

std::vector<tagint> FixSPHSolidPartners::partners_elsewhere() const
{
  std::vector<tagint> mine;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < npartner[i]; k++)
      if (where_own(partner[i][k]) < 0) mine.push_back(partner[i][k]);
  order_once(mine);
  std::vector<tagint> all = of_all_ranks(mine);
  order_once(all);
  return all;
}

// of two partners half a box apart nobody knows which image is the one that the material connects

int FixSPHSolidPartners::near_image(int i, int j) const
{
  const int image = domain->closest_image(i, j);
  require_near(i, image);
  return image;
}

void FixSPHSolidPartners::require_near(int i, int image) const
{
  const double *a = atom->x[i], *b = atom->x[image];
  for (int d = 0; d < domain->dimension; d++)
    if (domain->periodicity[d] && !(std::fabs(a[d] - b[d]) <= LARGEST_SHARE * domain->prd[d]))
      error->one(FLERR, Error::NOLASTLINE,
                 "sph/solid, frame lagrangian: particle {} at {:.8g} {:.8g} {:.8g} and its partner "
                 "{} are {:.6g} apart in step {}, nearly half the periodic box: expected one "
                 "longer than {:.6g}, or a shorter time step if they should be near",
                 atom->tag[i], a[0], a[1], a[2], atom->tag[image], std::fabs(a[d] - b[d]),
                 update->ntimestep, std::fabs(a[d] - b[d]) / LARGEST_SHARE);
}

std::vector<tagint> FixSPHSolidPartners::of_all_ranks(std::vector<tagint> &mine) const
{
  int n = static_cast<int>(mine.size());
  std::vector<int> sizes(comm->nprocs), starts(comm->nprocs, 0);
  MPI_Allgather(&n, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  for (int k = 1; k < comm->nprocs; k++) starts[k] = starts[k - 1] + sizes[k - 1];
  std::vector<tagint> all(starts.back() + sizes.back());
  MPI_Allgatherv(mine.data(), n, MPI_LMP_TAGINT, all.data(), sizes.data(), starts.data(),
                 MPI_LMP_TAGINT, world);
  return all;
}

// particles have been deleted, and new ones have got their IDs

void FixSPHSolidPartners::drop_reused_ids()
{
  std::vector<tagint> own_new, reused;
  for (int i = 0; i < atom->nlocal; i++)
    if (npartner[i] < 0) own_new.push_back(atom->tag[i]);
  std::vector<tagint> all_new = of_all_ranks(own_new);
  std::sort(all_new.begin(), all_new.end());
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < npartner[i]; k++)
      if (std::binary_search(all_new.begin(), all_new.end(), partner[i][k]))
        reused.push_back(partner[i][k]);
  std::vector<tagint> ids = of_all_ranks(reused);
  if (!ids.empty()) drop(ids);
}

// a partner that is nowhere has been deleted (between runs) or lost; one that
// exists on another rank lies beyond the ghost cutoff

void FixSPHSolidPartners::resolve_missing(std::vector<tagint> &missing, bool setup)
{
  int mine = static_cast<int>(missing.size()), total = 0;
  if (comm->nprocs == 1)
    total = mine;
  else if (setup)
    MPI_Allreduce(&mine, &total, 1, MPI_INT, MPI_SUM, world);
  else if (mine)
    error->one(
        FLERR, Error::NOLASTLINE,
        "sph/solid, frame lagrangian: particle {} is a partner of one on rank {} but neither "
        "there nor among its ghosts in step {}: it is lost, or further away than the ghost "
        "cutoff: try comm_modify cutoff {:.6g}",
        missing[0], comm->me, update->ntimestep, 2.0 * comm->get_comm_cutoff());
  if (total == 0) return;
  if (!setup)
    error->one(FLERR, Error::NOLASTLINE,
               "sph/solid, frame lagrangian: particle {} has been lost by step {} and its partners "
               "cannot go on without it",
               missing[0], update->ntimestep);

  // every rank learns what is missing anywhere, and who has it
  const std::vector<tagint> all = of_all_ranks(missing);
  std::vector<int> have(total), anyone(total);
  for (int k = 0; k < total; k++) { have[k] = where_own(all[k]) >= 0 ? 1 : 0; }
  MPI_Allreduce(have.data(), anyone.data(), total, MPI_INT, MPI_MAX, world);
  std::vector<tagint> deleted;
  for (int k = 0; k < total; k++) {
    if (anyone[k])
      error->all(
          FLERR, Error::NOLASTLINE,
          "sph/solid, frame lagrangian: particle {} lies further away from a partner than the "
          "ghost cutoff: expected a line like comm_modify cutoff {:.6g}",
          all[k], 2.0 * comm->get_comm_cutoff());
    deleted.push_back(all[k]);
  }
  drop(deleted);
}

// particles of these IDs, the same list on every rank, are partners of nobody any more

void FixSPHSolidPartners::drop(std::vector<tagint> &ids)
{
  nchanges++;
  order_once(ids);
  for (int i = 0; i < atom->nlocal; i++) {
    int kept = 0;
    for (int k = 0; k < npartner[i]; k++)
      if (!std::binary_search(ids.begin(), ids.end(), partner[i][k]))
        partner[i][kept++] = partner[i][k];
    if (npartner[i] > 0) npartner[i] = kept;
  }
  if (comm->me == 0)
    utils::logmesg(lmp, "sph/solid: {} particles are gone, their partners go on without them\n",
                   ids.size());
}
