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
#include "fix_sph_solid_partners.h"
#include "force.h"
#include "memory.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "sph_solid_eos.h"
#include "sph_solid_precision.h"
#include "sph_solid_sweeps.h"
#include "sph_solid_threads.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHSolid;

// LAMMPS 4 Feb 2025 to 4 Jul 2026; the version (YYYYMMDD) is taken from LAMMPS' version.h by the build system
#ifndef SPHSOLID_LMP_VERSION
#error "SPHSOLID_LMP_VERSION is not set: build through cmake/USER-SPHSOLID.cmake"
#elif SPHSOLID_LMP_VERSION < 20250204
#error "USER-SPHSOLID needs LAMMPS 4 Feb 2025 or newer"
#endif

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

// the end of the Lagrangian frame, and that of the equation of state, are looked for every so many steps
static constexpr int OVERLOAD_EVERY = 20;

/* ---------------------------------------------------------------------- */

PairSPHSolid::PairSPHSolid(LAMMPS *lmp) :
    Pair(lmp), options(new Options), own(nullptr), kept(new Ledger), partners(nullptr),
    partners_gone(false)
{
  if (lmp->citeme) lmp->citeme->add(cite_sph_solid);
  single_enable = 0;
  one_coeff = 0;
  manybody_flag = 1;
  respa_enable = 0;
  restartinfo = 1;
  no_virial_fdotr_compute = 1;
  centroidstressflag = CENTROID_NOTAVAIL;

  message = Message::STRESS;
  displacement_time = courant_number = 0.0;
  resonance_wanted = false;
  resonance_of = 0;
  resume = resumed = warned_lost = warned_overload = warned_compression = logged = apart_logged =
      false;
  uncorrected_logged = false;
  message_of_sweeps = half_step_kept = true;
  rounds_half_steps = false;
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
}

/* ----------------------------------------------------------------------
   one force evaluation: the sweeps, in order.  In a setup nothing is
   advanced: dt = 0 and forces follow from the state as it is
------------------------------------------------------------------------- */

void PairSPHSolid::compute(int eflag, int vflag)
{
  require_partners();
  ev_init(eflag, vflag);
  sweeps->wants_virial = vflag_global != 0;
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
  if (!partners && !uncorrected_logged) log_uncorrected();
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
  if (partners && neighbor->ago % OVERLOAD_EVERY == 0) report_overload();
  if (!partners && neighbor->ago == 0 && !setup) warn_lost_neighbors();
  if (neighbor->ago % OVERLOAD_EVERY == 0) warn_compression();
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
    if (rounds_half_steps) store_half_step();
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

// of own ones, now: with walls, which want them as they are, where sweeps round them

void PairSPHSolid::store_half_step()
{
  double **v = atom->v;
  each_share(comm->nthreads, atom->nlocal, [&](int first, int end) {
    for (int i = first; i < end; i++)
      for (int k = 0; k < 3; k++) own->vhalf[k][i] = v[i][k];
  });
  half_step_kept = true;
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

// finite numbers, but not those of a metal

void PairSPHSolid::warn_compression()
{
  for (int i = 0; i < atom->nlocal && !warned_compression; i++) {
    if (!has_material(i) || !gives_way(i)) continue;
    error->warning(
        FLERR,
        "sph/solid: particle {} at {:.8g} {:.8g} {:.8g} has {:.4g} times its density at "
        "rest in step {}, where its equation of state ends: further compression meets no "
        "resistance (further ones of this rank are not reported)",
        atom->tag[i], atom->x[i][0], atom->x[i][1], atom->x[i][2],
        atom->rho[i] * atom->vfrac[i] / atom->rmass[i], update->ntimestep);
    warned_compression = true;
  }
}

// the Lagrangian frame follows a body until its particles turn over or pass
// through each other

void PairSPHSolid::report_overload()
{
  if (options->mixed) stop_torn();
  if (options->distortion == Distortion::IGNORE || warned_overload) return;
  const Overload end = sweeps->find_overload();
  if (end.kind == Overload::NONE) return;
  const int i = end.particle;
  static const char *const WHAT[] = {
      "", "its deformation gradient has turned over, with determinant",
      "it is squeezed flat, with a least principal stretch of",
      "it lies on a partner, their distance over that in the reference is"};
  const std::string text = fmt::format(
      "sph/solid, frame lagrangian: the deformation is beyond what this frame can follow at "
      "particle {} at {:.8g} {:.8g} {:.8g} in step {}: {} {:.4g}. Use frame eulerian for fracture, "
      "splash and self-contact, or pair_style keyword distortion warn to go on",
      atom->tag[i], atom->x[i][0], atom->x[i][1], atom->x[i][2], update->ntimestep, WHAT[end.kind],
      end.value);
  if (options->distortion == Distortion::ERROR) error->one(FLERR, Error::NOLASTLINE, text);
  error->warning(FLERR, text);
  warned_overload = true;
}

// whatever is asked for: numbers would be wrong

void PairSPHSolid::stop_torn()
{
  const Overload end = sweeps->find_torn();
  if (end.kind == Overload::NONE) return;
  const int i = end.particle;
  error->one(FLERR, Error::NOLASTLINE,
             "sph/solid, precision mixed: particle {} at {:.8g} {:.8g} {:.8g} and a partner are "
             "{:.4g} apart in step {}, further than this precision can tell: expected less than {} "
             "smoothing lengths, or precision double",
             atom->tag[i], atom->x[i][0], atom->x[i][1], atom->x[i][2], end.value,
             update->ntimestep, MIXED_REACH);
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
