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

#include "fix_sph_solid.h"

#include "atom.h"
#include "atom_vec_sph_solid.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_sph_solid_wall.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "pair_sph_solid.h"
#include "sph_solid_fingerprint.h"
#include "sph_solid_ranks.h"
#include "sph_solid_space.h"
#include "sph_solid_sweeps.h"
#include "sph_solid_threads.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

// positions closer than this share of a smoothing length are the same
static constexpr double PLACE = 1.0e-7;

/* ---------------------------------------------------------------------- */

FixSPHSolid::FixSPHSolid(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair(nullptr), own(nullptr)
{
  if (narg != 3)
    error->all(FLERR, 3, "Fix sph/solid has no arguments after its style, found '{}'", arg[3]);
  time_integrate = 1;
  dynamic_group_allow = 1;
  restart_global = 1;
  leading = heat_on_the_way = continues = unsettled = heats_itself = false;
  caught_up = true;
  dt_pending = 0.0;
  fingerprint = forces_mark = 0;
}

int FixSPHSolid::setmask()
{
  return INITIAL_INTEGRATE | FINAL_INTEGRATE | PRE_EXCHANGE | PRE_FORCE;    // for setup_pre_force()
}

/* ---------------------------------------------------------------------- */

FixSPHSolid *FixSPHSolid::leader(LAMMPS *lmp)
{
  // not by Modify::get_fix_list(), which makes its list anew: a fix that asks for the leader in
  // reset_dt() would take it away from the loop over all fixes that calls reset_dt()
  for (int k = 0; k < lmp->modify->nfix; k++) {
    Fix *fix = lmp->modify->fix[k];
    if (strcmp(fix->style, "sph/solid") == 0) return dynamic_cast<FixSPHSolid *>(fix);
  }
  return nullptr;
}

/* ----------------------------------------------------------------------
   a run that finds the state that the last one (or the restart file) left
   behind continues it exactly; otherwise it starts from rest in time
------------------------------------------------------------------------- */

void FixSPHSolid::init()
{
  pair = PairSPHSolid::find(lmp, "Fix sph/solid");
  own = AtomVecSPHSolid::arrays(atom);
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR, "Fix sph/solid works with run_style verlet, not with {}",
               update->integrate_style);
  leading = (leader(lmp) == this);
  require_masses();
  heat_on_the_way = leading && pair->keep_heat(moves_alone());
  decide_to_continue();
}

// the first of these fixes decides for all of them: they are parts of one step

void FixSPHSolid::decide_to_continue()
{
  if (leading)
    continues =
        dt_pending > 0.0 && fingerprint != 0 && fingerprint == state_fingerprint(atom->esph);
  else
    continues = leader(lmp)->continues;
  if (!continues)
    dt_pending = 0.0;
  else if (leading)
    pair->continue_from_half_step();
}

void FixSPHSolid::require_masses() const
{
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && !(atom->rmass[i] > 0.0))
      error->one(FLERR,
                 "Fix sph/solid {}: particle {} of type {} has mass {}: expected one > 0, from "
                 "a material of pair style sph/solid or 'set ... mass'",
                 id, atom->tag[i], atom->type[i], atom->rmass[i]);
}

// does a fix change the size or shape of the box?  Domain's flags also say so where faces are
// shrink-wrapped, which moves no particle

bool FixSPHSolid::drives_box(const Fix *fix)
{
  return (fix->box_change & ~BOX_CHANGE_DOMAIN) != 0;
}

bool FixSPHSolid::drives_box(LAMMPS *lmp)
{
  for (const auto &fix : lmp->modify->get_fix_list())
    if (drives_box(fix)) return true;
  return false;
}

bool FixSPHSolid::is_of_package(const Fix *fix)
{
  return utils::strmatch(fix->style, "^sph/solid") || utils::strmatch(fix->style, "^SPH/SOLID");
}

// has a fix that adds or removes particles, wraps them round the box or moves them to other ranks its turn
// before this one, which then finds others than the last force evaluation left?

bool FixSPHSolid::exchanged_before(LAMMPS *lmp, const Fix *one)
{
  const Modify *modify = lmp->modify;
  for (int k = 0; k < modify->nfix && modify->fix[k] != one; k++)
    if ((modify->fmask[k] & PRE_EXCHANGE) && !is_of_package(modify->fix[k])) return true;
  return false;
}

/* ----------------------------------------------------------------------
   from one force evaluation to the next, do velocities change by our kicks only, and
   positions by our drift?  Fixes that act on forces do no harm
------------------------------------------------------------------------- */

bool FixSPHSolid::moves_alone() const
{
  bool others = exchanged_before(lmp, this);
  int moved_by_us = 0;
  for (int k = 0; k < modify->nfix; k++) {
    const Fix *fix = modify->fix[k];
    if (is_of_package(fix)) {
      if (strcmp(fix->style, "sph/solid") == 0) moved_by_us |= fix->groupbit;
      if (group->dynamic[fix->igroup]) others = true;
      continue;
    }
    const int between = INITIAL_INTEGRATE | POST_INTEGRATE | PRE_FORCE;
    if ((modify->fmask[k] & between) || drives_box(fix)) others = true;
  }
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i];
    if (!(atom->mask[i] & moved_by_us) && (v[0] != 0.0 || v[1] != 0.0 || v[2] != 0.0))
      others = true;
  }
  return !SPHSolid::on_any_rank(others, world);
}

void FixSPHSolid::setup(int)
{
  if (drives_box(lmp) && !domain->deform_vremap)
    error->all(FLERR,
               "Fix sph/solid: the box changes its size or shape and moves particles without a "
               "velocity, which gives no stress: expected fix deform ... remap v");
  if (!pair->has_resumed()) dt_pending = 0.0;
  fixes_of_setup = names_of_fixes();
}

// a run begins: init() and setup_pre_exchange() are called by write_data, too

void FixSPHSolid::setup_pre_force(int)
{
  if (continues) go_back();
  unsettled = continues && leading;
  heats_itself = false;
  caught_up = own->swaps_energies = false;
}

void FixSPHSolid::post_run()
{
  if (caught_up) return;    // run 0 pre no
  settle();
  pair->keep_half_step();
  forces_mark = mark_of_forces();
  if (leading) {    // the first of all these fixes
    catch_up();
    std::swap_ranges(atom->esph, atom->esph + atom->nlocal, own->esph_half);
    own->swaps_energies = false;
  }
  caught_up = true;
  fingerprint = state_fingerprint(atom->esph);
}

// energies that belong to the velocities, in esph_half

void FixSPHSolid::catch_up()
{
  double *out = own->esph_half;
  pending_heat(out);
  for (int i = 0; i < atom->nlocal; i++)
    out[i] = atom->esph[i] + (pair->has_material(i) ? out[i] / atom->rmass[i] : 0.0);
}

// to what the last step left behind

void FixSPHSolid::go_back()
{
  if (leading && caught_up) std::swap_ranges(atom->esph, atom->esph + atom->nlocal, own->esph_half);
}

// The heat of both half kicks around a force evaluation is that of one force.  If a run that continues finds
// others (a wall has gone, or another fix has come), the energies that belong to the velocities are the ones to
// start from, and the half kick that is to come has its heat from a sweep of its own

void FixSPHSolid::settle()
{
  if (!unsettled) return;
  unsettled = false;
  if (mark_of_forces() == forces_mark) return;
  std::swap_ranges(atom->esph, atom->esph + atom->nlocal, own->esph_half);
  heats_itself = true;
  start_from_rest();
  for (Fix *fix : modify->get_fix_by_style("^sph/solid/wall$"))
    dynamic_cast<FixSPHSolidWall *>(fix)->begin_anew();
}

// no fix sph/solid has anything to go on from

void FixSPHSolid::start_from_rest()
{
  for (Fix *of_group : modify->get_fix_by_style("^sph/solid$")) {
    auto *fix = dynamic_cast<FixSPHSolid *>(of_group);
    fix->dt_pending = 0.0;
    fix->fingerprint = 0;
  }
}

std::uint64_t FixSPHSolid::mark_of_forces() const
{
  auto add = [this](SPHSolid::Fingerprint &print, int i) {
    for (int k = 0; k < 3; k++) print.add(atom->f[i][k]);
  };
  return SPHSolid::fingerprint_of_particles(atom->nlocal, atom->tag, world, add);
}

// fix_modify ID reference renew: the group's next run starts from the
// configuration as it then is

int FixSPHSolid::modify_param(int narg, char **arg)
{
  if (strcmp(arg[0], "reference") != 0) return 0;
  if (narg < 2 || strcmp(arg[1], "renew") != 0)
    error->all(FLERR, "Fix_modify reference of fix sph/solid: found '{}', expected renew",
               narg < 2 ? "nothing" : arg[1]);
  auto *p = PairSPHSolid::find(lmp, "Fix_modify reference of fix sph/solid");

  // the heat of the last half kick belongs to the forces of the old reference: the next run starts
  // from rest in time
  start_from_rest();
  p->renew_reference(groupbit);
  return 2;
}

// a number that any change of a state or ID changes, and no change of order does.  Positions in
// parts of a smoothing length: commands that balance ranks or wrap particles round them

std::uint64_t FixSPHSolid::state_fingerprint(const double *esph) const
{
  const double unit = PLACE * pair->largest_smoothing_length();
  auto add = [&](SPHSolid::Fingerprint &print, int i) {
    for (int k = 0; k < 3; k++) print.add(atom->v[i][k]);
    double x[3];
    domain->unmap(atom->x[i], atom->image[i], x);
    for (int k = 0; k < 3; k++) print.add(std::rint(x[k] / unit) + 0.0);    // -0 is 0
    for (int k = 0; k < 6; k++) print.add(own->stress[i][k]);
    for (const double value : {atom->rho[i], esph[i], own->epl[i], atom->vfrac[i], atom->rmass[i]})
      print.add(value);
    print.add(atom->type[i]);
    print.add((pair->moves(i) ? 1 : 0) + (pair->kicks(i) ? 2 : 0));
  };
  return (SPHSolid::fingerprint_of_particles(atom->nlocal, atom->tag, world, add) +
          pair->numerics_mark()) |
      1;
}

/* ----------------------------------------------------------------------
   velocity Verlet: half kick, drift | forces | half kick.  The heat of both
   half kicks around a force evaluation is added in one go before the drift:
   at the mean velocities of the halves, v - dt1/4 a and v + dt2/4 a, the work
   of the pair forces is exactly what the kicks do to the kinetic energy
------------------------------------------------------------------------- */

void FixSPHSolid::initial_integrate(int)
{
  if (caught_up) {    // run ... pre no: no setup
    require_unchanged();
    go_back();
  }
  settle();
  caught_up = own->swaps_energies = false;
  if (leading && pair->has_energy()) {
    if (heat_on_the_way && !heats_itself)
      pair->leave_heat(0.25 * (dt_pending + update->dt));
    else
      add_heat();
  }
  heats_itself = false;
  // in chunks, so that the drift finds the velocities of the kick in the first-level cache
  constexpr int CHUNK = 512;
  const double dt = update->dt;
  SPHSolid::each_share(comm->nthreads, atom->nlocal, [&](int first, int end) {
    for (; first < end; first += CHUNK) {
      const int last = std::min(first + CHUNK, end);
      kick(first, last, 0.5 * dt * force->ftm2v);
      add_to_moved(first, last, atom->x, atom->v, [dt](auto) {
        return dt;
      });
    }
  });
}

void FixSPHSolid::require_unchanged() const
{
  pair->require_current("A run with 'pre no'");
  if (leading && fingerprint != state_fingerprint(atom->esph))
    error->all(FLERR, Error::NOLASTLINE,
               "A run with 'pre no' goes on from the last one, and the state of sph/solid, its "
               "reference or what moves it has changed since: expected a run without it");
  if (!(update->dt > 0.0))
    error->all(FLERR, Error::NOLASTLINE,
               "Fix sph/solid {}: the time step is {}: expected timestep with a value > 0", id,
               update->dt);
  if (leading && fixes_of_setup != names_of_fixes())
    error->all(
        FLERR, Error::NOLASTLINE,
        "A run with 'pre no' goes on from the last one, and fixes have come or gone since, "
        "which LAMMPS would not call or call in vain: there were {} and there are {}: expected "
        "a run without it",
        fixes_of_setup, names_of_fixes());
}

// but for the one of the pair style, which has a message of its own

std::string FixSPHSolid::names_of_fixes() const
{
  std::string names;
  for (int k = 0; k < modify->nfix; k++)
    if (!utils::strmatch(modify->fix[k]->style, "^SPH/SOLID"))
      names += (names.empty() ? "" : " ") + std::string(modify->fix[k]->id);
  return names;
}

// neighbors are about to be new, and with them all that the last force evaluation left behind

void FixSPHSolid::pre_exchange()
{
  if (leading) pair->add_left_heat();
}

void FixSPHSolid::final_integrate()
{
  SPHSolid::each_share(comm->nthreads, atom->nlocal, [&](int first, int end) {
    kick(first, end, 0.5 * update->dt * force->ftm2v);
  });
  dt_pending = update->dt;
}

void FixSPHSolid::kick(int first, int end, double dtf)
{
  add_to_moved(first, end, atom->v, atom->f, [dtf](auto mass) {
    return dtf / mass;
  });
}

// of the particles of the group to += factor(mass) from, in two dimensions without z.  One by one
// only where some of LANES particles side by side are in the group and others are not

template <class Factor>
void FixSPHSolid::add_to_moved(int first, int end, double **to, double *const *from, Factor factor)
{
  using SPHSolid::LANES;
  const double *rmass = atom->rmass;
  const int *mask = atom->mask, dimension = domain->dimension;
  for (; first < end; first += LANES) {
    int of_all = groupbit;
    for (int i = first; i < std::min(first + LANES, end); i++) of_all &= mask[i];
    if (of_all && first + LANES <= end) {
      const SPHSolid::Pack factors = factor(SPHSolid::load(rmass + first));
      double *into = to[0] + 3 * std::ptrdiff_t(first);    // without looking for its place
      const double *with = from[0] + 3 * std::ptrdiff_t(first);
      if (dimension == 3)
        SPHSolid::add_multiples<3>(into, with, factors);
      else
        SPHSolid::add_multiples<2>(into, with, factors);
      continue;
    }
    for (int i = first; i < std::min(first + LANES, end); i++) {
      if (!(mask[i] & groupbit)) continue;
      const double factor_i = factor(rmass[i]);
      for (int k = 0; k < dimension; k++) to[i][k] += factor_i * from[i][k];
    }
  }
}

void FixSPHSolid::add_heat()
{
  const double dt1 = dt_pending, dt2 = update->dt;
  pair->pair_heat(0.5 * (dt1 + dt2), 0.125 * (dt2 * dt2 - dt1 * dt1), nullptr);
}

void FixSPHSolid::pending_heat(double *out) const
{
  if (unsettled) {    // either way the energies that belong to the velocities are in esph_half
    for (int i = 0; i < atom->nlocal; i++)
      out[i] = atom->rmass[i] * (own->esph_half[i] - atom->esph[i]);
    return;
  }
  std::memset(out, 0, atom->nlocal * sizeof(double));
  if (caught_up || dt_pending == 0.0 || !pair->has_energy()) return;
  pair->require_current("The internal energy of sph/solid");
  pair->keep_half_step();
  pair->pair_heat(0.5 * dt_pending, -0.125 * dt_pending * dt_pending, out);
}

/* ----------------------------------------------------------------------
   restart: what this state needs to continue, and the energy ledger
------------------------------------------------------------------------- */

// of the state as a restart file has it

std::uint64_t FixSPHSolid::restart_fingerprint()
{
  if (caught_up) return state_fingerprint(atom->esph);
  settle();
  forces_mark = mark_of_forces();
  if (leading) catch_up();
  own->swaps_energies = true;
  return state_fingerprint(own->esph_half);
}

namespace {

struct Saved {
  double dt_pending;
  std::uint64_t fingerprint;
  SPHSolid::Ledger ledger;    // of all ranks
  std::uint64_t forces_mark;
};

}    // namespace

void FixSPHSolid::write_restart(FILE *fp)
{
  if (pair && dt_pending > 0.0) pair->keep_half_step();
  Saved saved = {dt_pending, pair ? restart_fingerprint() : 0, {}, 0};
  saved.forces_mark = forces_mark;    // which restart_fingerprint() may have changed
  if (pair && leading) {
    const SPHSolid::Ledger &l = pair->ledger();
    double mine[4] = {l.plastic_work, l.viscous_heat, l.returned, l.hourglass}, all[4] = {};
    MPI_Reduce(mine, all, 4, MPI_DOUBLE, MPI_SUM, 0, world);
    saved.ledger = {all[0], all[1], all[2], all[3]};
  }
  if (comm->me == 0) {
    const int size = sizeof(saved);
    fwrite(&size, sizeof(int), 1, fp);
    fwrite(&saved, sizeof(saved), 1, fp);
  }
}

// the settings of the pair style, which come first in the file, say that it has this layout

void FixSPHSolid::restart(char *buf)
{
  Saved saved;
  std::memcpy(&saved, buf, sizeof(saved));
  dt_pending = saved.dt_pending;
  fingerprint = saved.fingerprint;
  forces_mark = saved.forces_mark;
  auto *p = dynamic_cast<PairSPHSolid *>(force->pair_match("sph/solid", 1));
  const SPHSolid::Ledger &l = saved.ledger;
  const bool led = l.plastic_work != 0.0 || l.viscous_heat != 0.0 || l.returned != 0.0 ||
      l.hourglass != 0.0;
  if (p && led && comm->me == 0) p->ledger() = l;
}
