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

#include "fix_sph_solid_dt.h"

#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "output.h"
#include "pair_sph_solid.h"
#include "sph_solid_points.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ----------------------------------------------------------------------
   fix ID group sph/solid/dt <every> <cfl>|auto [max v] [min v]
------------------------------------------------------------------------- */

FixSPHSolidDt::FixSPHSolidDt(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg), pair(nullptr)
{
  if (narg < 5) utils::missing_cmd_args(FLERR, "fix sph/solid/dt", error);
  nevery = utils::inumeric(FLERR, arg[3], false, lmp);
  const bool usual = strcmp(arg[4], "auto") == 0, is_number = utils::is_double(arg[4]);
  cfl = is_number ? utils::numeric(FLERR, arg[4], false, lmp) : 0.0;    // 0: auto
  if (nevery <= 0)
    error->all(FLERR, 3, "Fix sph/solid/dt: every is {}: expected an integer > 0", arg[3]);
  if (!usual && !(cfl > 0.0))
    error->all(FLERR, 4, "Fix sph/solid/dt: cfl is '{}': expected a number > 0 or auto", arg[4]);

  dt_max = dt_min = 0.0;
  for (int iarg = 5; iarg < narg; iarg += 2) {
    const bool is_max = strcmp(arg[iarg], "max") == 0;
    if (!is_max && strcmp(arg[iarg], "min") != 0)
      error->all(FLERR, iarg, "Fix sph/solid/dt: unknown keyword '{}': expected max or min",
                 arg[iarg]);
    if (iarg + 2 > narg)
      utils::missing_cmd_args(FLERR, std::string("fix sph/solid/dt ") + arg[iarg], error);
    const double value = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
    if (!(value > 0.0))
      error->all(FLERR, iarg + 1, "Fix sph/solid/dt: {} is {}: expected a time step > 0", arg[iarg],
                 arg[iarg + 1]);
    (is_max ? dt_max : dt_min) = value;
  }
  if (dt_max > 0.0 && dt_min > dt_max)
    error->all(FLERR, "Fix sph/solid/dt: min {} is larger than max {}", dt_min, dt_max);

  scalar_flag = 1;
  global_freq = 1;
  extscalar = 0;
  dynamic_group_allow = 1;
  warned = warned_cfl = false;
}

int FixSPHSolidDt::setmask()
{
  return END_OF_STEP;
}

void FixSPHSolidDt::init()
{
  pair = PairSPHSolid::find(lmp, "Fix sph/solid/dt");
  warned = false;
  if (cfl == 0.0) pair->want_courant_number();
}

// a setup that continues a run keeps that run's time step until it is due

void FixSPHSolidDt::setup(int)
{
  if (cfl > SPHSolid::LARGEST_COURANT_NUMBER && !warned_cfl && comm->me == 0)
    error->warning(FLERR,
                   "Fix sph/solid/dt: cfl is {:.6g}, more than elastic bodies bear: expected auto "
                   "or a number up to {}",
                   cfl, SPHSolid::LARGEST_COURANT_NUMBER);
  warned_cfl = true;
  if (!pair->has_resumed()) end_of_step();
}

/* ----------------------------------------------------------------------
   the sequence of fix dt/reset: the elapsed time is booked before dt changes
------------------------------------------------------------------------- */

void FixSPHSolidDt::end_of_step()
{
  double mine = cfl > 0.0 ? pair->time_step_limit() : pair->usual_time_step_limit();
  double dt = 0.0;
  MPI_Allreduce(&mine, &dt, 1, MPI_DOUBLE, MPI_MIN, world);
  if (dt >= SPHSolid::NO_LIMIT)    // no particles
    return take(dt_max > 0.0 ? dt_max : update->dt);
  dt *= cfl > 0.0 ? cfl : pair->usual_courant_number();
  if (!std::isfinite(dt) || dt <= 0.0)
    error->all(
        FLERR, Error::NOLASTLINE,
        "Fix sph/solid/dt: the time step limit in step {} is {}: expected a finite value > 0",
        update->ntimestep, dt);
  if (dt_max > 0.0 && dt > dt_max) dt = dt_max;
  if (dt_min > 0.0 && dt < dt_min) {
    if (!warned && comm->me == 0)
      error->warning(
          FLERR,
          "Fix sph/solid/dt: the stable time step {:.6g} in step {} is below min {:.6g}, "
          "which is used: the run may become unstable",
          dt, update->ntimestep, dt_min);
    warned = true;
    dt = dt_min;
  }
  take(dt);
}

void FixSPHSolidDt::take(double dt)
{
  if (dt == update->dt) return;
  update->update_time();
  update->dt = dt;
  update->dt_default = 0;
  if (force->pair) force->pair->reset_dt();
  for (int k = 0; k < modify->nfix; k++) modify->fix[k]->reset_dt();
  output->reset_dt();
}

double FixSPHSolidDt::compute_scalar()
{
  return update->dt;
}
