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
#include "fix_sph_solid_wall.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "sph_solid_compat.h"
#include "sph_solid_eos.h"
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

// the end of the Lagrangian frame is looked for every so many steps
static constexpr int OVERLOAD_EVERY = 20;

/* ---------------------------------------------------------------------- */

PairSPHSolid::PairSPHSolid(LAMMPS *lmp) :
    Pair(lmp), options(nullptr), types(nullptr), sweeps(nullptr), kept(nullptr), partners(nullptr)
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
  message = STRESS;
  message_size = 0;
  resume = resumed = warned_lost = warned_overload = logged = false;
  integrated = 0;
  evaluated_own = evaluated_all = -1;
}

PairSPHSolid::~PairSPHSolid()
{
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
  delete_partners();
  delete options;
  delete[] types;
  delete sweeps;
  delete kept;
}

void PairSPHSolid::allocate()
{
  allocated = 1;
  const int n = atom->ntypes;
  memory->create(setflag, n + 1, n + 1, "pair:setflag");
  memory->create(cutsq, n + 1, n + 1, "pair:cutsq");
  for (int i = 1; i <= n; i++)
    for (int j = i; j <= n; j++) setflag[i][j] = 0;
  types = new TypeData[n + 1];
}

/* ----------------------------------------------------------------------
   one force evaluation: the sweeps, in order.  In a setup nothing is
   advanced: dt = 0 and forces follow from the state as it is
------------------------------------------------------------------------- */

void PairSPHSolid::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  if (vflag_atom || cvflag_atom)
    error->all(FLERR, Error::NOLASTLINE,
               "Pair style sph/solid has no per-atom virial: use compute sph/solid/atom sxx ...");

  const bool setup = update->setupflag != 0;
  const double dt = setup ? 0.0 : update->dt;
  if (neighbor->ago == 0) new_neighbors(setup);
  Particles p = particles();
  const NeighborRows list = rows();
  pack_kinematics(setup);

  const int unphysical = sweeps->gradient(p, list, dt);
  if (unphysical >= 0) stop_unphysical(unphysical);
  forward(STRESS, sweeps->stress_size());
  sweeps->mirror_stress();

  if (sweeps->sweeps_for_switch()) {
    sweeps->find_switch(list);
    forward(SWITCH, 1);
    sweeps->mirror_switch();
  }
  sweeps->force(p, list);
  if (sweeps->needs_correction()) {
    forward(VISCOUS, domain->dimension);
    sweeps->correction(p, list);
  }

  if (eflag_global)
    for (int ii = 0; ii < list.inum; ii++) {
      const int i = list.ilist[ii];
      eng_vdwl += p.mass[i] * p.e[i];
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
  require_state();
  if (!partners)
    sort_rows();
  else {
    if (setup && partners->anyone_without()) {
      neighbor->build_one(list);
      partners->refer(list, cutsq, setflag);
    }
    partners->find(setup, setflag);
  }
  sweeps->new_neighbors(particles(), rows(), cutforce + neighbor->skin);
}

NeighborRows PairSPHSolid::rows() const
{
  if (partners)
    return {partners->nown(), partners->own_list(), partners->counts(), partners->rows()};
  return {list->inum, list->ilist, list->numneigh, list->firstneigh};
}

void PairSPHSolid::create_partners()
{
  if (atom->map_style == Atom::MAP_NONE) {
    atom->map_init();
    atom->map_set();
    if (comm->me == 0) utils::logmesg(lmp, "sph/solid: switched on an atom map\n");
  }
  if (!partners)
    partners = dynamic_cast<FixSPHSolidPartners *>(
        modify->add_fix(std::string(PARTNERS_ID) + " all SPH/SOLID/PARTNERS"));
}

void PairSPHSolid::delete_partners()
{
  if (partners && modify->get_fix_by_id(PARTNERS_ID)) modify->delete_fix(PARTNERS_ID);
  partners = nullptr;
}

void PairSPHSolid::renew_reference(int groupbit)
{
  if (options->frame != Frame::LAGRANGIAN)
    error->all(FLERR, "Fix_modify reference: frame eulerian has no reference configuration");
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
  SPHSolidArrays *own = AtomVecSPHSolid::arrays(atom);
  resumed = setup && resume;
  resume = false;
  if (resumed) {
    forward(HALF_VELOCITY, 3);
  } else {
    std::copy(p.rho, p.rho + p.nall, p.rho_weight);
    for (int i = 0; i < p.nlocal; i++) std::copy(p.v[i], p.v[i] + 3, own->vhalf[i]);
  }
  sweeps->pack_kinematics(p, resumed ? own->vhalf : p.v);
}

/* ----------------------------------------------------------------------
   rows in the order of atom IDs: sums do not depend on where atoms are
   stored, so neither on ranks, sorting nor restarts
------------------------------------------------------------------------- */

void PairSPHSolid::sort_rows()
{
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
  SPHSolidArrays *own = AtomVecSPHSolid::arrays(atom);
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
             atom->rho[i], pressure(i), AtomVecSPHSolid::arrays(atom)->stress[i][0],
             AtomVecSPHSolid::arrays(atom)->stress[i][1],
             AtomVecSPHSolid::arrays(atom)->stress[i][2]);
}

// a particle with a history and no neighbor any more has left its body

void PairSPHSolid::warn_lost_neighbors()
{
  if (warned_lost) return;
  SPHSolidArrays *own = AtomVecSPHSolid::arrays(atom);
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const bool strained = own->epl[i] > 0.0 || own->stress[i][0] != 0.0;
    if (!strained || sweeps->neighbor_count(i) > 0) continue;
    error->warning(FLERR,
                   "sph/solid: particle {} at {:.8g} {:.8g} {:.8g} has lost all its neighbors by "
                   "step {}: its body is breaking up (further ones are not reported)",
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
  const Overload end = sweeps->find_overload(rows());
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
   global settings
------------------------------------------------------------------------- */

void PairSPHSolid::settings(int narg, char **arg)
{
  *options = parse_options(lmp, narg, arg);
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

  int count = 0;
  for (int i = std::max(ilo, jlo); i <= std::min(ihi, jhi); i++) {
    types[i].material = material;
    setflag[i][i] = 1;
    count++;
  }
  logged = false;
  if (count == 0)
    error->all(FLERR,
               "{}: a material belongs to one type: expected I = J or ranges with common "
               "types (pairs of types use the mean of both)",
               where);
}

/* ----------------------------------------------------------------------
   init specific to this pair style
------------------------------------------------------------------------- */

void PairSPHSolid::init_style()
{
  require_environment();
  require_one_integrator();
  if (domain->dimension == 2) require_single_layer();
  if (!options->energy) require_cold_materials();
  fill_unset_state();
  measure_spacing();

  if (!comm->ghost_velocity) {
    comm->ghost_velocity = 1;
    if (comm->me == 0) utils::logmesg(lmp, "sph/solid: switched on comm_modify vel yes\n");
  }
  if (!logged)
    for (int i = 1; i <= atom->ntypes; i++)
      if (setflag[i][i]) log_material(lmp, i, types[i].material, types[i].h, types[i].spacing);
  logged = true;
  warned_lost = warned_overload = false;

  if (sweeps) *kept = sweeps->ledger;
  delete sweeps;
  sweeps = Sweeps::create(domain->dimension, *options,
                          std::vector<TypeData>(types, types + atom->ntypes + 1))
               .release();
  sweeps->ledger = *kept;
  evaluated_own = evaluated_all = -1;
  sweeps->nthreads = comm->nthreads;
  comm_forward = std::max(3, sweeps->stress_size());    // the largest of all messages
  collect_planes();
  if (options->frame == Frame::LAGRANGIAN) {
    create_partners();
    neighbor->add_request(this, NeighConst::REQ_FULL | NeighConst::REQ_OCCASIONAL);
  } else {
    delete_partners();
    neighbor->add_request(this, NeighConst::REQ_FULL);
  }
}

void PairSPHSolid::require_environment()
{
  if (!AtomVecSPHSolid::arrays(atom))
    error->all(FLERR, "Pair style sph/solid needs atom_style sph/solid (alone or in hybrid)");
  if (atom->tag_enable == 0) error->all(FLERR, "Pair style sph/solid needs atom IDs");
  const std::string units = update->unit_style;
  if (units != "si" && units != "cgs" && units != "micro" && units != "nano" && units != "lj")
    error->all(FLERR, "Pair style sph/solid works in units si, cgs, micro, nano or lj, not in {}",
               units);
  if (update->whichflag == 2)
    error->all(FLERR, "Pair style sph/solid carries a history and cannot be minimized");
  if (!options) error->all(FLERR, "Pair style sph/solid has no settings");
  for (int i = 1; i <= atom->ntypes; i++)
    if (!setflag[i][i] && !force->pair_match("^hybrid", 0))
      error->all(FLERR,
                 "Pair style sph/solid: type {0} has no material: expected pair_coeff {0} {0} "
                 "<file> <material>",
                 i);
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

  for (const auto &fix : modify->get_fix_list())
    if (fix->time_integrate && strcmp(fix->style, "sph/solid") != 0) require_apart(fix);
}

// fix may not move particles that fixes sph/solid, as far as they are known, move

void PairSPHSolid::require_apart(const Fix *fix)
{
  int twice = 0, twice_all = 0;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & fix->groupbit) && (atom->mask[i] & integrated)) twice++;
  MPI_Allreduce(&twice, &twice_all, 1, MPI_INT, MPI_SUM, world);
  if (twice_all)
    error->all(FLERR,
               "Pair style sph/solid: fix {} of style {} moves {} particles that a fix "
               "sph/solid moves too: expected one of the two per particle",
               fix->id, fix->style, twice_all);
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
                 "Gamma = {}: expected energy yes, or gamma 0",
                 i, types[i].material.Gamma);
}

/* ----------------------------------------------------------------------
   mass and density from the card, unless the user set them
------------------------------------------------------------------------- */

void PairSPHSolid::fill_unset_state()
{
  SPHSolidArrays *own = AtomVecSPHSolid::arrays(atom);
  for (int i = 0; i < atom->nlocal; i++) {
    const int t = atom->type[i];
    if (!setflag[t][t]) continue;
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

// when atoms moved between ranks or were added: everything has its state

void PairSPHSolid::require_state()
{
  for (int i = 0; i < atom->nlocal; i++) {
    const int t = atom->type[i];
    if (!setflag[t][t]) continue;
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
    types[i].h = types[i].material.h > 0.0 ? types[i].material.h : options->h;
    types[i].spacing = std::pow(largest[i], 1.0 / domain->dimension);
  }
}

void PairSPHSolid::collect_planes()
{
  std::vector<Plane> planes;
  double reach = 0.0;
  for (int i = 1; i <= atom->ntypes; i++) reach = std::max(reach, 2.0 * types[i].h);
  for (const auto &fix : modify->get_fix_list()) {
    auto *wall = dynamic_cast<FixSPHSolidWall *>(fix);
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
  double cut = 0.5 * SPHSolid::SUPPORT * (types[i].h + types[j].h);
  if (options->viscosity == Viscosity::CORRECT)
    cut = std::max(cut, 0.5 * options->hbar * (types[i].spacing + types[j].spacing));
  return cut;
}

/* ----------------------------------------------------------------------
   messages to ghosts
------------------------------------------------------------------------- */

void PairSPHSolid::forward(int what, int size)
{
  message = what;
  message_size = size;
  comm->forward_comm(this, size);
}

int PairSPHSolid::pack_forward_comm(int n, int *atoms, double *buf, int, int *)
{
  int m = 0;
  for (int k = 0; k < n; k++) {
    const double *from = outgoing(atoms[k]);
    for (int a = 0; a < message_size; a++) buf[m++] = from[a];
  }
  return m;
}

void PairSPHSolid::unpack_forward_comm(int n, int first, double *buf)
{
  const Particles p = particles();
  for (int i = first; i < first + n; i++, buf += message_size) {
    if (message == STRESS)
      sweeps->unpack_stress(p, i, buf);
    else
      std::copy(buf, buf + message_size, const_cast<double *>(outgoing(i)));
  }
}

// where the data of the present message lie for particle i

const double *PairSPHSolid::outgoing(int i) const
{
  if (message == STRESS) return sweeps->stress_row(i);
  if (message == SWITCH) return sweeps->viscosity_switch(i);
  if (message == VISCOUS) return sweeps->viscous_acceleration(i);
  if (message == DISPLACEMENT) return sweeps->displacement(i);
  return AtomVecSPHSolid::arrays(atom)->vhalf[i];
}

/* ----------------------------------------------------------------------
   for the fixes and computes
------------------------------------------------------------------------- */

PairSPHSolid *PairSPHSolid::find(LAMMPS *lmp, const char *caller)
{
  auto *pair = dynamic_cast<PairSPHSolid *>(lmp->force->pair_match("sph/solid", 1));
  if (!pair)
    lmp->error->all(FLERR, "{} needs pair style sph/solid, once (alone or in hybrid)", caller);
  return pair;
}

void PairSPHSolid::pair_heat(double v_scale, double a_scale, double *heat, bool book)
{
  const Particles p = particles();
  for (int i = 0; i < p.nlocal; i++) {
    double *u = sweeps->displacement(i);
    const double a = (atom->mask[i] & integrated) ? a_scale / p.mass[i] : 0.0;
    for (int k = 0; k < domain->dimension; k++) u[k] = v_scale * p.v[i][k] + a * p.f[i][k];
  }
  forward(DISPLACEMENT, domain->dimension);
  sweeps->heat(p, rows(), heat, book);
}

double PairSPHSolid::time_step_limit() const
{
  return sweeps->time_step_limit(particles(), rows());
}

double PairSPHSolid::usual_courant_number() const
{
  return SPHSolid::usual_courant_number(options->frame);
}

bool PairSPHSolid::has_energy() const
{
  return options->energy;
}

void PairSPHSolid::require_energy(const char *what) const
{
  if (!options->energy)
    error->all(FLERR, "{} needs an energy equation: expected pair_style sph/solid ... energy yes",
               what);
}

void PairSPHSolid::require_current(const char *what) const
{
  if (evaluated_own != atom->nlocal || evaluated_all != atom->nlocal + atom->nghost)
    error->all(FLERR, Error::NOLASTLINE,
               "{} needs the forces of the last step, and a command since then has changed the "
               "particles or their order: expected a 'run 0' before",
               what);
}

bool PairSPHSolid::has_material(int i) const
{
  const int t = atom->type[i];
  return setflag[t][t] != 0;
}

double PairSPHSolid::pressure(int i) const
{
  const double rho_ref = reference_density(atom->rmass[i], atom->vfrac[i]);
  return SPHSolid::pressure(types[atom->type[i]].material, atom->rho[i], rho_ref, atom->esph[i]).P;
}

void PairSPHSolid::cauchy_stress(int i, double *six) const
{
  const double P = pressure(i);
  const double *deviator = AtomVecSPHSolid::arrays(atom)->stress[i];
  for (int k = 0; k < 6; k++) six[k] = deviator[k] - (k < 3 ? P : 0.0);
}

double PairSPHSolid::von_mises(int i) const
{
  const double *s = AtomVecSPHSolid::arrays(atom)->stress[i];
  const double diagonal = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  return std::sqrt(1.5 * diagonal + 3.0 * shear);
}

// distortion S:S/(4 mu) and volume change P^2/(2K), times the present volume

double PairSPHSolid::elastic_energy(int i) const
{
  const Material &m = types[atom->type[i]].material;
  const double *s = AtomVecSPHSolid::arrays(atom)->stress[i];
  const double diagonal = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  const double P = pressure(i);
  const double per_volume =
      (diagonal + 2.0 * shear) / (4.0 * m.shear) + P * P / (2.0 * m.bulk_modulus());
  return per_volume * atom->rmass[i] / atom->rho[i];
}

double PairSPHSolid::sound_speed(int i) const
{
  const double rho_ref = reference_density(atom->rmass[i], atom->vfrac[i]);
  const double c2 =
      SPHSolid::pressure(types[atom->type[i]].material, atom->rho[i], rho_ref, atom->esph[i]).c2;
  return std::sqrt(std::max(c2, 0.0));
}

double PairSPHSolid::smoothing_length(int i) const
{
  return types[atom->type[i]].h;
}

int PairSPHSolid::neighbor_count(int i) const
{
  return sweeps->neighbor_count(i);
}

Ledger &PairSPHSolid::ledger()
{
  return sweeps ? sweeps->ledger : *kept;
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

void PairSPHSolid::write_restart_settings(FILE *fp)
{
  fwrite(options, sizeof(Options), 1, fp);
}

void PairSPHSolid::read_restart_settings(FILE *fp)
{
  if (comm->me == 0) utils::sfread(FLERR, options, sizeof(Options), 1, fp, nullptr, error);
  MPI_Bcast(options, sizeof(Options), MPI_BYTE, 0, world);
}

double PairSPHSolid::memory_usage()
{
  return sweeps ? sweeps->memory_usage() : 0.0;
}
