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

#ifdef PAIR_CLASS
// clang-format off
PairStyle(sph/solid,PairSPHSolid);
// clang-format on
#else

#ifndef LMP_PAIR_SPH_SOLID_H
#define LMP_PAIR_SPH_SOLID_H

#include "atom.h"
#include "pair.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace SPHSolid {
enum class Message;
class Sweeps;
struct Ledger;
struct NeighborRows;
struct Options;
struct Particles;
struct TypeData;
}    // namespace SPHSolid

namespace LAMMPS_NS {

class PairSPHSolid : public Pair {
 public:
  PairSPHSolid(class LAMMPS *);
  ~PairSPHSolid() override;

  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  void init_list(int, class NeighList *) override;
  double init_one(int, int) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  double memory_usage() override;

  // for the fixes and computes of this package; all refer to the last force evaluation

  // heat[i] = energy the pair forces give to own atom i while all atoms move by
  // v_scale*v + a_scale*f/m; heat null: add it to their energies and to the energy ledger
  void pair_heat(double v_scale, double a_scale, double *heat);

  // the same, found on the way where the frame can (sph_solid_sweeps.h): keep_heat() before a
  // run says whether it can; leave_heat() before the kick leaves it to the next evaluation;
  // add_left_heat() after the drift adds what was left so, if there is any
  bool keep_heat(bool);
  void leave_heat(double factor);
  void add_left_heat();

  // stop unless the last force evaluation belongs to the particles as they are;
  // what: what needs it, for the message
  void require_current(const char *what) const;

  // use the stored half-step velocities in the next setup: the state is the
  // one the last run or the restart file left behind
  void continue_from_half_step() { resume = true; }

  // the last evaluation was a setup that continued a run
  bool has_resumed() const { return resumed; }

  // store the velocities of the last evaluation, for a setup that continues: at the end of a run,
  // for a restart file, and before pair_heat() takes their place
  void keep_half_step();

  bool has_energy() const;                    // is there an energy equation?
  void require_energy(const char *) const;    // stop if not; for whom, for the message
  bool moves(int) const;                      // does a fix sph/solid move own atom i?
  bool kicks(int) const;                      // or one that kicks as it does?
  bool has_material(int i) const              // of own atom i: in a hybrid, others may have none
  {
    const int t = atom->type[i];
    return setflag[t][t] != 0;
  }
  double time_step_limit() const;    // own atoms, Courant number 1 [time]
  // those of fix sph/solid/dt auto; want_courant_number() before a run, or it is not looked for
  double usual_time_step_limit() const;
  double usual_courant_number() const;
  void want_courant_number() { resonance_wanted = true; }
  std::uint64_t numerics_mark() const;    // a number that changes with the numerics
  void cauchy_stress(int, double *) const;
  double pressure(int) const;
  double plastic_strain(int) const;
  double von_mises(int) const;
  double elastic_energy(int) const;
  double sound_speed(int) const;
  bool gives_way(int) const;    // is it compressed so far that its equation of state has ended?
  double smoothing_length(int) const;
  double largest_smoothing_length() const;
  int neighbor_count(int) const;
  SPHSolid::Ledger &ledger();

  // particles of a group take the configuration of the next run as reference
  void renew_reference(int groupbit);

  // the one pair style sph/solid of a run; caller: who asks, for the message
  static PairSPHSolid *find(class LAMMPS *, const char *caller);
  // the same between runs, when it may be gone or new: one that a run has set up, or nullptr
  static PairSPHSolid *ready(class LAMMPS *);
  // that one, or stop
  static PairSPHSolid *find_ready(class LAMMPS *, const char *caller);

 private:
  std::unique_ptr<SPHSolid::Options> options;
  std::vector<SPHSolid::TypeData> types;    // one per atom type, from 1
  struct SPHSolidArrays *own;               // of the atom style
  std::unique_ptr<SPHSolid::Sweeps> sweeps;
  std::unique_ptr<SPHSolid::Ledger> kept;    // energy ledger, while the sweeps are built anew

  class FixSPHSolidPartners *partners;    // of the Lagrangian frame, else nullptr
  bool partners_gone;                     // somebody has deleted that fix

  SPHSolid::Message message;    // what the next one carries
  bool message_of_sweeps;       // else it is velocities at the half step
  double displacement_time;     // displacements of a message over velocities
  bool resume;                  // the next setup continues where the last run ended
  bool resumed;                 // the last evaluation was such a setup
  bool half_step_kept;          // its velocities are stored, if there was one
  bool
      rounds_half_steps;    // of mixed precision, with walls: velocities are kept as they are in every step
  int integrated;      // group bits of all fix sph/solid
  int kicked;          // and of fixes that kick by force over mass as well
  bool warned_lost;    // warn once per run
  bool warned_overload, warned_compression;
  int evaluated_own, evaluated_all;    // particles of the last evaluation, -1: none
  bool logged;                         // the materials are in the log
  bool apart_logged;                   // and types that do not act on each other
  bool uncorrected_logged;             // and how many particles have no gradient correction
  int list_threads;                    // each has pages of its own in the neighbor list

  void allocate();
  void require_environment();
  void require_one_integrator();
  void warn_idle_velocities();
  void require_apart(const class Fix *);
  bigint count_of(const class Fix *);
  void require_heat_first();
  void require_kept_velocities();
  void require_single_layer();
  void require_cold_materials();
  void require_crowding() const;
  void require_single_numbers() const;
  void require_near_origin() const;
  double least_smoothing_length() const;
  void fill_unset_state();
  void require_state();
  void require_plausible_state();
  void warn_odd_densities();
  void measure_spacing();
  void collect_planes();
  void want_map();
  double largest_cutoff();
  std::vector<double> cutoffs();
  std::vector<double> smoothing_lengths() const;
  void create_partners();
  void leave_partners();
  void delete_partners();
  void require_partners() const;
  void new_neighbors(bool);
  void log_uncorrected();
  void log_bodies();
  void log_apart();
  bool has_unlike_materials() const;
  void empty_list();
  void require_countable_neighbors() const;
  void require_distinct_places() const;
  static void give_back_freed_memory();
  void pack_kinematics(bool);
  void swap_half_step();
  void store_half_step();
  void stop_unphysical(int);
  void warn_lost_neighbors();
  void report_overload();
  void stop_torn();
  void warn_compression();
  SPHSolid::Particles particles() const;
  SPHSolid::NeighborRows rows() const;
  // the largest stable step of the reference, in pair_sph_solid_resonance.cpp
  bool resonance_wanted;
  std::uint64_t resonance_of;    // mark of the bodies that courant_number belongs to, 0: none
  double courant_number;
  std::vector<double> limit_factors;    // of types, empty: all particles have the same h/c
  std::uint64_t mark_of_bodies() const;
  void find_courant_number();
  void measure_resonance();
  void start_vibration(int i, double *u) const;
  double vibration_norm(const std::vector<double> &) const;
  void elastic_forces(const std::vector<double> &u, std::vector<double> &f);
  void take_courant_number(double rate);
  void find_limit_factors(double h_over_c);

  void forward(SPHSolid::Message);
  void add_box_velocity(int n, int size, const int *atoms, double *buf, const int *pbc) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
