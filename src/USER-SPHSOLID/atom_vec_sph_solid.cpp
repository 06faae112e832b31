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

#include "atom_vec_sph_solid.h"

#include "atom.h"
#include "error.h"

#include <map>
#include <memory>
#include <utility>

using namespace LAMMPS_NS;

// The arrays are freed through Atom::peratom after this class is gone (see
// ~AtomVec and, for hybrid, ~AtomVecHybrid), so they cannot be its members.
// One entry per Atom instance: LAMMPS may hold several (replicate, libraries).

static std::map<Atom *, std::unique_ptr<SPHSolidArrays>> registry;

static const char *const VHALF[] = {"sph_solid_vhalf_x", "sph_solid_vhalf_y", "sph_solid_vhalf_z"};

static bool is_registered(Atom *atom, const std::string &name)
{
  for (const auto &item : atom->peratom)
    if (item.name == name) return true;
  return false;
}

SPHSolidArrays *AtomVecSPHSolid::arrays(Atom *atom)
{
  const auto entry = registry.find(atom);
  // the arrays outlive the style, but nobody grows them any more
  const bool present = (entry != registry.end()) && atom->style_match("sph/solid");
  return present ? entry->second.get() : nullptr;
}

/* ---------------------------------------------------------------------- */

AtomVecSPHSolid::AtomVecSPHSolid(LAMMPS *lmp) : AtomVec(lmp), own(nullptr)
{
  molecular = Atom::ATOMIC;
  mass_type = PER_ATOM;

  atom->rmass_flag = 1;
  atom->vfrac_flag = 1;
  atom->rho_flag = 1;
  atom->esph_flag = 1;

  // Atom::peratom outlives its AtomVec: a second atom_style or read_restart
  // finds the names there already, with addresses that are still ours

  if (!is_registered(atom, "sph_solid_stress")) {
    registry[atom] = std::make_unique<SPHSolidArrays>();
    own = registry[atom].get();
    atom->add_peratom("sph_solid_stress", &own->stress, Atom::DOUBLE, 6);
    atom->add_peratom("sph_solid_epl", &own->epl, Atom::DOUBLE, 0);
    for (int k = 0; k < 3; k++) atom->add_peratom(VHALF[k], &own->vhalf[k], Atom::DOUBLE, 0);
    atom->add_peratom("sph_solid_rho_weight", &own->rho_weight, Atom::DOUBLE, 0);
    atom->add_peratom("sph_solid_esph_half", &own->esph_half, Atom::DOUBLE, 0);
  } else
    own = registry[atom].get();

  // strings with peratom variables to include in each AtomVec method
  // a new atom is all zero: the pair style takes mass and density from its card
  // what neighbors need every step travels in the pair style's own messages

  const std::vector<std::string> state = {"rmass",
                                          "vfrac",
                                          "rho",
                                          "esph",
                                          "sph_solid_stress",
                                          "sph_solid_epl",
                                          VHALF[0],
                                          VHALF[1],
                                          VHALF[2],
                                          "sph_solid_rho_weight",
                                          "sph_solid_esph_half"};

  fields_grow = state;
  fields_copy = state;
  fields_exchange = state;
  fields_restart = state;
  fields_create = state;
  fields_border = {"rmass", "rho", "sph_solid_rho_weight"};
  fields_border_vel = {"rmass", "rho", "sph_solid_rho_weight"};
  fields_data_atom = {"id", "type", "vfrac", "rmass", "rho", "esph", "x"};
  fields_data_vel = {"id", "v"};

  setup_fields();
}

/* ----------------------------------------------------------------------
   set local copies of all grow ptrs used by this class, except defaults
------------------------------------------------------------------------- */

void AtomVecSPHSolid::grow_pointers()
{
  own = registry[atom].get();
}

/* ----------------------------------------------------------------------
   modify what AtomVec::data_atom() just unpacked
   or initialize other atom quantities
------------------------------------------------------------------------- */

void AtomVecSPHSolid::data_atom_post(int ilocal)
{
  if (atom->vfrac[ilocal] < 0.0)
    error->one(FLERR, "Atom {} has volume {} in data file: expected a value >= 0",
               atom->tag[ilocal], atom->vfrac[ilocal]);
  if (atom->rmass[ilocal] < 0.0)
    error->one(FLERR, "Atom {} has mass {} in data file: expected a value >= 0", atom->tag[ilocal],
               atom->rmass[ilocal]);
  if (atom->rho[ilocal] < 0.0)
    error->one(FLERR, "Atom {} has density {} in data file: expected a value >= 0",
               atom->tag[ilocal], atom->rho[ilocal]);

  for (int k = 0; k < 6; k++) own->stress[ilocal][k] = 0.0;
  for (int k = 0; k < 3; k++) own->vhalf[k][ilocal] = 0.0;
  own->epl[ilocal] = 0.0;
  own->rho_weight[ilocal] = 0.0;
  own->esph_half[ilocal] = 0.0;
}

/* ----------------------------------------------------------------------
   a restart file has the energy that belongs to its positions and velocities
------------------------------------------------------------------------- */

void AtomVecSPHSolid::pack_restart_pre(int ilocal)
{
  if (own->swaps_energies) std::swap(atom->esph[ilocal], own->esph_half[ilocal]);
}

void AtomVecSPHSolid::pack_restart_post(int ilocal)
{
  pack_restart_pre(ilocal);
}

/* ----------------------------------------------------------------------
   assign an index to named atom property and return index
   return -1 if name is unknown to this atom style
------------------------------------------------------------------------- */

static const char *const PROPERTIES[] = {"rho",     "esph",    "epl",     "sdev_xx", "sdev_yy",
                                         "sdev_zz", "sdev_xy", "sdev_xz", "sdev_yz"};
static constexpr int NPROPERTIES = 9;

int AtomVecSPHSolid::property_atom(const std::string &name)
{
  for (int k = 0; k < NPROPERTIES; k++)
    if (name == PROPERTIES[k]) return k;
  return -1;
}

/* ----------------------------------------------------------------------
   pack per-atom data into buf for ComputePropertyAtom
   index maps to data specific to this atom style
------------------------------------------------------------------------- */

void AtomVecSPHSolid::pack_property_atom(int index, double *buf, int nvalues, int groupbit)
{
  int n = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    double value = 0.0;
    if (atom->mask[i] & groupbit) {
      if (index == 0)
        value = atom->rho[i];
      else if (index == 1)
        value = atom->esph[i];
      else if (index == 2)
        value = own->epl[i];
      else
        value = own->stress[i][index - 3];
    }
    buf[n] = value;
    n += nvalues;
  }
}
