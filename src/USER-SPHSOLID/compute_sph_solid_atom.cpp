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

#include "compute_sph_solid_atom.h"

#include "atom.h"
#include "error.h"
#include "fix_sph_solid.h"
#include "memory.h"
#include "pair_sph_solid.h"
#include "update.h"

#include <algorithm>
#include <cstring>
#include <numeric>

using namespace LAMMPS_NS;

enum { RHO, P, E, C, EPL, VONMISES, SXX, SYY, SZZ, SXY, SXZ, SYZ, H, NEIGH, NQUANTITIES };
static const char *const NAMES[] = {"rho", "p",   "e",   "c",   "epl", "vonmises", "sxx",
                                    "syy", "szz", "sxy", "sxz", "syz", "h",        "neigh"};

/* ----------------------------------------------------------------------
   compute ID group sph/solid/atom <name ...>
------------------------------------------------------------------------- */

ComputeSPHSolidAtom::ComputeSPHSolidAtom(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), pair(nullptr), which(nullptr), pending(nullptr)
{
  if (narg < 4) utils::missing_cmd_args(FLERR, "compute sph/solid/atom", error);
  nvalues = narg - 3;
  which = new int[nvalues];
  needs_pending = false;
  for (int n = 0; n < nvalues; n++) {
    const char *name = arg[n + 3];
    which[n] = -1;
    for (int k = 0; k < NQUANTITIES; k++)
      if (strcmp(name, NAMES[k]) == 0) which[n] = k;
    if (strcmp(name, "damage") == 0 || strcmp(name, "temp") == 0)
      error->all(FLERR, n + 3,
                 "Compute sph/solid/atom: {} is not available: no material model of "
                 "this version has it",
                 name);
    if (which[n] < 0)
      error->all(
          FLERR, n + 3, "Compute sph/solid/atom: unknown name '{}': expected one of{}", name,
          std::accumulate(NAMES, NAMES + NQUANTITIES, std::string(), [](auto list, auto next) {
            return list + " " + next;
          }));
    if (which[n] == E) needs_pending = true;
  }

  peratom_flag = 1;
  size_peratom_cols = (nvalues == 1) ? 0 : nvalues;
  nmax = 0;
}

ComputeSPHSolidAtom::~ComputeSPHSolidAtom()
{
  delete[] which;
  memory->destroy(vector_atom);
  memory->destroy(array_atom);
  memory->destroy(pending);
}

void ComputeSPHSolidAtom::init()
{
  pair = PairSPHSolid::find(lmp, "Compute sph/solid/atom");
  if (needs_pending) pair->require_energy("Compute sph/solid/atom e");
}

/* ---------------------------------------------------------------------- */

void ComputeSPHSolidAtom::compute_peratom()
{
  pair = PairSPHSolid::find_ready(lmp, "Compute sph/solid/atom");
  invoked_peratom = update->ntimestep;
  if (atom->nmax > nmax) {
    nmax = atom->nmax;
    memory->destroy(vector_atom);
    memory->destroy(array_atom);
    memory->destroy(pending);
    if (nvalues == 1)
      memory->create(vector_atom, nmax, "sph/solid/atom:vector");
    else
      memory->create(array_atom, nmax, nvalues, "sph/solid/atom:array");
    if (needs_pending) memory->create(pending, nmax, "sph/solid/atom:pending");
  }
  if (needs_pending) {
    std::fill(pending, pending + atom->nlocal, 0.0);
    if (auto *fix = FixSPHSolid::leader(lmp)) fix->pending_heat(pending);
  }
  for (int n = 0; n < nvalues; n++)
    if (which[n] == NEIGH) pair->require_current("Compute sph/solid/atom neigh");

  for (int i = 0; i < atom->nlocal; i++) {
    const bool mine = (atom->mask[i] & groupbit) && pair->has_material(i);
    double stress[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    if (mine) pair->cauchy_stress(i, stress);
    for (int n = 0; n < nvalues; n++) {
      double &out = (nvalues == 1) ? vector_atom[i] : array_atom[i][n];
      out = mine ? value(which[n], i, stress) : 0.0;
    }
  }
}

double ComputeSPHSolidAtom::value(int quantity, int i, const double *stress) const
{
  switch (quantity) {
    case RHO:
      return atom->rho[i];
    case P:
      return pair->pressure(i);
    case E:
      return atom->esph[i] + pending[i] / atom->rmass[i];
    case C:
      return pair->sound_speed(i);
    case EPL:
      return pair->plastic_strain(i);
    case VONMISES:
      return pair->von_mises(i);
    case H:
      return pair->smoothing_length(i);
    case NEIGH:
      return pair->neighbor_count(i);
    default:
      return stress[quantity - SXX];
  }
}

double ComputeSPHSolidAtom::memory_usage()
{
  return (double) nmax * (nvalues + (needs_pending ? 1 : 0)) * sizeof(double);
}
