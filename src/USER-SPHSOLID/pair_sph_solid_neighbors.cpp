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

// Neighbors of pair style sph/solid: rows of the neighbor list in the Eulerian frame, partners of the reference in
// the Lagrangian one, and what the log says of them

#include "pair_sph_solid.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_sph_solid_partners.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "my_page.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "npair.h"
#include "nstencil.h"
#include "pair_hybrid.h"
#include "sph_solid_ranks.h"
#include "sph_solid_sweeps.h"
#include "sph_solid_vector.h"
#include "update.h"

#include <algorithm>
#ifdef __GLIBC__
#include <malloc.h>
#endif

using namespace LAMMPS_NS;
using namespace SPHSolid;

static constexpr char PARTNERS_ID[] = "SPHSOLID_PARTNERS";

/* ----------------------------------------------------------------------
   particles have moved between ranks and their neighbors are new.  In the
   Lagrangian frame they are not: only their local indices are, and in the
   first setup the present configuration becomes the reference
------------------------------------------------------------------------- */

void PairSPHSolid::new_neighbors(bool setup)
{
  bool refers = false;
  require_state();
  if (setup) log_apart();
  if (options->mixed) require_near_origin();
  if (!partners) {
    if (setup) require_distinct_places();
    require_countable_neighbors();
  } else {
    if (!setup && partners->in_place()) return;
    if (setup) partners->require_same(smoothing_lengths(), cutoffs());
    refers = setup && partners->anyone_without(setflag);
    if (refers) {
      // LAMMPS keeps the stencil of bins that have become others in the same step
      if (list->np && list->np->ns) list->np->ns->last_stencil = -1;
      neighbor->build_one(list);
      partners->refer(list, cutsq, setflag, smoothing_lengths(), cutoffs());
      empty_list();
    }
    partners->find(setup, setflag);
    if (setup)
      for (const Plane &plane : sweeps->images.all_planes())
        partners->require_on_one_side(plane.dim, plane.position,
                                      SPHSolid::ON_PLANE * largest_smoothing_length());
  }
  Particles p = particles();
  const std::vector<std::int64_t> id(atom->tag, atom->tag + p.nall);
  p.id = id.data();
  if (partners && setup) sweeps->unlike = has_unlike_materials();
  sweeps->new_neighbors(p, rows(), largest_cutoff() + neighbor->skin);
  if (partners && partners->forget_rows()) give_back_freed_memory();
  if (refers) {
    log_uncorrected();
    log_bodies();
  }
}

// on any rank, so that pairs are the same seen from both sides, and all runs on any number of ranks.
// In a run nothing of it changes

bool PairSPHSolid::has_unlike_materials() const
{
  Likeness mine, all;
  for (int i = 0; i < atom->nlocal; i++)
    if (has_material(i)) mine.add(types[atom->type[i]], atom->rmass[i], partners->vref[i]);
  all.density = over_ranks(mine.density, world);
  all.impedance = over_ranks(mine.impedance, world);
  return all.unlike(*options);
}

void PairSPHSolid::log_uncorrected()
{
  const bigint all = sum_over_ranks(bigint(sweeps->uncorrected()), world);
  if (all > 0 && comm->me == 0)
    utils::logmesg(lmp, "sph/solid: no gradient correction for {} particles, whose {}\n", all,
                   partners ? "partners in the reference lie in one row or layer"
                            : "neighbors are few, or lie in one row or layer");
  uncorrected_logged = true;
}

// bodies of one particle are fragments, and no news

void PairSPHSolid::log_bodies()
{
  const FixSPHSolidPartners::Bodies bodies = partners->bodies();
  if (comm->me != 0) return;
  if (bodies.mixed_pairs > 0)
    utils::logmesg(lmp,
                   "sph/solid: {} pairs of particles of different types are partners: bonded for "
                   "good\n",
                   bodies.mixed_pairs);
  const auto &sizes = bodies.sizes;
  if (sizes.size() < 2 || sizes[1] < 2) return;
  const auto n = std::count_if(sizes.begin(), sizes.end(), [](bigint size) {
    return size > 1;
  });
  error->warning(
      FLERR,
      "sph/solid, frame lagrangian: the reference has {} bodies, the largest of {} and {} "
      "particles, which do not act on each other, not even where they meet: expected one "
      "body, frame eulerian, or another pair style between them",
      n, sizes[0], sizes[1]);
}

// pair_coeff of a hybrid may give two types another style and not this one

void PairSPHSolid::log_apart()
{
  auto *hybrid = dynamic_cast<PairHybrid *>(force->pair);
  if (!hybrid || apart_logged) return;
  apart_logged = true;
  char style[] = "sph/solid";
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i + 1; j <= atom->ntypes; j++)
      if (setflag[i][i] && setflag[j][j] && !hybrid->check_ijtype(i, j, style) && comm->me == 0)
        utils::logmesg(lmp,
                       "sph/solid: particles of types {} and {} do not act on each other by this "
                       "style: pair_coeff gives them another one only\n",
                       i, j);
}

// two particles at one place have been created twice

void PairSPHSolid::require_distinct_places() const
{
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      const double *a = atom->x[i], r2 = square_of_distance(a, atom->x[j]);
      if (at_same_place(r2, cutsq[atom->type[i]][atom->type[j]]))
        error->one(FLERR, Error::NOLASTLINE,
                   "sph/solid: particles {} and {} lie at the same place {:.8g} {:.8g} {:.8g}",
                   atom->tag[i], atom->tag[j], a[0], a[1], a[2]);
    }
  }
}

// what has served to arrange partners leaves holes below the arrays that stay, which are a tenth of
// all memory: the C library keeps them unless it is asked

void PairSPHSolid::give_back_freed_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

std::vector<double> PairSPHSolid::smoothing_lengths() const
{
  std::vector<double> h(atom->ntypes + 1, 0.0);
  for (int t = 1; t <= atom->ntypes; t++)
    if (setflag[t][t]) h[t] = types[t].h;
  return h;
}

double PairSPHSolid::largest_smoothing_length() const
{
  const std::vector<double> h = smoothing_lengths();
  return *std::max_element(h.begin(), h.end());
}

// of the types with a material; Pair::cutforce is that of the whole pair style, and in a hybrid 0

std::vector<double> PairSPHSolid::cutoffs()
{
  std::vector<double> cut(atom->ntypes + 1, 0.0);
  for (int t = 1; t <= atom->ntypes; t++)
    if (setflag[t][t]) cut[t] = init_one(t, t);
  return cut;
}

double PairSPHSolid::largest_cutoff()
{
  const std::vector<double> cut = cutoffs();
  return *std::max_element(cut.begin(), cut.end());
}

// partners are known, and in three dimensions their neighbor list is a tenth of all memory: give its
// pages back, unless another list has been made from it or it is another list itself

void PairSPHSolid::empty_list()
{
  if (list->copy && !list->trim) return;
  for (int k = 0; k < neighbor->nlist; k++) {
    const NeighList *other = neighbor->lists[k];
    if (other->listcopy == list || other->listskip == list || other->listfull == list) return;
  }
  list->inum = list->gnum = 0;
  if (list->ipage)
    for (int k = 0; k < list_threads; k++)
      list->ipage[k].init(neighbor->oneatom, neighbor->pgsize, 1);
  memory->destroy(list->ilist);
  memory->destroy(list->numneigh);
  memory->sfree(list->firstneigh);
  list->firstneigh = nullptr;
  list->maxatom = 0;                          // so that NeighList::grow() makes new ones
  if (list->np) list->np->last_build = -1;    // who asks for it gets a new one
}

NeighborRows PairSPHSolid::rows() const
{
  if (partners)
    return {partners->nown(), partners->own_list(), partners->counts(), partners->rows()};
  return {list->inum, list->ilist, list->numneigh, list->firstneigh};
}

void PairSPHSolid::create_partners()
{
  want_map();
  require_partners();
  if (partners) return;
  partners = dynamic_cast<FixSPHSolidPartners *>(modify->get_fix_by_id(PARTNERS_ID));
  if (partners && partners->kept_ledger)
    ledger() = *partners->kept_ledger;
  else
    partners = dynamic_cast<FixSPHSolidPartners *>(
        modify->add_fix(std::string(PARTNERS_ID) + " all SPH/SOLID/PARTNERS"));
  partners->kept_ledger.reset();
  partners->gone = &partners_gone;
}

// a pair_style command that makes this style anew (hybrid does so even if it is the same) changes neither
// the reference nor the energy ledger

void PairSPHSolid::leave_partners()
{
  if (!partners || partners_gone) return;
  partners->kept_ledger = std::make_unique<Ledger>(ledger());
  partners->gone = nullptr;
}

void PairSPHSolid::delete_partners()
{
  if (modify->get_fix_by_id(PARTNERS_ID)) modify->delete_fix(PARTNERS_ID);
  partners = nullptr;
  partners_gone = false;
  resonance_of = 0;
}

void PairSPHSolid::require_partners() const
{
  if (partners_gone)
    error->all(FLERR, Error::NOLASTLINE,
               "Pair style sph/solid, frame lagrangian: fix {} has been deleted: expected it to "
               "stay, since it holds the reference of all particles",
               PARTNERS_ID);
}

void PairSPHSolid::renew_reference(int groupbit)
{
  if (options->frame != Frame::LAGRANGIAN)
    error->all(FLERR, "Fix_modify reference: frame eulerian has no reference configuration");
  create_partners();    // of a restart file, or of a pair style before this one
  partners->forget(groupbit);
}

// the Eulerian frame numbers places of candidates, of whole vectors

void PairSPHSolid::require_countable_neighbors() const
{
  bigint candidates = 0;
  for (int ii = 0; ii < list->inum; ii++) candidates += list->numneigh[list->ilist[ii]] + 2 * WIDE;
  if (candidates > MAXSMALLINT)
    error->one(FLERR, Error::NOLASTLINE,
               "sph/solid: the particles of rank {} have {} neighbors, and at most {} can be "
               "counted: expected more ranks",
               comm->me, candidates, MAXSMALLINT);
}
