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
#include "sph_solid_ranks.h"
#include "sph_solid_sweeps.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

// lengths are the same if they differ by less than this share: input scripts round them
static constexpr double SAME = 1.0e-6;

static bool same(double a, double b)
{
  return std::fabs(a - b) <= SAME * std::max(a, b);
}

static bool any(const std::vector<int> &flags)
{
  return std::find(flags.begin(), flags.end(), 1) != flags.end();
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
  reach_is_new = false;
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
  if (kept_ledger) return;
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
  if (SPHSolid::on_any_rank(cuts_body(groupbit), world))
    error->all(FLERR,
               "Fix_modify reference renew: the group of the fix ends inside a body: expected "
               "whole bodies");
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) npartner[i] = -1;
}

// is a particle here inside of the group, and a partner outside, or the other way round?  What ghosts
// have as their groups is that of the last run

bool FixSPHSolidPartners::cuts_body(int groupbit) const
{
  enum { UNKNOWN, OUTSIDE, INSIDE };
  auto side = [this, groupbit](int i) {
    return (atom->mask[i] & groupbit) ? INSIDE : OUTSIDE;
  };
  const std::vector<tagint> others = partners_elsewhere();
  std::vector<int> mine(others.size(), UNKNOWN), all(others.size(), UNKNOWN);
  for (std::size_t k = 0; k < others.size(); k++) {
    const int i = where_own(others[k]);
    if (i >= 0) mine[k] = side(i);
  }
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(mine.size()), MPI_INT, MPI_MAX, world);

  auto side_of = [&](tagint of) -> int {
    const int j = where_own(of);
    if (j >= 0) return side(j);
    return all[std::lower_bound(others.begin(), others.end(), of) - others.begin()];
  };
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < npartner[i]; k++) {
      const int of_partner = side_of(partner[i][k]);
      if (of_partner != UNKNOWN && of_partner != side(i)) return true;    // UNKNOWN: deleted
    }
  return false;
}

bool FixSPHSolidPartners::anyone_without(int **setflag) const
{
  bool without = false;
  for (int i = 0; i < atom->nlocal; i++)
    if (needs_reference(i, setflag)) without = true;
  return SPHSolid::on_any_rank(without, world);
}

/* ----------------------------------------------------------------------
   between runs commands can change what partners rely on
------------------------------------------------------------------------- */

void FixSPHSolidPartners::require_same(const std::vector<double> &h,
                                       const std::vector<double> &reach)
{
  for (int i = 0; i < atom->nlocal; i++)
    if (npartner[i] > 0 && self[i] != atom->tag[i])
      error->one(FLERR, Error::NOLASTLINE,
                 "sph/solid, frame lagrangian: particle {} has been particle {} in the reference, "
                 "and its partners are known by their IDs: expected IDs that stay (delete_atoms "
                 "... compress no, no reset_atoms id)",
                 atom->tag[i], self[i]);

  // of particles, and not of types: they can get another type as well
  for (int i = 0; i < atom->nlocal; i++) {
    if (npartner[i] <= 0) continue;
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
  const std::vector<int> have_partners = types_with_partners();
  require_reach(reach, have_partners);
  if (!any(have_partners) || lengths.size() != now.size()) lengths = now;
  for (int d = 0; d < 3; d++)
    if (!same(now[d], lengths[d]))
      error->all(FLERR, Error::NOLASTLINE,
                 "sph/solid, frame lagrangian: the length of the box along {} (0: not periodic) is "
                 "{:.8g} and was {:.8g} in the reference: expected the same, or fix_modify ... "
                 "reference renew",
                 "xyz"[d], now[d], lengths[d]);
}

// of each type, from 1: does anyone have partners?

std::vector<int> FixSPHSolidPartners::types_with_partners() const
{
  std::vector<int> mine(atom->ntypes + 1, 0), all(mine);
  for (int i = 0; i < atom->nlocal; i++)
    if (npartner[i] > 0) mine[atom->type[i]] = 1;
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(mine.size()), MPI_INT, MPI_MAX, world);
  return all;
}

// pair_style may come again, with a correction that reaches further

void FixSPHSolidPartners::require_reach(const std::vector<double> &reach,
                                        const std::vector<int> &have_partners) const
{
  for (std::size_t t = 1; t < std::min(reach.size(), reach_then.size()); t++)
    if (have_partners[t] && reach[t] > (1.0 + SAME) * reach_then[t])
      error->all(
          FLERR, Error::NOLASTLINE,
          "sph/solid, frame lagrangian: particles of type {} reach their partners at {:.6g} "
          "and those of the reference lie within {:.6g}: expected a correction with a smaller "
          "hbar, or fix_modify ... reference renew",
          t, reach[t], reach_then[t]);
}

/* ----------------------------------------------------------------------
   the present configuration becomes the reference of all particles that have
   none: partners are all others of them inside the kernel
------------------------------------------------------------------------- */

void FixSPHSolidPartners::refer(NeighList *list, double **cutsq, int **setflag,
                                const std::vector<double> &h, const std::vector<double> &reach)
{
  // what is left of an older reference goes on with the partners that it has
  const std::vector<int> have_partners = types_with_partners();
  if (reach_then.size() != reach.size()) reach_then = reach;
  for (std::size_t t = 1; t < reach.size(); t++)
    reach_then[t] = have_partners[t] ? std::min(reach_then[t], reach[t]) : reach[t];
  if (any(have_partners)) drop_reused_ids();
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
    const double r2 = SPHSolid::square_of_distance(atom->x[i], atom->x[j]);
    const double kernel2 = cutsq[atom->type[i]][atom->type[j]];
    if (!(vref[j] < 0.0 && r2 < kernel2)) continue;
    if (SPHSolid::at_same_place(r2, kernel2))
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

int FixSPHSolidPartners::pack_exchange(int i, double *buf)
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

int FixSPHSolidPartners::unpack_exchange(int i, double *buf)
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
  pack_exchange(i, buf + 1);
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
  unpack_exchange(i, extra + m + 1);
}

// of the reference: how many numbers follow, lengths of the box in three directions, reach of the types

void FixSPHSolidPartners::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  std::vector<double> list(1, static_cast<double>(lengths.size() + reach_then.size()));
  list.insert(list.end(), lengths.begin(), lengths.end());
  list.insert(list.end(), reach_then.begin(), reach_then.end());
  const int size = static_cast<int>(list.size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

void FixSPHSolidPartners::restart(char *buf)
{
  double n;
  std::memcpy(&n, buf, sizeof(double));
  std::vector<double> list(static_cast<std::size_t>(n));
  std::memcpy(list.data(), buf + sizeof(double), list.size() * sizeof(double));
  const auto end_of_lengths = list.begin() + std::min<std::ptrdiff_t>(3, list.size());
  lengths.assign(list.begin(), end_of_lengths);
  reach_then.assign(end_of_lengths, list.end());
}

double FixSPHSolidPartners::memory_usage()
{
  double bytes = (double) atom->nmax *
      (sizeof(int) + sizeof(float) + (dim + 1) * sizeof(double) + 2 * sizeof(void *) +
       (1 + maxpartner) * sizeof(tagint));
  bytes += (double) index.capacity() * sizeof(int) + (double) row.capacity() * sizeof(int *);
  bytes += (double) (own.capacity() + count.capacity()) * sizeof(int);
  return bytes;
}
