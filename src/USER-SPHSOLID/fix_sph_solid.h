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
FixStyle(sph/solid,FixSPHSolid);
// clang-format on
#else

#ifndef LMP_FIX_SPH_SOLID_H
#define LMP_FIX_SPH_SOLID_H

#include "fix.h"

#include <cstdint>
#include <string>

namespace LAMMPS_NS {

class FixSPHSolid : public Fix {
 public:
  FixSPHSolid(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void initial_integrate(int) override;
  void pre_exchange() override;
  void final_integrate() override;
  void post_run() override;
  int modify_param(int, char **) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  // during a run, atom->esph lags half a step behind x and v: the heat of that half step,
  // in energy per particle, for output (all own atoms)
  void pending_heat(double *) const;

  // the fix that books heat for all of them: the first one defined
  static FixSPHSolid *leader(class LAMMPS *);

  // does any fix change the size or shape of the box?
  static bool drives_box(class LAMMPS *);

  // has another fix exchanged particles before the turn of this one?
  static bool exchanged_before(class LAMMPS *, const Fix *);

  // length of the step whose second half kick is not heated yet [time]
  double pending_step() const { return dt_pending; }

 private:
  class PairSPHSolid *pair;
  struct SPHSolidArrays *own;    // of the atom style
  bool leading;
  bool heat_on_the_way;    // the heat of a step is left to the next force evaluation
  double dt_pending;       // time step of the half kick that is not heated yet

  // between runs and in restart files nothing is pending: atom->esph has caught up, and what a run
  // that continues goes on from is in the atom style's esph_half, which goes where a particle goes
  bool caught_up;
  bool continues;                // the next run finds the state that the last one left
  std::uint64_t fingerprint;     // of that state
  std::uint64_t forces_mark;     // of the forces of the last step
  bool unsettled;                // a run has begun that continues if its first forces are the same
  bool heats_itself;             // they are not: the heat of the next half kick is not on the way
  std::string fixes_of_setup;    // names of all fixes when the last setup was

  static bool drives_box(const Fix *);
  static bool is_of_package(const Fix *);
  std::uint64_t state_fingerprint(const double *esph) const;
  std::uint64_t restart_fingerprint();
  void require_masses() const;
  void decide_to_continue();
  void catch_up();
  void go_back();
  void settle();
  void start_from_rest();
  void require_unchanged() const;
  std::string names_of_fixes() const;
  std::uint64_t mark_of_forces() const;
  bool moves_alone() const;
  void add_heat();
  void kick(int first, int end, double dtf);
  template <class Factor>
  void add_to_moved(int first, int end, double **to, double *const *from, Factor);
};

}    // namespace LAMMPS_NS

#endif
#endif
