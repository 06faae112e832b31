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

// What pair style sph/solid does before a run: commands, materials, checks, symmetry
// planes, restart files.  The force evaluation is in pair_sph_solid.cpp

#include "pair_sph_solid.h"

#include "atom.h"
#include "atom_vec_sph_solid.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_sph_solid_wall.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "sph_solid_kernel.h"
#include "sph_solid_material_card.h"
#include "sph_solid_options.h"
#include "sph_solid_sweeps.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHSolid;

void PairSPHSolid::allocate()
{
  allocated = 1;
  const int n = atom->ntypes;
  memory->create(setflag, n + 1, n + 1, "pair:setflag");
  memory->create(cutsq, n + 1, n + 1, "pair:cutsq");
  for (int i = 1; i <= n; i++)
    for (int j = i; j <= n; j++) setflag[i][j] = 0;
  types.resize(n + 1);
}

/* ----------------------------------------------------------------------
   global settings
------------------------------------------------------------------------- */

void PairSPHSolid::settings(int narg, char **arg)
{
  *options = parse_options(lmp, narg, arg);
  comm_forward = LARGEST_MESSAGE;    // a hybrid copies it now and never asks again
  if (options->frame == Frame::LAGRANGIAN) want_map();
}

/* ----------------------------------------------------------------------
   set coeffs for one or more types: a material belongs to one type
------------------------------------------------------------------------- */

void PairSPHSolid::coeff(int narg, char **arg)
{
  if (narg < 3)
    error->all(FLERR,
               "pair_coeff sph/solid: expected I J <file> <material> [keyword values] or "
               "I J inline <keyword values>");
  if (!allocated) allocate();
  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);

  Material material;
  const bool from_card = strcmp(arg[2], "inline") != 0;
  const std::string where = std::string("pair_coeff ") + arg[0] + " " + arg[1] + " sph/solid";
  if (from_card) {
    if (narg < 4)
      error->all(FLERR, "{}: card '{}' needs the name of a material after it", where, arg[2]);
    std::string units;
    const auto words = read_card(lmp, arg[2], arg[3], units);
    parse_material(lmp, material, words, units, where + ", card '" + arg[2] + "'");
  }
  const std::vector<std::string> words(arg + (from_card ? 4 : 3), arg + narg);
  parse_material(lmp, material, words, update->unit_style, where);
  check_material(lmp, material, where);

  const int first = std::max(ilo, jlo), last = std::min(ihi, jhi);
  if (first > last)
    error->all(FLERR,
               "{}: a material belongs to one type: expected I = J or ranges with common "
               "types (pairs of types use the mean of both)",
               where);
  // pairs of these types, too: a hybrid has to know that they act on each other
  for (int i = first; i <= last; i++) {
    types[i].material = material;
    for (int j = i; j <= last; j++) setflag[i][j] = 1;
  }
  logged = apart_logged = false;
  resonance_of = 0;
}

/* ----------------------------------------------------------------------
   init specific to this pair style
------------------------------------------------------------------------- */

void PairSPHSolid::init_style()
{
  if (!compute_flag)
    error->all(FLERR, Error::NOLASTLINE,
               "Pair style sph/solid: 'pair_modify compute no' leaves particles without stress: "
               "expected compute yes");
  require_environment();
  require_one_integrator();
  if (domain->dimension == 2) require_single_layer();
  if (!options->energy) require_cold_materials();
  fill_unset_state();
  require_plausible_state();
  measure_spacing();
  if (options->tensile) require_crowding();
  if (options->mixed) require_single_numbers();

  if (!comm->ghost_velocity) {
    comm->ghost_velocity = 1;
    if (comm->me == 0) utils::logmesg(lmp, "sph/solid: switched on comm_modify vel yes\n");
  }
  if (!logged)
    for (int i = 1; i <= atom->ntypes; i++)
      if (setflag[i][i] && types[i].spacing > 0.0)
        log_material(lmp, i, types[i].material, types[i].h, types[i].spacing);
  logged = true;
  warned_lost = warned_overload = warned_compression = resonance_wanted = false;
  resume = false;    // fix sph/solid will say so, whose init() comes later

  if (sweeps) *kept = sweeps->ledger;
  sweeps = Sweeps::create(domain->dimension, *options, types);
  sweeps->ledger = *kept;
  evaluated_own = evaluated_all = -1;
  sweeps->nthreads = comm->nthreads;
  sweeps->limits_step = !modify->get_fix_by_style("^sph/solid/dt$").empty();
  comm_forward = std::max(3, sweeps->message_size(Message::STRESS));    // the largest one
  collect_planes();
  if (options->frame == Frame::LAGRANGIAN) {
    create_partners();
    neighbor->add_request(this, NeighConst::REQ_FULL | NeighConst::REQ_OCCASIONAL);
  } else {
    delete_partners();
    neighbor->add_request(this, NeighConst::REQ_FULL);
  }
}

// when the list is made, not in every run

void PairSPHSolid::init_list(int id, NeighList *made)
{
  Pair::init_list(id, made);
  list_threads = comm->nthreads;
}

/* ----------------------------------------------------------------------
   mass and density from the card, unless the user set them
------------------------------------------------------------------------- */

void PairSPHSolid::fill_unset_state()
{
  for (int i = 0; i < atom->nlocal; i++) {
    if (!has_material(i)) continue;
    const int t = atom->type[i];
    if (!(atom->vfrac[i] > 0.0))
      error->one(FLERR,
                 "sph/solid: particle {} of type {} has no volume: expected a command like "
                 "'set group all volume V' before the run",
                 atom->tag[i], t);
    if (atom->rmass[i] == 0.0) atom->rmass[i] = types[t].material.rho0 * atom->vfrac[i];
    if (atom->rho[i] == 0.0) atom->rho[i] = atom->rmass[i] / atom->vfrac[i];
    if (own->rho_weight[i] == 0.0) own->rho_weight[i] = atom->rho[i];
  }
}

/* ----------------------------------------------------------------------
   spacing of a type: from its largest volume, since particles on a face of
   the body carry half a cell only
------------------------------------------------------------------------- */

void PairSPHSolid::measure_spacing()
{
  const int n = atom->ntypes + 1;
  std::vector<double> mine(n, 0.0), largest(n, 0.0);
  for (int i = 0; i < atom->nlocal; i++)
    mine[atom->type[i]] = std::max(mine[atom->type[i]], atom->vfrac[i]);
  MPI_Allreduce(mine.data(), largest.data(), n, MPI_DOUBLE, MPI_MAX, world);
  for (int i = 1; i < n; i++) {
    const double of_card = types[i].material.h;
    types[i].h = !setflag[i][i] ? 0.0 : of_card > 0.0 ? of_card : options->h;    // 0: no material
    types[i].spacing = std::pow(largest[i], 1.0 / domain->dimension);
  }
}

void PairSPHSolid::collect_planes()
{
  std::vector<Plane> planes;
  double reach = 0.0;
  rounds_half_steps = false;
  for (int i = 1; i <= atom->ntypes; i++) reach = std::max(reach, 2.0 * types[i].h);
  for (const auto &fix : modify->get_fix_list()) {
    auto *wall = dynamic_cast<FixSPHSolidWall *>(fix);
    if (wall && options->mixed) rounds_half_steps = true;
    if (!wall || !wall->is_symmetry()) continue;
    for (const auto &other : planes)
      if (other.dim == wall->dimension() &&
          std::fabs(other.position - wall->position()) <= 2.0 * reach)
        error->all(FLERR,
                   "fix sph/solid/wall {}: parallel symmetry planes at {} and {} are closer "
                   "than twice the kernel support {}",
                   wall->id, other.position, wall->position(), reach);
    planes.push_back({wall->dimension(), wall->position()});
  }
  sweeps->images.set_planes(planes);
}

/* ----------------------------------------------------------------------
   init for one type pair i,j and corresponding j,i: the kernel's support
------------------------------------------------------------------------- */

double PairSPHSolid::init_one(int i, int j)
{
  const bool lagrangian = options->frame == Frame::LAGRANGIAN;
  const double support = lagrangian ? SPHSolid::PARTNER_SUPPORT : SPHSolid::SUPPORT;
  double cut = 0.5 * support * (types[i].h + types[j].h);
  if (options->viscosity == Viscosity::CORRECT)
    cut = std::max(cut, 0.5 * options->hbar * (types[i].spacing + types[j].spacing));
  return cut;
}

/* ----------------------------------------------------------------------
   restart
------------------------------------------------------------------------- */

void PairSPHSolid::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  for (int i = 1; i <= atom->ntypes; i++) {
    fwrite(&setflag[i][i], sizeof(int), 1, fp);
    fwrite(&types[i].material, sizeof(Material), 1, fp);
  }
}

void PairSPHSolid::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();
  for (int i = 1; i <= atom->ntypes; i++) {
    if (comm->me == 0) {
      utils::sfread(FLERR, &setflag[i][i], sizeof(int), 1, fp, nullptr, error);
      utils::sfread(FLERR, &types[i].material, sizeof(Material), 1, fp, nullptr, error);
    }
    MPI_Bcast(&setflag[i][i], 1, MPI_INT, 0, world);
    MPI_Bcast(&types[i].material, sizeof(Material), MPI_BYTE, 0, world);
  }
}

// settings and materials are written as they lie in memory: a number to change with them, and sizes

static constexpr int LAYOUT[3] = {3, sizeof(Options), sizeof(Material)};

void PairSPHSolid::write_restart_settings(FILE *fp)
{
  fwrite(LAYOUT, sizeof(int), 3, fp);
  fwrite(options.get(), sizeof(Options), 1, fp);
}

void PairSPHSolid::read_restart_settings(FILE *fp)
{
  int layout[3];
  if (comm->me == 0) utils::sfread(FLERR, layout, sizeof(int), 3, fp, nullptr, error);
  MPI_Bcast(layout, 3, MPI_INT, 0, world);
  if (!std::equal(layout, layout + 3, LAYOUT))
    error->all(FLERR,
               "Pair style sph/solid: the settings in the restart file have layout {} with {} and "
               "{} bytes, expected {} with {} and {}: the file was written by another version of "
               "the package. Go on with that one, or from a data file",
               layout[0], layout[1], layout[2], LAYOUT[0], LAYOUT[1], LAYOUT[2]);
  if (comm->me == 0) utils::sfread(FLERR, options.get(), sizeof(Options), 1, fp, nullptr, error);
  MPI_Bcast(options.get(), sizeof(Options), MPI_BYTE, 0, world);
  comm_forward = LARGEST_MESSAGE;
  if (options->frame == Frame::LAGRANGIAN) want_map();
}

// partners are found by their IDs.  Early, since others (fix balance) ask once whether there is a map

void PairSPHSolid::want_map()
{
  if (atom->map_style != Atom::MAP_NONE || !atom->tag_enable) return;
  if (!modify->get_fix_by_style("^balance").empty())
    error->all(
        FLERR,
        "Pair style sph/solid, frame lagrangian, needs an atom map that fix balance knows "
        "of: expected 'atom_modify map yes' before the box, or pair_style before fix balance");
  if (domain->box_exist) {
    atom->map_init();
    atom->map_set();
  } else
    atom->map_style = atom->map_user = Atom::MAP_YES;
  if (comm->me == 0) utils::logmesg(lmp, "sph/solid: switched on an atom map\n");
}
