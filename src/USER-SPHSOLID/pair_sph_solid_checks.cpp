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

// What pair style sph/solid refuses or warns of before a run

#include "pair_sph_solid.h"

#include "atom.h"
#include "atom_vec_sph_solid.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "neighbor.h"
#include "sph_solid_kernel.h"
#include "sph_solid_precision.h"
#include "sph_solid_ranks.h"
#include "sph_solid_sweeps.h"
#include "sph_solid_tensile.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

using namespace LAMMPS_NS;
using namespace SPHSolid;

// a mass that differs by more than this factor from volume times density is worth a warning
static constexpr double ODD_MASS = 2.0;

// and so is a density that differs by more than this share from mass over volume where nothing has
// happened yet
static constexpr double ODD_DENSITY = 0.1;

// how many of n own particles are so, on all ranks together

template <class Call> static bigint count_particles(int n, MPI_Comm world, Call is)
{
  bigint mine = 0;
  for (int i = 0; i < n; i++)
    if (is(i)) mine++;
  return sum_over_ranks(mine, world);
}

void PairSPHSolid::require_environment()
{
  own = AtomVecSPHSolid::arrays(atom);    // of this Atom: replicate makes another
  if (!own)
    error->all(FLERR, "Pair style sph/solid needs atom_style sph/solid (alone or in hybrid)");
  if (atom->tag_enable == 0) error->all(FLERR, "Pair style sph/solid needs atom IDs");
  const std::string units = update->unit_style;
  if (units != "si" && units != "cgs" && units != "micro" && units != "nano" && units != "lj")
    error->all(FLERR, "Pair style sph/solid works in units si, cgs, micro, nano or lj, not in {}",
               units);
  if (utils::strmatch(force->pair_style, "^hybrid/scaled"))
    error->all(FLERR,
               "Pair style sph/solid cannot be part of pair style {}, which would scale forces and "
               "not the heat that belongs to them: expected hybrid or hybrid/overlay",
               force->pair_style);
  if (update->whichflag == 2)
    error->all(FLERR, "Pair style sph/solid carries a history and cannot be minimized");
  if (!(update->dt > 0.0))
    error->all(FLERR,
               "Pair style sph/solid: the time step is {}: expected timestep with a value > 0",
               update->dt);
}

/* ----------------------------------------------------------------------
   every particle is moved by one fix: ours or, for a clamped group, none
------------------------------------------------------------------------- */

void PairSPHSolid::require_one_integrator()
{
  integrated = 0;
  for (const auto &fix : modify->get_fix_list()) {
    if (strcmp(fix->style, "sph/solid") != 0) continue;
    require_apart(fix);
    integrated |= fix->groupbit;
  }
  if (!integrated && update->whichflag == 1)
    error->all(FLERR,
               "Pair style sph/solid: no time integration: expected a command like "
               "'fix 1 all sph/solid'");

  if (options->energy) {
    require_heat_first();
    require_kept_velocities();
  }
  kicked = integrated;
  for (const auto &fix : modify->get_fix_list()) {
    if (!fix->time_integrate || strcmp(fix->style, "sph/solid") == 0) continue;
    require_apart(fix);
    if (strcmp(fix->style, "nve") == 0) kicked |= fix->groupbit;
  }
  if (update->whichflag == 1) warn_idle_velocities();
}

// a clamped particle with a velocity would be a flow for its neighbors that never goes anywhere

void PairSPHSolid::warn_idle_velocities()
{
  int movers = 0;
  for (const auto &fix : modify->get_fix_list())
    if (fix->time_integrate) {
      if (group->dynamic[fix->igroup]) return;    // its members are not known yet
      movers |= fix->groupbit;
    }
  const bigint all = count_particles(atom->nlocal, world, [this, movers](int i) {
    const double *v = atom->v[i];
    return !(atom->mask[i] & movers) && has_material(i) &&
        (v[0] != 0.0 || v[1] != 0.0 || v[2] != 0.0);
  });
  if (all && comm->me == 0)
    error->warning(FLERR,
                   "sph/solid: {} particles have a velocity and no fix moves them: their neighbors "
                   "feel a motion that never happens; for a clamp expected velocity 0",
                   all);
}

// particles of a fix that have a material

bigint PairSPHSolid::count_of(const Fix *fix)
{
  return count_particles(atom->nlocal, world, [this, fix](int i) {
    return (atom->mask[i] & fix->groupbit) && has_material(i);
  });
}

// the heat of a step is found from velocities that nobody has changed yet

void PairSPHSolid::require_heat_first()
{
  for (const auto &fix : modify->get_fix_list()) {
    if (strcmp(fix->style, "sph/solid") == 0) return;
    if (!fix->time_integrate) continue;
    const bigint all = count_of(fix);
    if (all)
      error->all(FLERR,
                 "Pair style sph/solid: fix {} of style {} moves {} particles before the first fix "
                 "sph/solid has found their heat: expected it behind that fix in the input",
                 fix->id, fix->style, all);
  }
}

// nor behind its second kick, whose heat is found at the beginning of the next step

void PairSPHSolid::require_kept_velocities()
{
  static const char *const CHANGERS[] = {"^heat", "^ehex", "^temp/", "^thermal/cond", "^viscosity"};
  for (int k = 0; k < modify->nfix; k++) {
    const Fix *fix = modify->fix[k];
    const bool changes = std::any_of(std::begin(CHANGERS), std::end(CHANGERS), [fix](auto pattern) {
      return utils::strmatch(fix->style, pattern);
    });
    if (!changes || !(modify->fmask[k] & FixConst::END_OF_STEP)) continue;
    const bigint all = count_of(fix);
    if (all)
      error->all(
          FLERR, Error::NOLASTLINE,
          "Pair style sph/solid: fix {} of style {} changes velocities at the end of a step, "
          "before the heat of {} particles has been found from them: expected the velocity "
          "command between runs, or energy no",
          fix->id, fix->style, all);
  }
}

// fix may not move particles that fixes sph/solid, as far as they are known, move

void PairSPHSolid::require_apart(const Fix *fix)
{
  const bigint twice = count_particles(atom->nlocal, world, [this, fix](int i) {
    return (atom->mask[i] & fix->groupbit) && (atom->mask[i] & integrated);
  });
  if (twice)
    error->all(FLERR,
               "Pair style sph/solid: fix {} of style {} moves {} particles that a fix "
               "sph/solid moves too: expected one of the two per particle",
               fix->id, fix->style, twice);
}

void PairSPHSolid::require_single_layer()
{
  for (int i = 0; i < atom->nlocal; i++)
    if (std::fabs(atom->x[i][2]) > 1.0e-10 * domain->zprd)
      error->one(FLERR,
                 "Pair style sph/solid, dimension 2: particle {} has z = {}: expected a "
                 "single layer of particles at z = 0",
                 atom->tag[i], atom->x[i][2]);
}

// without an energy equation nothing may depend on the internal energy

void PairSPHSolid::require_cold_materials()
{
  for (int i = 1; i <= atom->ntypes; i++)
    if (setflag[i][i] && types[i].material.Gamma != 0.0)
      error->all(FLERR,
                 "Pair style sph/solid: the pressure of type {} depends on its internal energy, "
                 "Gamma = {}: expected energy yes, or eos mie-gruneisen with Gamma 0",
                 i, types[i].material.Gamma);
}

// the artificial stress compares the kernel of a pair with that at the spacing

void PairSPHSolid::require_crowding() const
{
  for (int i = 1; i <= atom->ntypes; i++)
    if (setflag[i][i] && SUPPORT * types[i].h <= types[i].spacing)
      error->all(FLERR,
                 "Pair style sph/solid, tensile artificial: the smoothing length of type {} is "
                 "{:.4g} spacings, and its kernel is 0 at the spacing: expected more than 0.5",
                 i, types[i].h / types[i].spacing);
  if (!options->mixed) return;
  for (int i = 1; i <= atom->ntypes; i++) {
    if (!setflag[i][i] || types[i].spacing == 0.0) continue;
    const double most = crowding<2>(0.0, types[i].h, types[i].spacing, options->tensile_n);
    if (!(most < MIXED_MOST))
      error->all(
          FLERR,
          "Pair style sph/solid, tensile artificial with precision mixed: (W(0)/W(spacing))^n "
          "of type {} is {:.4g}: expected less than {}, which single precision has room for",
          i, most, MIXED_MOST);
  }
}

// what precision mixed needs of smoothing lengths and units

void PairSPHSolid::require_single_numbers() const
{
  const double least = least_smoothing_length();
  double most = 0.0, reach = 0.0;
  for (int i = 1; i <= atom->ntypes; i++) {
    if (!setflag[i][i]) continue;
    reach = std::max({reach, 2.0 * types[i].h, options->hbar * types[i].spacing});
    most = std::max(most, types[i].h);
    const double volume = std::pow(types[i].spacing, domain->dimension),
                 mass = volume * types[i].material.rho0;
    if (volume == 0.0) continue;    // no particles
    // what sweeps compute with; of masses inverses of small parts
    for (const double number : {std::pow(types[i].h, domain->dimension + 2), mass * mass,
                                volume * types[i].h * types[i].material.longitudinal_modulus()})
      if (!(number > MIXED_LEAST && number < MIXED_MOST))
        error->all(
            FLERR,
            "Pair style sph/solid, precision mixed: in units {} the smoothing length {:.4g}, "
            "mass {:.4g} or modulus {:.4g} of the particles of type {} is beyond what single "
            "precision has room for: expected other units, or precision double",
            update->unit_style, types[i].h, mass, types[i].material.longitudinal_modulus(), i);
  }
  if (most > MIXED_LENGTHS * least)
    error->all(FLERR,
               "Pair style sph/solid, precision mixed: smoothing lengths of types are from {:.4g} "
               "to {:.4g}: expected a factor of at most {}",
               least, most, MIXED_LENGTHS);
  reach += neighbor->skin;
  if (reach > MIXED_REACH * least)
    error->all(FLERR,
               "Pair style sph/solid, precision mixed: neighbor lists reach {:.4g}, with the skin "
               "{:.4g}: expected at most {} of the least smoothing length, {:.4g}",
               reach, neighbor->skin, MIXED_REACH, MIXED_REACH * least);
}

// and of coordinates

void PairSPHSolid::require_near_origin() const
{
  const double furthest = MIXED_FURTHEST * least_smoothing_length();
  for (int k = 0; k < domain->dimension; k++)
    for (const double bound : {domain->boxlo[k], domain->boxhi[k]}) {
      const char axis = "xyz"[k];
      if (!(std::fabs(bound) < furthest))
        error->all(FLERR, Error::NOLASTLINE,
                   "Pair style sph/solid, precision mixed: the box reaches to {:.4g} along {} in "
                   "step {}: expected less than {:.4g}, {} of the least smoothing length",
                   bound, axis, update->ntimestep, furthest, MIXED_FURTHEST);
    }
}

double PairSPHSolid::least_smoothing_length() const
{
  double least = HUGE_VAL;
  for (int i = 1; i <= atom->ntypes; i++)
    if (setflag[i][i]) least = std::min(least, types[i].h);
  return least;
}

/* ----------------------------------------------------------------------
   before a run: numbers, and a mass that belongs to the volume.  Other atom styles, and "set volume"
   after masses have followed from volumes, make others
------------------------------------------------------------------------- */

void PairSPHSolid::require_plausible_state()
{
  bigint mine = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!has_material(i)) continue;
    const double *v = atom->v[i];
    if (!std::isfinite(v[0] + v[1] + v[2]))
      error->one(
          FLERR,
          "sph/solid: particle {} has the velocity {} {} {}: expected numbers. Commands that "
          "divide by masses, such as velocity create, need a 'run 0' or 'set ... mass' before",
          atom->tag[i], v[0], v[1], v[2]);
    const double share =
        reference_density(atom->rmass[i], atom->vfrac[i]) / types[atom->type[i]].material.rho0;
    if (share < 1.0 / ODD_MASS || share > ODD_MASS) mine++;
  }
  const bigint all = sum_over_ranks(mine, world);
  if (all && comm->me == 0)
    error->warning(FLERR,
                   "sph/solid: the mass of {} particles is less than half or more than twice their "
                   "volume times the density of their material: it has been set before (atom style "
                   "sphere does so), and is used as it is",
                   all);
  warn_odd_densities();
}

// they are pressure without a cause.  A body that begins under pressure has such densities as well,
// but a tenth is more than solids are prepared with

void PairSPHSolid::warn_odd_densities()
{
  bigint mine = 0;
  tagint first = MAXTAGINT, first_all = 0;
  double numbers[2] = {}, numbers_all[2] = {};    // of the first: density, mass over volume
  for (int i = 0; i < atom->nlocal; i++) {
    const double *s = own->stress[i];
    const double at_rest = reference_density(atom->rmass[i], atom->vfrac[i]);
    if (!has_material(i) || std::fabs(atom->rho[i] - at_rest) <= ODD_DENSITY * at_rest) continue;
    if (own->epl[i] != 0.0 || atom->esph[i] != 0.0) continue;
    if (std::any_of(s, s + 6, [](double component) {
          return component != 0.0;
        }))
      continue;
    mine++;
    if (atom->tag[i] > first) continue;
    first = atom->tag[i];
    numbers[0] = atom->rho[i];
    numbers[1] = at_rest;
  }
  const bigint all = sum_over_ranks(mine, world);
  if (!all) return;
  MPI_Allreduce(&first, &first_all, 1, MPI_LMP_TAGINT, MPI_MIN, world);
  if (first != first_all) numbers[0] = numbers[1] = 0.0;
  MPI_Allreduce(numbers, numbers_all, 2, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me == 0)
    error->warning(
        FLERR,
        "sph/solid: {} particles begin under pressure: their density is not mass over "
        "volume, at particle {} it is {:.6g} and not {:.6g}. Densities stay what they are "
        "when a mass or volume is set after the first run; 'set ... sph/rho 0' takes "
        "them anew",
        all, first_all, numbers_all[0], numbers_all[1]);
}

// when atoms moved between ranks or were added: everything has its state

void PairSPHSolid::require_state()
{
  for (int i = 0; i < atom->nlocal; i++) {
    if (!has_material(i)) continue;
    if (!(atom->vfrac[i] > 0.0) || !(atom->rmass[i] > 0.0) || !(atom->rho[i] > 0.0))
      error->one(
          FLERR, Error::NOLASTLINE,
          "sph/solid: particle {} at {:.8g} {:.8g} {:.8g} has volume {}, mass {} and density "
          "{} in step {}: expected values > 0. Particles cannot be added during a run (fix "
          "deposit): add them between runs and set their volume",
          atom->tag[i], atom->x[i][0], atom->x[i][1], atom->x[i][2], atom->vfrac[i], atom->rmass[i],
          atom->rho[i], update->ntimestep);
  }
}
