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

#include "pair_sph_solid.h"

#include "atom.h"
#include "atom_vec_sph_solid.h"
#include "citeme.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
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
#include "sph_solid_compat.h"
#include "sph_solid_eos.h"
#include "sph_solid_ranks.h"
#include "sph_solid_sweeps.h"
#include "sph_solid_threads.h"
#include "sph_solid_vector.h"
#include "update.h"

#include <algorithm>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHSolid;

static const char cite_sph_solid[] =
    "pair sph/solid command: doi:10.1016/j.cma.2009.09.006\n\n"
    "@Article{Shaw2009,\n"
    " author = {A. Shaw and S. R. Reid},\n"
    " title = {Heuristic Acceleration Correction Algorithm for Use in {SPH} Computations in "
    "Impact Mechanics},\n"
    " journal = {Computer Methods in Applied Mechanics and Engineering},\n"
    " year = 2009,\n"
    " volume = 198,\n"
    " pages = {3962--3974}\n"
    "}\n\n";

static constexpr char PARTNERS_ID[] = "SPHSOLID_PARTNERS";

// a particle this close to a symmetry plane, in smoothing lengths, is on it
static constexpr double ON_PLANE = 1.0e-6;

// the end of the Lagrangian frame is looked for every so many steps
static constexpr int OVERLOAD_EVERY = 20;

/* ---------------------------------------------------------------------- */

PairSPHSolid::PairSPHSolid(LAMMPS *lmp) :
    Pair(lmp), options(nullptr), types(nullptr), own(nullptr), sweeps(nullptr), kept(nullptr),
    partners(nullptr), partners_gone(false)
{
  if (lmp->citeme) lmp->citeme->add(cite_sph_solid);
  single_enable = 0;
  one_coeff = 0;
  manybody_flag = 1;
  respa_enable = 0;
  restartinfo = 1;
  no_virial_fdotr_compute = 1;
  centroidstressflag = CENTROID_NOTAVAIL;

  options = new Options;
  kept = new Ledger;
  message = Message::STRESS;
  displacement_time = courant_number = 0.0;
  resonance_wanted = false;
  resonance_of = 0;
  resume = resumed = warned_lost = warned_overload = logged = apart_logged = false;
  message_of_sweeps = half_step_kept = true;
  integrated = kicked = list_threads = 0;
  evaluated_own = evaluated_all = -1;
}

PairSPHSolid::~PairSPHSolid()
{
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
  leave_partners();
  delete options;
  delete[] types;
  delete sweeps;
  delete kept;
}

/* ----------------------------------------------------------------------
   one force evaluation: the sweeps, in order.  In a setup nothing is
   advanced: dt = 0 and forces follow from the state as it is
------------------------------------------------------------------------- */

void PairSPHSolid::compute(int eflag, int vflag)
{
  require_partners();
  ev_init(eflag, vflag);
  if (vflag_atom || cvflag_atom)
    error->all(FLERR, Error::NOLASTLINE,
               "Pair style sph/solid has no per-atom virial: use compute sph/solid/atom sxx ...");

  const bool setup = update->setupflag != 0;
  const double dt = setup ? 0.0 : update->dt;
  if (neighbor->ago == 0) new_neighbors(setup);
  if (setup && resonance_wanted && partners) find_courant_number();
  Particles p = particles();
  const NeighborRows list = rows();
  pack_kinematics(setup);

  const int unphysical = sweeps->gradient(p, list, dt);
  if (unphysical >= 0) stop_unphysical(unphysical);
  forward(Message::STRESS);
  sweeps->mirror_stress();

  if (sweeps->sweeps_for_switch()) {
    sweeps->find_switch(p, list);
    forward(Message::SWITCH);
    sweeps->mirror_switch();
  }
  sweeps->force(p, list);
  if (sweeps->needs_correction()) {
    forward(Message::VISCOUS);
    sweeps->correction(p, list);
  }

  if (eflag_global || eflag_atom)
    for (int ii = 0; ii < list.inum; ii++) {
      const int i = list.ilist[ii];
      if (eflag_global) eng_vdwl += p.mass[i] * p.e[i];
      if (eflag_atom) eatom[i] += p.mass[i] * p.e[i];
    }
  if (vflag_global) sweeps->virial(p, list, virial);
  evaluated_own = p.nlocal;
  evaluated_all = p.nall;
  if (partners) {
    if (neighbor->ago % OVERLOAD_EVERY == 0) report_overload();
  } else if (neighbor->ago == 0 && !setup)
    warn_lost_neighbors();
}

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
  if (!partners) {
    if (setup) require_distinct_places();
    sort_rows();
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
    for (const Plane &plane : sweeps->images.all_planes())
      if (setup)
        partners->require_on_one_side(plane.dim, plane.position,
                                      ON_PLANE * largest_smoothing_length());
  }
  Particles p = particles();
  std::vector<std::int64_t> id;
  if (partners) {
    id.assign(atom->tag, atom->tag + p.nall);
    p.id = id.data();
    if (setup) sweeps->unlike = has_unlike_materials();
  }
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
  bigint mine = sweeps->uncorrected(), all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all > 0 && comm->me == 0)
    utils::logmesg(lmp,
                   "sph/solid: no gradient correction for {} particles, whose partners in the "
                   "reference lie in one row or layer\n",
                   all);
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
      const double *a = atom->x[i], *b = atom->x[j];
      if (a[0] == b[0] && a[1] == b[1] && a[2] == b[2])
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
  if (partners && partners->left)
    sweeps->ledger = *partners->left;
  else
    partners = dynamic_cast<FixSPHSolidPartners *>(
        modify->add_fix(std::string(PARTNERS_ID) + " all SPH/SOLID/PARTNERS"));
  partners->left.reset();
  partners->gone = &partners_gone;
}

// a pair_style command that makes this style anew (hybrid does so even if it is the same) changes neither
// the reference nor the energy ledger

void PairSPHSolid::leave_partners()
{
  if (!partners || partners_gone) return;
  partners->left = std::make_unique<Ledger>(ledger());
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
  require_partners();
  if (partners) partners->forget(groupbit);
}

/* ----------------------------------------------------------------------
   velocities and volume weights of this evaluation.  v is at the half step
   inside a run; a setup that continues a run takes what that run used, so
   that stopping and restarting changes nothing
------------------------------------------------------------------------- */

void PairSPHSolid::pack_kinematics(bool setup)
{
  const Particles p = particles();
  resumed = setup && resume;
  resume = false;
  half_step_kept = resumed;
  if (!resumed) {
    if (!partners)
      each_share(comm->nthreads, p.nall, [&](int first, int end) {
        std::copy(p.rho + first, p.rho + end, p.rho_weight + first);
      });
    return sweeps->pack_kinematics(p, p.v);
  }
  message_of_sweeps = false;
  comm->forward_comm(this, 3);
  message_of_sweeps = true;
  swap_half_step();
  sweeps->pack_kinematics(p, p.v);
  swap_half_step();
}

// with those of all particles

void PairSPHSolid::swap_half_step()
{
  const Particles p = particles();
  for (int i = 0; i < p.nall; i++)
    for (int k = 0; k < 3; k++) std::swap(p.v[i][k], own->vhalf[k][i]);
}

void PairSPHSolid::keep_half_step()
{
  if (half_step_kept) return;
  half_step_kept = true;
  for (int i = 0; i < atom->nlocal; i++) {
    double v[3] = {};
    sweeps->velocity(i, v);
    for (int k = 0; k < 3; k++) own->vhalf[k][i] = v[k];
  }
}

/* ----------------------------------------------------------------------
   rows in the order of atom IDs: sums do not depend on where atoms are
   stored, so neither on ranks, sorting nor restarts
------------------------------------------------------------------------- */

void PairSPHSolid::sort_rows()
{
  bigint candidates = 0;
  for (int ii = 0; ii < list->inum; ii++) candidates += list->numneigh[list->ilist[ii]] + 2 * LANES;
  if (candidates > MAXSMALLINT)
    error->one(FLERR, Error::NOLASTLINE,
               "sph/solid: the particles of rank {} have {} neighbors, and at most {} can be "
               "counted: expected more ranks",
               comm->me, candidates, MAXSMALLINT);
  const tagint *tag = atom->tag;
  double **x = atom->x;
  auto before = [tag, x](int a, int b) {
    a &= NEIGHMASK;
    b &= NEIGHMASK;
    if (tag[a] != tag[b]) return tag[a] < tag[b];
    return std::lexicographical_compare(x[a], x[a] + 3, x[b], x[b] + 3);    // periodic images
  };
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    std::sort(list->firstneigh[i], list->firstneigh[i] + list->numneigh[i], before);
  }
}

/* ---------------------------------------------------------------------- */

Particles PairSPHSolid::particles() const
{
  Particles p;
  p.nlocal = atom->nlocal;
  p.nall = atom->nlocal + atom->nghost;
  p.x = atom->x;
  p.v = atom->v;
  p.f = atom->f;
  p.type = atom->type;
  p.mass = atom->rmass;
  p.volume = atom->vfrac;
  p.rho = atom->rho;
  p.e = atom->esph;
  p.stress = own->stress;
  p.epl = own->epl;
  p.rho_weight = own->rho_weight;
  require_partners();
  if (partners) {
    p.xref = partners->xref;
    p.vref = partners->vref;
    const double length[3] = {domain->xprd, domain->yprd, domain->zprd};
    for (int k = 0; k < domain->dimension; k++)
      if (domain->periodicity[k]) p.period[k] = length[k];
  }
  return p;
}

/* ---------------------------------------------------------------------- */

void PairSPHSolid::stop_unphysical(int i)
{
  error->one(FLERR, Error::NOLASTLINE,
             "sph/solid: the state of particle {} at {:.8g} {:.8g} {:.8g} is not physical in step "
             "{}: density {:.8g}, pressure {:.8g}, deviatoric stress {:.8g} {:.8g} {:.8g} ...; "
             "expected finite values and a density > 0. The usual causes are a time step that is "
             "too long (fix sph/solid/dt) and viscosity none",
             atom->tag[i], atom->x[i][0], atom->x[i][1], atom->x[i][2], update->ntimestep,
             atom->rho[i], pressure(i), own->stress[i][0], own->stress[i][1], own->stress[i][2]);
}

// a particle with a history and no neighbor any more has left its body

void PairSPHSolid::warn_lost_neighbors()
{
  if (warned_lost) return;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const bool strained = own->epl[i] > 0.0 || own->stress[i][0] != 0.0;
    if (!strained || sweeps->neighbor_count(i) > 0) continue;
    error->warning(FLERR,
                   "sph/solid: particle {} at {:.8g} {:.8g} {:.8g} has lost all its neighbors by "
                   "step {}: its body is breaking up (further ones of this rank are not reported)",
                   atom->tag[i], atom->x[i][0], atom->x[i][1], atom->x[i][2], update->ntimestep);
    warned_lost = true;
    return;
  }
}

// the Lagrangian frame follows a body until its particles turn over or pass
// through each other

void PairSPHSolid::report_overload()
{
  if (options->distortion == Distortion::IGNORE || warned_overload) return;
  const Overload end = sweeps->find_overload();
  if (end.kind == Overload::NONE) return;
  const int i = end.particle;
  static const char *const WHAT[] = {
      "", "its deformation gradient has turned over, with determinant",
      "it is squeezed flat, with a least principal stretch of",
      "it lies on a partner, their distance over that in the reference is"};
  char text[512];
  snprintf(
      text, sizeof(text),
      "sph/solid, frame lagrangian: the deformation is beyond what this frame can follow at "
      "particle %lld at %.8g %.8g %.8g in step %lld: %s %.4g. Use frame eulerian for fracture, "
      "splash and self-contact, or pair_style keyword distortion warn to go on",
      (long long) atom->tag[i], atom->x[i][0], atom->x[i][1], atom->x[i][2],
      (long long) update->ntimestep, WHAT[end.kind], end.value);
  if (options->distortion == Distortion::ERROR) error->one(FLERR, Error::NOLASTLINE, text);
  error->warning(FLERR, text);
  warned_overload = true;
}

/* ----------------------------------------------------------------------
   messages to ghosts
------------------------------------------------------------------------- */

void PairSPHSolid::forward(Message what)
{
  message = what;
  comm->forward_comm(this, sweeps->message_size(what));
}

int PairSPHSolid::pack_forward_comm(int n, int *atoms, double *buf, int across, int *pbc)
{
  const int size = message_of_sweeps ? sweeps->message_size(message) : 3;
  for (int k = 0; k < n; k++)
    if (message_of_sweeps)
      sweeps->pack(message, atoms[k], &buf[k * size]);
    else
      for (int a = 0; a < 3; a++) buf[k * size + a] = own->vhalf[a][atoms[k]];
  const bool velocities = !message_of_sweeps || message == Message::DISPLACEMENT;
  if (velocities && across && domain->deform_vremap) add_box_velocity(n, size, atoms, buf, pbc);
  return n * size;
}

// in a box that deforms with velocities remapped (fix deform), what crosses its boundary moves by
// that much faster: as AtomVec::pack_comm_vel() has it

void PairSPHSolid::add_box_velocity(int n, int size, const int *atoms, double *buf,
                                    const int *pbc) const
{
  const double *rate = domain->h_rate, factor = message_of_sweeps ? displacement_time : 1.0;
  const double dv[3] = {pbc[0] * rate[0] + pbc[5] * rate[5] + pbc[4] * rate[4],
                        pbc[1] * rate[1] + pbc[3] * rate[3], pbc[2] * rate[2]};
  for (int k = 0; k < n; k++)
    if (atom->mask[atoms[k]] & domain->deform_groupbit)
      for (int a = 0; a < size; a++) buf[k * size + a] += factor * dv[a];
}

void PairSPHSolid::unpack_forward_comm(int n, int first, double *buf)
{
  const Particles p = particles();
  const int size = message_of_sweeps ? sweeps->message_size(message) : 3;
  for (int k = 0; k < n; k++)
    if (message_of_sweeps)
      sweeps->unpack(message, p, first + k, &buf[k * size]);
    else
      for (int a = 0; a < 3; a++) own->vhalf[a][first + k] = buf[k * size + a];
}
