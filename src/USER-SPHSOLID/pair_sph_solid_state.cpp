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

// What pair style sph/solid tells the fixes and computes of this package: heat, energies, stresses, the
// time step limit, all of the last force evaluation

#include "pair_sph_solid.h"

#include "atom.h"
#include "atom_vec_sph_solid.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "neighbor.h"
#include "sph_solid_eos.h"
#include "sph_solid_fingerprint.h"
#include "sph_solid_invariants.h"
#include "sph_solid_ranks.h"
#include "sph_solid_sweeps.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHSolid;

/* ---------------------------------------------------------------------- */

PairSPHSolid *PairSPHSolid::find(LAMMPS *lmp, const char *caller)
{
  auto *pair = dynamic_cast<PairSPHSolid *>(lmp->force->pair_match("sph/solid", 1));
  if (!pair)
    lmp->error->all(FLERR, "{} needs pair style sph/solid, once (alone or in hybrid)", caller);
  return pair;
}

// between runs pair_style commands can take the pair style away or make a new one

PairSPHSolid *PairSPHSolid::ready(LAMMPS *lmp)
{
  auto *pair = dynamic_cast<PairSPHSolid *>(lmp->force->pair_match("sph/solid", 1));
  if (!pair || !pair->sweeps) return nullptr;
  pair->own = AtomVecSPHSolid::arrays(lmp->atom);    // replicate makes another Atom
  return pair->own ? pair : nullptr;
}

PairSPHSolid *PairSPHSolid::find_ready(LAMMPS *lmp, const char *caller)
{
  PairSPHSolid *pair = ready(lmp);
  if (!pair)
    lmp->error->all(FLERR, Error::NOLASTLINE,
                    "{} needs pair style sph/solid as a run has set it up: expected it to stay, or "
                    "a 'run 0' with the new one before",
                    caller);
  pair->require_partners();
  return pair;
}

void PairSPHSolid::pair_heat(double v_scale, double a_scale, double *heat)
{
  const Particles p = particles();
  sweeps->displace(p, Kick{v_scale, a_scale, atom->mask, kicked});
  displacement_time = v_scale;
  forward(Message::DISPLACEMENT);
  sweeps->heat(p, rows(), v_scale, heat);
}

bool PairSPHSolid::keep_heat(bool wanted)
{
  sweeps->keeps_heat = wanted && sweeps->can_keep_heat();
  return sweeps->keeps_heat;
}

void PairSPHSolid::leave_heat(double factor)
{
  sweeps->due = factor;
}

void PairSPHSolid::add_left_heat()
{
  if (!(sweeps->due > 0.0)) return;
  comm->forward_comm();    // as if this were a step without new neighbors
  const Particles p = particles();
  sweeps->pack_kinematics(p, p.v);
  sweeps->add_due_heat(p, rows());
}

double PairSPHSolid::time_step_limit() const
{
  return sweeps->time_step_limit(particles(), rows());
}

double PairSPHSolid::usual_courant_number() const
{
  return partners ? courant_number : EULERIAN_COURANT_NUMBER;
}

std::uint64_t PairSPHSolid::numerics_mark() const
{
  const Options &o = *options;
  Fingerprint print(1);
  for (const double value : {o.h, o.a1, o.a2, o.hbar, o.tensile_eps, o.tensile_n, o.hourglass})
    print.add(value);
  for (const int value :
       {static_cast<int>(o.frame), static_cast<int>(o.viscosity), static_cast<int>(o.weights),
        static_cast<int>(o.heating), o.corrected ? 1 : 0, o.tensile ? 1 : 0, o.energy ? 1 : 0,
        o.mixed ? 1 : 0})
    print.add(value);
  for (int t = 1; t <= atom->ntypes; t++) {
    if (!setflag[t][t]) continue;
    const Material &m = types[t].material;
    for (const double value : {m.rho0, m.C, m.S, m.Gamma, m.K, m.shear, m.Y, m.H, m.h})
      print.add(value);
    print.add(static_cast<int>(m.eos));
    print.add(static_cast<int>(m.strength));
  }
  for (const Plane &plane : sweeps->images.all_planes()) {
    print.add(plane.dim);
    print.add(plane.position);
  }
  // neigh_modify exclude
  for (int k = 0; k < neighbor->nex_type; k++)
    for (const int type : {neighbor->ex1_type[k], neighbor->ex2_type[k]}) print.add(type);
  for (int k = 0; k < neighbor->nex_group; k++)
    for (const int group : {neighbor->ex1_group[k], neighbor->ex2_group[k]}) print.add(group);
  return print.value();
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
  if (evaluated_own < 0)
    error->all(FLERR, Error::NOLASTLINE,
               "{} needs the forces of the last step, which a new run and commands such as "
               "write_restart and write_data forget: expected a 'run 0' before",
               what);
  // a command may have changed those of some ranks only
  const bool changed = evaluated_own != atom->nlocal ||
      evaluated_all != atom->nlocal + atom->nghost;
  if (on_any_rank(changed, world))
    error->all(FLERR, Error::NOLASTLINE,
               "{} needs the forces of the last step, and a command since then has changed the "
               "particles or their order: expected a 'run 0' before",
               what);
}

static PressureState<> equation_of_state(const std::vector<TypeData> &types, const Atom *atom,
                                         int i)
{
  const double rho_ref = reference_density(atom->rmass[i], atom->vfrac[i]);
  return pressure(types[atom->type[i]].material, atom->rho[i], rho_ref, atom->esph[i]);
}

double PairSPHSolid::pressure(int i) const
{
  return equation_of_state(types, atom, i).P;
}

void PairSPHSolid::cauchy_stress(int i, double *six) const
{
  const double P = pressure(i);
  const double *deviator = own->stress[i];
  for (int k = 0; k < 6; k++) six[k] = deviator[k] - (k < 3 ? P : 0.0);
}

double PairSPHSolid::plastic_strain(int i) const
{
  return own->epl[i];
}

double PairSPHSolid::von_mises(int i) const
{
  return SPHSolid::von_mises(own->stress[i]);
}

double PairSPHSolid::elastic_energy(int i) const
{
  const Material &m = types[atom->type[i]].material;
  return elastic_energy_density(m, own->stress[i], pressure(i)) * atom->rmass[i] / atom->rho[i];
}

double PairSPHSolid::sound_speed(int i) const
{
  return std::sqrt(std::max(equation_of_state(types, atom, i).c2, 0.0));
}

// further compression would meet no resistance: with a constant Gamma, and a cubic for the shock line, the
// equation of state ends at 1.7 to 1.9 times the density at rest (doc/limits.rst)

bool PairSPHSolid::gives_way(int i) const
{
  constexpr double OFTEN = 1.1;    // up to here it is not looked at, which takes a division
  return atom->rho[i] * atom->vfrac[i] > OFTEN * atom->rmass[i] &&
      !(equation_of_state(types, atom, i).c2 > 0.0);
}

bool PairSPHSolid::moves(int i) const
{
  return (atom->mask[i] & integrated) != 0;
}

bool PairSPHSolid::kicks(int i) const
{
  return (atom->mask[i] & kicked) != 0;
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

double PairSPHSolid::memory_usage()
{
  return sweeps ? sweeps->memory_usage() : 0.0;
}
