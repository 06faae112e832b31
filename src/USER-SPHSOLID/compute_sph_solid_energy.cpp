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

#include "compute_sph_solid_energy.h"

#include "atom.h"
#include "error.h"
#include "fix_sph_solid.h"
#include "fix_sph_solid_wall.h"
#include "pair_sph_solid.h"
#include "sph_solid_sweeps.h"
#include "update.h"

#include <vector>

using namespace LAMMPS_NS;

// the vector, in this order; the first three are sums over the group, the
// others over everything since the start
enum { KINETIC, INTERNAL, ELASTIC, PLASTIC, VISCOUS, RETURNED, WALL, HOURGLASS, NTERMS };

/* ----------------------------------------------------------------------
   compute ID group sph/solid/energy
------------------------------------------------------------------------- */

ComputeSPHSolidEnergy::ComputeSPHSolidEnergy(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), pair(nullptr)
{
  if (narg != 3)
    error->all(FLERR, 3, "Compute sph/solid/energy has no arguments, found '{}'", arg[3]);
  scalar_flag = vector_flag = 1;
  size_vector = NTERMS;
  extscalar = extvector = 1;
  vector = new double[NTERMS]();
}

ComputeSPHSolidEnergy::~ComputeSPHSolidEnergy()
{
  delete[] vector;
}

void ComputeSPHSolidEnergy::init()
{
  pair = PairSPHSolid::find(lmp, "Compute sph/solid/energy");
  pair->require_energy("Compute sph/solid/energy");
}

/* ----------------------------------------------------------------------
   kinetic plus internal energy plus what the walls took: a constant
------------------------------------------------------------------------- */

double ComputeSPHSolidEnergy::compute_scalar()
{
  invoked_scalar = update->ntimestep;
  if (invoked_vector != update->ntimestep) compute_vector();
  scalar = vector[KINETIC] + vector[INTERNAL] + vector[WALL];
  return scalar;
}

void ComputeSPHSolidEnergy::compute_vector()
{
  pair = PairSPHSolid::find_ready(lmp, "Compute sph/solid/energy");
  invoked_vector = update->ntimestep;
  std::vector<double> pending(atom->nlocal + 1, 0.0);
  if (auto *fix = FixSPHSolid::leader(lmp)) fix->pending_heat(pending.data());

  double mine[NTERMS] = {};
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit) || !pair->has_material(i)) continue;
    const double *v = atom->v[i];
    mine[KINETIC] += 0.5 * atom->rmass[i] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    mine[INTERNAL] += atom->rmass[i] * atom->esph[i] + pending[i];
    mine[ELASTIC] += pair->elastic_energy(i);
  }
  const SPHSolid::Ledger &ledger = pair->ledger();
  mine[PLASTIC] = ledger.plastic_work;
  mine[VISCOUS] = ledger.viscous_heat;
  mine[RETURNED] = ledger.returned;
  mine[HOURGLASS] = ledger.hourglass;
  MPI_Allreduce(mine, vector, NTERMS, MPI_DOUBLE, MPI_SUM, world);
  vector[WALL] = FixSPHSolidWall::energy_taken(lmp);
}
