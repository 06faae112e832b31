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

// Entry point of sphsolidplugin.so: makes the styles of this package known to a LAMMPS that was
// built without it, by "plugin load sphsolidplugin.so" or through LAMMPS_PLUGIN_PATH.

#include "lammpsplugin.h"

#include "atom.h"
#include "lammps.h"
#include "library.h"
#include "version.h"

#include "atom_vec_sph_solid.h"
#include "compute_sph_solid_atom.h"
#include "compute_sph_solid_energy.h"
#include "fix_sph_solid.h"
#include "fix_sph_solid_dt.h"
#include "fix_sph_solid_partners.h"
#include "fix_sph_solid_wall.h"
#include "pair_sph_solid.h"

#include <string>

using namespace LAMMPS_NS;

template <class Style> static void *create(void *lmp)
{
  return new Style((LAMMPS *) lmp);
}

template <class Style> static void *create(void *lmp, int narg, char **arg)
{
  return new Style((LAMMPS *) lmp, narg, arg);
}

static AtomVec *create_atom_style(LAMMPS *lmp)
{
  return new AtomVecSPHSolid(lmp);
}

/* ----------------------------------------------------------------------
   LAMMPS checks none of this: a plugin compiled for another release, other
   integer sizes or another kind of MPI would load and then corrupt memory.
   Only the C interface, which stays the same, may be used before it passes.
   Returns what does not fit, or nothing.
------------------------------------------------------------------------- */

static std::string mismatch(void *lmp)
{
  const int host_version = lammps_version(lmp);
  if (host_version != SPHSOLID_LMP_VERSION)
    return "it was compiled for LAMMPS " + std::to_string(SPHSOLID_LMP_VERSION) + ", this is " +
        std::to_string(host_version);

  if ((lammps_extract_setting(lmp, "tagint") != (int) sizeof(tagint)) ||
      (lammps_extract_setting(lmp, "imageint") != (int) sizeof(imageint)) ||
      (lammps_extract_setting(lmp, "bigint") != (int) sizeof(bigint)))
    return "it was compiled for other integer sizes (LAMMPS_SIZES)";

#if defined(MPI_STUBS)
  constexpr int mpi_size = 0;
#else
  constexpr int mpi_size = sizeof(MPI_Comm);
#endif
  // the size of an MPI handle differs between libraries, 0 stands for a LAMMPS without MPI
  if (lammps_config_has_mpi_support() != mpi_size)
    return "it was compiled with another MPI library, or one of both without MPI";

  auto *atom = ((LAMMPS *) lmp)->atom;
  auto entry = atom->avec_map->find("sph/solid");
  if ((entry != atom->avec_map->end()) && (entry->second != &create_atom_style))
    return "this LAMMPS has the package USER-SPHSOLID already";
  return "";
}

/* ---------------------------------------------------------------------- */

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *regfunc)
{
  const std::string problem = mismatch(lmp);
  if (!problem.empty()) {
    if (lammps_extract_setting(lmp, "world_rank") == 0)
      lammps_error(lmp, 0, ("Ignoring sphsolidplugin.so: " + problem).c_str());
    return;
  }

  const auto register_plugin = (lammpsplugin_regfunc) regfunc;
  lammpsplugin_t plugin;
  plugin.version = LAMMPS_VERSION;
  plugin.author = "the USER-SPHSOLID developers";
  plugin.handle = handle;

  plugin.style = "pair";
  plugin.name = "sph/solid";
  plugin.info = "SPH of elastic-plastic solids";
  plugin.creator.v1 = &create<PairSPHSolid>;
  register_plugin(&plugin, lmp);

  plugin.style = "fix";
  plugin.info = "Time integration of sph/solid";
  plugin.creator.v2 = &create<FixSPHSolid>;
  register_plugin(&plugin, lmp);

  plugin.name = "sph/solid/dt";
  plugin.info = "Time step of sph/solid";
  plugin.creator.v2 = &create<FixSPHSolidDt>;
  register_plugin(&plugin, lmp);

  plugin.name = "sph/solid/wall";
  plugin.info = "Plane walls for sph/solid";
  plugin.creator.v2 = &create<FixSPHSolidWall>;
  register_plugin(&plugin, lmp);

  plugin.name = "SPH/SOLID/PARTNERS";
  plugin.info = "Reference configuration of sph/solid";
  plugin.creator.v2 = &create<FixSPHSolidPartners>;
  register_plugin(&plugin, lmp);

  plugin.style = "compute";
  plugin.name = "sph/solid/atom";
  plugin.info = "Per-particle output of sph/solid";
  plugin.creator.v2 = &create<ComputeSPHSolidAtom>;
  register_plugin(&plugin, lmp);

  plugin.name = "sph/solid/energy";
  plugin.info = "Energy balance of sph/solid";
  plugin.creator.v2 = &create<ComputeSPHSolidEnergy>;
  register_plugin(&plugin, lmp);

  // Atom styles are not among the kinds that LAMMPS registers for plugins, but the map is public.
  // "replicate" builds a new map and therefore does not find it.
  (*((LAMMPS *) lmp)->atom->avec_map)["sph/solid"] = &create_atom_style;
}
