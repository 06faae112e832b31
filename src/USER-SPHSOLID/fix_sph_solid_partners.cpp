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

#include "fix_sph_solid_partners.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_sph_solid.h"
#include "memory.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "sph_solid_fingerprint.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

// when partners outgrow the ghost cutoff, it grows by this much more than needed
static constexpr double COVER_MORE = 1.25;

// partners may be so much of a periodic box apart
static constexpr double LARGEST_SHARE = 0.45;

// lengths are the same if they differ by less than this share: input scripts round them
static constexpr double SAME = 1.0e-6;

static bool same(double a, double b)
{
  return std::fabs(a - b) <= SAME * std::max(a, b);
}

/* ---------------------------------------------------------------------- */

FixSPHSolidPartners::FixSPHSolidPartners(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), xref(nullptr), vref(nullptr), gone(nullptr), npartner(nullptr),
    self(nullptr), partner(nullptr), href(nullptr), dim(domain->dimension)
{
  restart_peratom = 1;
  restart_global = 1;
  create_attribute = 1;
  stores_ids = 1;
  comm_border = comm_forward = dim + 1;
  maxexchange_dynamic = 1;
  maxpartner = nchanges = 0;
  nlocal = -1;
  seen = 0;

  grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
  atom->add_callback(Atom::BORDER);
  for (int i = 0; i < atom->nlocal; i++) set_arrays(i);
}

FixSPHSolidPartners::~FixSPHSolidPartners()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  atom->delete_callback(id, Atom::BORDER);
  memory->destroy(xref);
  memory->destroy(vref);
  memory->destroy(npartner);
  memory->destroy(self);
  memory->destroy(partner);
  memory->destroy(href);
  if (gone) *gone = true;
}

int FixSPHSolidPartners::setmask()
{
  return PRE_EXCHANGE;
}

void FixSPHSolidPartners::init()
{
  if (periodic() && domain->triclinic)
    error->all(FLERR, "sph/solid, frame lagrangian: a triclinic box cannot be periodic");
  if (periodic() && FixSPHSolid::drives_box(lmp))
    error->all(FLERR, "sph/solid, frame lagrangian: a periodic box cannot change its size");

  if (comm->mode != Comm::SINGLE)
    error->all(FLERR,
               "sph/solid, frame lagrangian: ghosts have to reach the partners, as far as they are "
               "apart: expected comm_modify mode single, found multi");

  // after a restart every rank knows its own rows only
  int all;
  MPI_Allreduce(&maxpartner, &all, 1, MPI_INT, MPI_MAX, world);
  widen(all);
}

bool FixSPHSolidPartners::periodic() const
{
  return domain->xperiodic || domain->yperiodic || (domain->dimension == 3 && domain->zperiodic);
}

// more columns for IDs; tells Comm what to expect

void FixSPHSolidPartners::widen(int n)
{
  if (n > maxpartner) {
    tagint **wider;
    memory->create(wider, atom->nmax, n, "sph/solid:partner");
    for (int i = 0; i < atom->nlocal; i++)
      for (int k = 0; k < npartner[i]; k++) wider[i][k] = partner[i][k];
    memory->destroy(partner);
    partner = wider;
    maxpartner = n;
  }
  maxexchange = maxpartner + 4 + dim;
}

void FixSPHSolidPartners::forget(int groupbit)
{
  bool cut = false;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < npartner[i]; k++) {
      const int j = where(partner[i][k]);
      if (j >= 0 && ((atom->mask[i] ^ atom->mask[j]) & groupbit)) cut = true;
    }
  if (on_any_rank(cut))
    error->all(FLERR,
               "Fix_modify reference renew: the group of the fix ends inside a body: expected "
               "whole bodies");
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) npartner[i] = -1;
}

bool FixSPHSolidPartners::on_any_rank(bool here) const
{
  int mine = here ? 1 : 0, any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  return any != 0;
}

bool FixSPHSolidPartners::anyone_without() const
{
  bool without = false;
  for (int i = 0; i < atom->nlocal; i++)
    if (npartner[i] < 0) without = true;
  return on_any_rank(without);
}

/* ----------------------------------------------------------------------
   between runs commands can change what partners rely on
------------------------------------------------------------------------- */

void FixSPHSolidPartners::require_same(const std::vector<double> &h)
{
  for (int i = 0; i < atom->nlocal; i++)
    if (npartner[i] > 0 && self[i] != atom->tag[i])
      error->one(FLERR, Error::NOLASTLINE,
                 "sph/solid, frame lagrangian: particle {} has been particle {} in the reference, "
                 "and its partners are known by their IDs: expected IDs that stay (delete_atoms "
                 "... compress no, no reset_atoms id)",
                 atom->tag[i], self[i]);

  // of particles, and not of types: they can get another type as well
  bool partners = false;
  for (int i = 0; i < atom->nlocal; i++) {
    if (npartner[i] <= 0) continue;
    partners = true;
    const int t = atom->type[i];
    if (!same(h[t], href[i]))
      error->one(FLERR, Error::NOLASTLINE,
                 "sph/solid, frame lagrangian: the smoothing length of type {} is {:.6g} and was "
                 "{:.6g} in the reference of its particle {}: expected the same, or fix_modify ... "
                 "reference renew",
                 t, h[t], href[i], atom->tag[i]);
  }

  std::vector<double> now(3, 0.0);
  for (int d = 0; d < domain->dimension; d++)
    if (domain->periodicity[d]) now[d] = domain->prd[d];
  if (!on_any_rank(partners) || lengths.size() != now.size()) lengths = now;
  for (int d = 0; d < 3; d++)
    if (!same(now[d], lengths[d]))
      error->all(FLERR, Error::NOLASTLINE,
                 "sph/solid, frame lagrangian: the length of the box along {} (0: not periodic) is "
                 "{:.8g} and was {:.8g} in the reference: expected the same, or fix_modify ... "
                 "reference renew",
                 "xyz"[d], now[d], lengths[d]);
}

/* ----------------------------------------------------------------------
   the present configuration becomes the reference of all particles that have
   none: partners are all others of them inside the kernel
------------------------------------------------------------------------- */

void FixSPHSolidPartners::refer(NeighList *list, double **cutsq, int **setflag,
                                const std::vector<double> &h)
{
  drop_reused_ids();
  nchanges++;

  // which ghosts are without a reference travels as a negative volume
  for (int i = 0; i < atom->nlocal; i++) {
    if (npartner[i] >= 0) continue;
    for (int k = 0; k < dim; k++) xref[i][k] = atom->x[i][k];
    const int t = atom->type[i];
    vref[i] = setflag[t][t] ? -atom->rmass[i] / atom->rho[i] : 0.0;
  }
  comm->forward_comm(this);

  // twice, since all lists of IDs together would be the largest array of the setup
  std::vector<tagint> found;
  int most = maxpartner, all;
  for (int ii = 0; ii < list->inum; ii++) {
    if (!needs_reference(list->ilist[ii], setflag)) continue;
    present_partners(list, ii, cutsq, found);
    most = std::max(most, static_cast<int>(found.size()));
  }
  MPI_Allreduce(&most, &all, 1, MPI_INT, MPI_MAX, world);
  widen(all);
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    if (!needs_reference(i, setflag)) continue;
    present_partners(list, ii, cutsq, found);
    std::copy(found.begin(), found.end(), partner[i]);
    npartner[i] = static_cast<int>(found.size());
    self[i] = atom->tag[i];
    href[i] = static_cast<float>(h[atom->type[i]]);
  }
  for (int i = 0; i < atom->nlocal; i++) npartner[i] = std::max(npartner[i], 0);
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) vref[i] = std::fabs(vref[i]);
}

bool FixSPHSolidPartners::needs_reference(int i, int **setflag) const
{
  return npartner[i] < 0 && setflag[atom->type[i]][atom->type[i]];
}

// IDs of those inside the kernel of an entry of the list that are without reference as well

void FixSPHSolidPartners::present_partners(NeighList *list, int ii, double **cutsq,
                                           std::vector<tagint> &found) const
{
  const int i = list->ilist[ii];
  found.clear();
  for (int jj = 0; jj < list->numneigh[i]; jj++) {
    const int j = list->firstneigh[i][jj] & NEIGHMASK;
    double r2 = 0.0;
    for (int k = 0; k < 3; k++)
      r2 += (atom->x[i][k] - atom->x[j][k]) * (atom->x[i][k] - atom->x[j][k]);
    if (!(vref[j] < 0.0 && r2 < cutsq[atom->type[i]][atom->type[j]])) continue;
    if (r2 == 0.0)
      error->one(FLERR, Error::NOLASTLINE,
                 "sph/solid, frame lagrangian: particles {} and {} lie at the same place {:.8g} "
                 "{:.8g} {:.8g}",
                 atom->tag[i], atom->tag[j], atom->x[i][0], atom->x[i][1], atom->x[i][2]);
    found.push_back(atom->tag[j]);
  }
  std::sort(found.begin(), found.end());
  if (std::adjacent_find(found.begin(), found.end()) != found.end())
    error->one(FLERR, Error::NOLASTLINE,
               "sph/solid, frame lagrangian: particle {} sees the same partner twice: the periodic "
               "box must be longer than two ranges of the kernel",
               atom->tag[i]);
}

/* ----------------------------------------------------------------------
   where the partners are now
------------------------------------------------------------------------- */

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

// a quarter of the memory of a particle's partners, kept only for cover()

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

// local index of an ID, or -1: Atom::map() looks no further than the largest ID there is

int FixSPHSolidPartners::where(tagint of) const
{
  return of < atom->get_map_size() ? atom->map(of) : -1;
}

// of two partners half a box apart nobody knows which image is the one that the material connects

int FixSPHSolidPartners::near_image(int i, int j) const
{
  const int image = domain->closest_image(i, j);
  const double *a = atom->x[i], *b = atom->x[image];
  for (int d = 0; d < domain->dimension; d++)
    if (domain->periodicity[d] && std::fabs(a[d] - b[d]) > LARGEST_SHARE * domain->prd[d])
      error->one(FLERR, Error::NOLASTLINE,
                 "sph/solid, frame lagrangian: particles {} and {} are partners and {:.6g} apart "
                 "in step {}, nearly half the periodic box: expected one longer than {:.6g}",
                 atom->tag[i], atom->tag[j], std::fabs(a[d] - b[d]), update->ntimestep,
                 std::fabs(a[d] - b[d]) / LARGEST_SHARE);
  return image;
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
  bool any = false;
  for (int i = 0; i < atom->nlocal; i++)
    if (npartner[i] > 0) any = true;
  if (!on_any_rank(any)) return;    // as in a first run

  std::vector<tagint> own_new, reused;
  for (int i = 0; i < atom->nlocal; i++)
    if (npartner[i] < 0) own_new.push_back(atom->tag[i]);
  std::vector<tagint> all_new = of_all_ranks(own_new);
  std::sort(all_new.begin(), all_new.end());
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < npartner[i]; k++)
      if (std::binary_search(all_new.begin(), all_new.end(), partner[i][k]))
        reused.push_back(partner[i][k]);
  std::vector<tagint> gone = of_all_ranks(reused);
  if (!gone.empty()) drop(gone);
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
  for (int k = 0; k < total; k++) {
    const int i = where(all[k]);
    have[k] = (i >= 0 && i < atom->nlocal) ? 1 : 0;
  }
  MPI_Allreduce(have.data(), anyone.data(), total, MPI_INT, MPI_MAX, world);
  std::vector<tagint> gone;
  for (int k = 0; k < total; k++) {
    if (anyone[k])
      error->all(
          FLERR, Error::NOLASTLINE,
          "sph/solid, frame lagrangian: particle {} lies further away from a partner than the "
          "ghost cutoff: expected a line like comm_modify cutoff {:.6g}",
          all[k], 2.0 * comm->get_comm_cutoff());
    gone.push_back(all[k]);
  }
  drop(gone);
}

// particles of these IDs, the same list on every rank, are partners of nobody any more

void FixSPHSolidPartners::drop(std::vector<tagint> &gone)
{
  nchanges++;
  std::sort(gone.begin(), gone.end());
  gone.erase(std::unique(gone.begin(), gone.end()), gone.end());
  for (int i = 0; i < atom->nlocal; i++) {
    int kept = 0;
    for (int k = 0; k < npartner[i]; k++)
      if (!std::binary_search(gone.begin(), gone.end(), partner[i][k]))
        partner[i][kept++] = partner[i][k];
    if (npartner[i] > 0) npartner[i] = kept;
  }
  if (comm->me == 0)
    utils::logmesg(lmp, "sph/solid: {} particles are gone, their partners go on without them\n",
                   gone.size());
}

/* ----------------------------------------------------------------------
   stretched pairs: the ghost cutoff follows the largest distance of partners
------------------------------------------------------------------------- */

double FixSPHSolidPartners::largest_distance() const
{
  double mine = 0.0, all = 0.0;
  for (const int i : own)
    for (int k = 0; k < count[i]; k++) {
      const double *a = atom->x[i], *b = atom->x[row[i][k]];
      double r2 = 0.0;
      for (int d = 0; d < 3; d++) r2 += (a[d] - b[d]) * (a[d] - b[d]);
      mine = std::max(mine, r2);
    }
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return std::sqrt(all);
}

// the same without ghosts: who has a particle that is a partner elsewhere tells where it is

double FixSPHSolidPartners::largest_distance_by_id() const
{
  auto own_of = [this](tagint of) {
    const int i = where(of);
    return i < atom->nlocal ? i : -1;
  };
  auto once = [](std::vector<tagint> &ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  };
  std::vector<tagint> wanted;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < npartner[i]; k++)
      if (own_of(partner[i][k]) < 0) wanted.push_back(partner[i][k]);
  once(wanted);
  std::vector<tagint> all = of_all_ranks(wanted);
  once(all);

  const std::size_t n = all.size();
  std::vector<double> mine(4 * n, 0.0), places(4 * n, 0.0);    // the fourth: is there one?
  for (std::size_t k = 0; k < n; k++) {
    const int i = own_of(all[k]);
    if (i < 0) continue;
    std::copy(atom->x[i], atom->x[i] + 3, &mine[4 * k]);
    mine[4 * k + 3] = 1.0;
  }
  MPI_Allreduce(mine.data(), places.data(), static_cast<int>(4 * n), MPI_DOUBLE, MPI_SUM, world);

  double most = 0.0, most_all = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < npartner[i]; k++) {
      const tagint of = partner[i][k];
      const int j = own_of(of);
      const double *place = j >= 0 ? atom->x[j] : nullptr;
      if (!place) {
        const auto at = std::lower_bound(all.begin(), all.end(), of) - all.begin();
        if (places[4 * at + 3] == 0.0) continue;    // it has been deleted
        place = &places[4 * at];
      }
      most = std::max(most, square_of_distance(atom->x[i], place));
    }
  MPI_Allreduce(&most, &most_all, 1, MPI_DOUBLE, MPI_MAX, world);
  return std::sqrt(most_all);
}

// of the nearest images

double FixSPHSolidPartners::square_of_distance(const double *a, const double *b) const
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
  return comm->nprocs > 1 || periodic();
}

void FixSPHSolidPartners::cover(double distance)
{
  distance += 0.5 * neighbor->skin;    // ghosts lag one step
  if (distance < comm->get_comm_cutoff()) return;
  comm->cutghostuser = COVER_MORE * distance;
  if (comm->me == 0)
    utils::logmesg(lmp,
                   "sph/solid: ghost cutoff enlarged to {:.6g} in step {}: partners have moved "
                   "apart\n",
                   comm->cutghostuser, update->ntimestep);
}

// the next borders have to reach the partners as they are now, and the bins the ghosts that come

void FixSPHSolidPartners::pre_exchange()
{
  if (!follows_partners()) return;
  const double before = comm->cutghostuser;
  cover(largest_distance());
  if (comm->cutghostuser == before) return;
  comm->setup();
  if (neighbor->style) neighbor->setup_bins();
}

void FixSPHSolidPartners::post_run()
{
  if (follows_partners()) cover(largest_distance());
}

// before the first borders of a run: partners may have come apart by a command, or on the one rank
// of the run that wrote the restart file

void FixSPHSolidPartners::setup_pre_exchange()
{
  if (follows_partners()) cover(largest_distance_by_id());
}

/* ----------------------------------------------------------------------
   per-atom data
------------------------------------------------------------------------- */

void FixSPHSolidPartners::grow_arrays(int nmax)
{
  memory->grow(npartner, nmax, "sph/solid:npartner");
  memory->grow(self, nmax, "sph/solid:self");
  memory->grow(partner, nmax, maxpartner, "sph/solid:partner");
  memory->grow(href, nmax, "sph/solid:href");
  memory->grow(xref, nmax, dim, "sph/solid:xref");
  memory->grow(vref, nmax, "sph/solid:vref");
}

void FixSPHSolidPartners::copy_arrays(int i, int j, int)
{
  npartner[j] = npartner[i];
  self[j] = self[i];
  href[j] = href[i];
  for (int k = 0; k < npartner[i]; k++) partner[j][k] = partner[i][k];
  for (int k = 0; k < dim; k++) xref[j][k] = xref[i][k];
  vref[j] = vref[i];
}

void FixSPHSolidPartners::set_arrays(int i)
{
  npartner[i] = -1;
  self[i] = 0;
  href[i] = 0.0f;
  for (int k = 0; k < dim; k++) xref[i][k] = 0.0;
  vref[i] = 0.0;
}

int FixSPHSolidPartners::pack_row(int i, double *buf) const
{
  int m = 0;
  buf[m++] = ubuf(npartner[i]).d;
  buf[m++] = ubuf(self[i]).d;
  buf[m++] = href[i];
  for (int k = 0; k < npartner[i]; k++) buf[m++] = ubuf(partner[i][k]).d;
  for (int k = 0; k < dim; k++) buf[m++] = xref[i][k];
  buf[m++] = vref[i];
  return m;
}

int FixSPHSolidPartners::unpack_row(int i, const double *buf)
{
  int m = 0;
  npartner[i] = static_cast<int>(ubuf(buf[m++]).i);
  self[i] = static_cast<tagint>(ubuf(buf[m++]).i);
  href[i] = static_cast<float>(buf[m++]);
  for (int k = 0; k < npartner[i]; k++) partner[i][k] = static_cast<tagint>(ubuf(buf[m++]).i);
  for (int k = 0; k < dim; k++) xref[i][k] = buf[m++];
  vref[i] = buf[m++];
  return m;
}

int FixSPHSolidPartners::pack_exchange(int i, double *buf)
{
  return pack_row(i, buf);
}

int FixSPHSolidPartners::unpack_exchange(int i, double *buf)
{
  return unpack_row(i, buf);
}

int FixSPHSolidPartners::pack_border(int n, int *list, double *buf)
{
  return pack_forward_comm(n, list, buf, 0, nullptr);
}

int FixSPHSolidPartners::unpack_border(int n, int first, double *buf)
{
  unpack_forward_comm(n, first, buf);
  return (dim + 1) * n;
}

int FixSPHSolidPartners::pack_forward_comm(int n, int *list, double *buf, int, int *)
{
  int m = 0;
  for (int k = 0; k < n; k++) {
    const int i = list[k];
    for (int d = 0; d < dim; d++) buf[m++] = xref[i][d];
    buf[m++] = vref[i];
  }
  return m;
}

void FixSPHSolidPartners::unpack_forward_comm(int n, int first, double *buf)
{
  int m = 0;
  for (int i = first; i < first + n; i++) {
    for (int d = 0; d < dim; d++) xref[i][d] = buf[m++];
    vref[i] = buf[m++];
  }
}

/* ----------------------------------------------------------------------
   restart: the length, then a row
------------------------------------------------------------------------- */

int FixSPHSolidPartners::size_restart(int i)
{
  return 5 + dim + std::max(npartner[i], 0);
}

int FixSPHSolidPartners::maxsize_restart()
{
  return 5 + dim + maxpartner;
}

int FixSPHSolidPartners::pack_restart(int i, double *buf)
{
  buf[0] = size_restart(i);
  pack_row(i, buf + 1);
  return size_restart(i);
}

void FixSPHSolidPartners::unpack_restart(int i, int nth)
{
  double *extra = atom->extra[i];
  int m = 0;
  for (int k = 0; k < nth; k++) m += static_cast<int>(extra[m]);
  const int n = static_cast<int>(ubuf(extra[m + 1]).i);
  const int expected = 5 + dim + std::max(n, 0);
  if (static_cast<int>(extra[m]) != expected)
    error->one(FLERR, Error::NOLASTLINE,
               "sph/solid, frame lagrangian: the restart file has {} numbers for the reference of "
               "particle {}, expected {}: it was written by another version of the package",
               static_cast<int>(extra[m]), atom->tag[i], expected);
  widen(n);
  unpack_row(i, extra + m + 1);
}

// the lengths of the reference: their number, then they themselves

void FixSPHSolidPartners::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  std::vector<double> list(1, static_cast<double>(lengths.size()));
  list.insert(list.end(), lengths.begin(), lengths.end());
  const int size = static_cast<int>(list.size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

void FixSPHSolidPartners::restart(char *buf)
{
  double n;
  std::memcpy(&n, buf, sizeof(double));
  lengths.resize(static_cast<std::size_t>(n));
  std::memcpy(lengths.data(), buf + sizeof(double), lengths.size() * sizeof(double));
}

double FixSPHSolidPartners::memory_usage()
{
  double bytes = (double) atom->nmax *
      (sizeof(int) + sizeof(float) + (dim + 1) * sizeof(double) +
       (1 + maxpartner) * sizeof(tagint));
  bytes += (double) index.capacity() * sizeof(int) + (double) row.capacity() * sizeof(int *);
  bytes += (double) (own.capacity() + count.capacity()) * sizeof(int);
  return bytes;
}
