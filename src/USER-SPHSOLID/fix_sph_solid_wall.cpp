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

#include "fix_sph_solid_wall.h"

#include "atom.h"
#include "atom_vec_sph_solid.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_sph_solid.h"
#include "modify.h"
#include "pair_sph_solid.h"
#include "sph_solid_blocks.h"
#include "sph_solid_images.h"
#include "sph_solid_space.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

// so far behind a contact wall a particle may be between runs, in smoothing lengths: it has landed there with a step that became
// another one on the way
static constexpr double BEHIND = 1.0e-3;

// a reaction brings particles to rest on the plane over steps of its own length, and slows them
// down over others; from three times as long ones it would throw them back faster than they came
static constexpr double LONGER = 2.0;

/* ----------------------------------------------------------------------
   fix ID group sph/solid/wall <xlo|...|zhi> <position> [contact|symmetry]
------------------------------------------------------------------------- */

FixSPHSolidWall::FixSPHSolidWall(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair(nullptr)
{
  if (narg < 5) utils::missing_cmd_args(FLERR, "fix sph/solid/wall", error);
  static const char *const SIDES[] = {"xlo", "xhi", "ylo", "yhi", "zlo", "zhi"};
  int side = -1;
  for (int k = 0; k < 6; k++)
    if (strcmp(arg[3], SIDES[k]) == 0) side = k;
  if (side < 0)
    error->all(FLERR, 3,
               "Fix sph/solid/wall: unknown side '{}': expected xlo, xhi, ylo, yhi, zlo "
               "or zhi",
               arg[3]);
  dim = side / 2;
  normal = (side % 2) ? -1.0 : 1.0;
  plane = utils::numeric(FLERR, arg[4], false, lmp);

  symmetry = false;
  if (narg > 5) {
    symmetry = strcmp(arg[5], "symmetry") == 0;
    if (!symmetry && strcmp(arg[5], "contact") != 0)
      error->all(FLERR, 5, "Fix sph/solid/wall: unknown kind '{}': expected contact or symmetry",
                 arg[5]);
  }
  if (narg > 6)
    error->all(FLERR, 6, "Fix sph/solid/wall: found '{}' after the last argument", arg[6]);
  if (dim == 2 && domain->dimension == 2)
    error->all(FLERR, 3, "Fix sph/solid/wall: side {} does not exist in two dimensions", arg[3]);
  require_open_box(3);

  scalar_flag = vector_flag = 1;
  size_vector = 3;
  extscalar = extvector = 1;
  global_freq = 1;
  restart_global = 1;
  dynamic_group_allow = 1;
  kick_booked = false;
  booked = work = reaction_v = reaction_a = reaction = dt_used = held = 0.0;
  added = true;
}

// where: of the message in the input line

void FixSPHSolidWall::require_open_box(int where) const
{
  if (domain->periodicity[dim])
    error->all(FLERR, where,
               "Fix sph/solid/wall: the box is periodic across side {}{}: expected a boundary f, s "
               "or m",
               "xyz"[dim], normal > 0.0 ? "lo" : "hi");
}

int FixSPHSolidWall::setmask()
{
  return INITIAL_INTEGRATE | POST_FORCE;
}

void FixSPHSolidWall::init()
{
  pair = PairSPHSolid::find(lmp, "Fix sph/solid/wall");
  require_open_box(Error::NOLASTLINE);    // change_box may have come since
  reactions.clear();
  dt_used = 0.0;
}

void FixSPHSolidWall::setup(int)
{
  kick_booked = false;
  held = symmetry ? SPHSolid::ON_PLANE * pair->largest_smoothing_length() : 0.0;
  if (!pair->has_resumed() || added) require_in_front();
  added = false;
  constrain(pair->has_resumed() ? CONTINUE : START);
  reset_dt();    // a command may have changed it between two runs
}

// the time step is another one than these reactions are for (or becomes so in the setup of a later
// fix): the rest of the step, half a kick, with reactions anew

void FixSPHSolidWall::reset_dt()
{
  if (dt_used == 0.0) return;    // the setup is still to come
  pair = PairSPHSolid::ready(lmp);
  if (!pair) return;    // it is gone, and the next run will say so
  // in the middle of a kick, only if it must be: the heat of its halves is that of one force
  const double ratio = update->dt / dt_used, most = kicked ? LONGER : 1.0;
  if (ratio <= most && ratio >= 1.0 / most) return;
  react_anew();
}

void FixSPHSolidWall::react_anew()
{
  for (const Reaction &r : reactions) atom->f[r.i][dim] -= normal * r.force;
  constrain(START);
}

// a run that seemed to continue finds other forces: its first kick begins at the velocities of the moment.
// This fix may have booked its work already

void FixSPHSolidWall::begin_anew()
{
  react_anew();
  if (!kick_booked) return;
  work -= booked;
  book_kick();
}

void FixSPHSolidWall::require_in_front() const
{
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit) || !pair->has_material(i)) continue;
    const double y = normal * (atom->x[i][dim] - plane);
    if (y < -(symmetry ? SPHSolid::ON_PLANE : BEHIND) * pair->smoothing_length(i))
      error->one(
          FLERR, Error::NOLASTLINE,
          "Fix sph/solid/wall {}: particle {} at {:.8g} {:.8g} {:.8g} lies behind the wall at "
          "{}",
          id, atom->tag[i], atom->x[i][0], atom->x[i][1], atom->x[i][2], plane);
  }
}

// the second half kick of the last force evaluation happens now, with this dt

void FixSPHSolidWall::initial_integrate(int)
{
  book_kick();
  kick_booked = true;
}

void FixSPHSolidWall::book_kick()
{
  const double dt = update->dt;
  booked = 0.5 * dt * (reaction_v + 0.25 * dt * reaction_a);
  work += booked;
}

void FixSPHSolidWall::post_force(int)
{
  kick_booked = false;
  constrain(STEP);
}

/* ----------------------------------------------------------------------
   a particle whose step would cross the plane lands on it instead:
   a_n = (-y/dt - v_n)/dt, with y the distance and v_n the velocity at the
   half step (the first step of a run makes half a kick only: twice that, v_n at the step).
   Symmetry holds what is on the plane; its images are in the pair style
------------------------------------------------------------------------- */

void FixSPHSolidWall::constrain(Phase phase)
{
  const auto *mover = FixSPHSolid::leader(lmp);
  const double dt = (phase == CONTINUE && mover) ? mover->pending_step() : update->dt;
  const double *vhalf = AtomVecSPHSolid::arrays(atom)->vhalf[dim];
  const Step step = {phase, dt, phase == START ? 0.5 : 1.0, phase == CONTINUE ? vhalf : nullptr};
  reaction = reaction_v = reaction_a = 0.0;
  reactions.clear();
  dt_used = dt;
  kicked = phase != START;

  for (int first = 0; first < atom->nlocal; first += SPHSolid::LANES) {
    if (all_pass(step, first)) continue;
    const int end = std::min(first + SPHSolid::LANES, atom->nlocal);
    for (int i = first; i < end; i++) constrain(step, i);
  }
}

// of LANES particles from the first one on, is each away from the plane and on its side after the
// step?  No number is: then they are looked at one by one

bool FixSPHSolidWall::all_pass(const Step &step, int first) const
{
  using namespace SPHSolid;
  if (first + LANES > atom->nlocal) return false;
  auto along = [this, first](const double *const *of) {
    Pack components[SPACE];
    load_components<SPACE>(of[first], components);
    return components[dim];
  };
  const Pack y = normal * (along(atom->x) - plane),
             vn = normal * (step.vhalf ? load(step.vhalf + first) : along(atom->v));
  const Pack next = step.distance(load(atom->rmass + first), y, vn, normal * along(atom->f));
  const Pack apart = maximum(y, -y) - held;
  return all_positive(next) && all_positive(apart);
}

void FixSPHSolidWall::constrain(const Step &step, int i)
{
  double **f = atom->f;
  const double dt = step.dt, share = step.share, mass = atom->rmass[i];
  const double y = normal * (atom->x[i][dim] - plane);
  const double vn = normal * (step.vhalf ? step.vhalf[i] : atom->v[i][dim]),
               fn = normal * f[i][dim];
  const bool away = step.distance(mass, y, vn, fn) >= 0.0;
  if (away && std::fabs(y) >= held) return;
  if (!(atom->mask[i] & groupbit) || !pair->moves(i) || !pair->has_material(i)) return;
  if (away && std::fabs(y) >= SPHSolid::ON_PLANE * pair->smoothing_length(i)) return;

  const double an = fn / mass;
  const double landing = (-y / dt - vn) / (share * dt);
  const double R = mass * (landing - an);
  f[i][dim] = normal * mass * landing;

  // work on the half kick of this step, and what the next one needs
  const bool stepping = step.phase == STEP;
  if (stepping) work += 0.5 * dt * R * (vn + 0.25 * dt * landing);
  const double v_full = stepping ? vn + 0.5 * dt * landing : normal * atom->v[i][dim];
  reactions.push_back({i, R});
  reaction += R;
  reaction_v += R * v_full;
  reaction_a += R * landing;
}

/* ----------------------------------------------------------------------
   scalar: work done by the wall; vector: its force on the bodies
------------------------------------------------------------------------- */

double FixSPHSolidWall::compute_scalar()
{
  double all = 0.0;
  MPI_Allreduce(&work, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

double FixSPHSolidWall::compute_vector(int k)
{
  if (k != dim) return 0.0;
  double all = 0.0;
  MPI_Allreduce(&reaction, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return normal * all;
}

double FixSPHSolidWall::energy_taken(LAMMPS *lmp)
{
  double sum = 0.0;
  for (const auto &fix : lmp->modify->get_fix_list())
    if (auto *wall = dynamic_cast<FixSPHSolidWall *>(fix)) sum -= wall->compute_scalar();
  return sum;
}

/* ----------------------------------------------------------------------
   restart: the work so far, and which wall did it; the pending sums follow from the setup
------------------------------------------------------------------------- */

void FixSPHSolidWall::write_restart(FILE *fp)
{
  const double list[4] = {compute_scalar(), static_cast<double>(dim), normal, plane};
  if (comm->me == 0) {
    int size = sizeof(list);
    fwrite(&size, sizeof(int), 1, fp);
    fwrite(list, sizeof(double), 4, fp);
  }
}

void FixSPHSolidWall::restart(char *buf)
{
  double list[4];
  std::memcpy(list, buf, sizeof(list));
  work = (comm->me == 0) ? list[0] : 0.0;
  added =
      !(list[1] == dim && list[2] == normal && list[3] == plane);    // another wall of that name
}
