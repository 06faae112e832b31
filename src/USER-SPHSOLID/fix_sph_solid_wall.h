/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(sph/solid/wall,FixSPHSolidWall);
// clang-format on
#else

#ifndef LMP_FIX_SPH_SOLID_WALL_H
#define LMP_FIX_SPH_SOLID_WALL_H

#include "fix.h"

#include <vector>

namespace LAMMPS_NS {

class FixSPHSolidWall : public Fix {
 public:
  FixSPHSolidWall(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void post_force(int) override;
  void reset_dt() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  // the first kick of a run has other forces than the last one of the run before (fix sph/solid)
  void begin_anew();

  bool is_symmetry() const { return symmetry; }
  int dimension() const { return dim; }
  double position() const { return plane; }

  // energy that all walls have taken from the bodies so far
  static double energy_taken(class LAMMPS *);

 private:
  class PairSPHSolid *pair;
  int dim;          // direction of the normal
  double normal;    // +1: the body lies above the plane, -1: below
  double plane;
  bool symmetry;
  double held;    // symmetry: no particle further away than this lies on the plane

  double work;                      // done by the wall on the bodies, this rank
  double booked;                    // of it in the last initial_integrate()
  bool kick_booked;                 // and post_force() has not come since
  double reaction_v, reaction_a;    // of the half kick to come: sums of R v and R a
  double reaction;                  // total normal force, this rank
  bool added;                       // since the last run
  double dt_used;                   // time step that the present reactions are for
  bool kicked = false;              // and half a kick has been made with them
  struct Reaction {
    int i;
    double force;    // along the normal
  };
  std::vector<Reaction> reactions;    // of own particles

  enum Phase { START, CONTINUE, STEP };
  struct Step {
    Phase phase;
    double dt, share;
    const double *vhalf;    // stored velocities along the normal; null: those of atom->v
    // from the plane after the step, times mass, of one particle or a vector of them
    template <class Real> Real distance(Real mass, Real y, Real vn, Real fn) const
    {
      return mass * (y + dt * vn) + share * dt * dt * fn;
    }
  };
  void constrain(Phase);
  void react_anew();
  void book_kick();
  bool all_pass(const Step &, int first) const;
  void constrain(const Step &, int i);
  void require_open_box(int where) const;
  void require_in_front() const;
};

}    // namespace LAMMPS_NS

#endif
#endif
