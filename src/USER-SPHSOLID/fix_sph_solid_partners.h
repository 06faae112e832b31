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
FixStyle(SPH/SOLID/PARTNERS,FixSPHSolidPartners);
// clang-format on
#else

#ifndef LMP_FIX_SPH_SOLID_PARTNERS_H
#define LMP_FIX_SPH_SOLID_PARTNERS_H

#include "fix.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace SPHSolid {
struct Ledger;
}

namespace LAMMPS_NS {

// reference configuration of the Lagrangian frame: position and volume of every
// particle there, and the IDs of its partners.  Created by pair style sph/solid;
// follows the particles across ranks and into restart files

class FixSPHSolidPartners : public Fix {
 public:
  double **xref;    // reference position, as many numbers as dimensions, own and ghost [length]
  double *vref;     // reference volume, own and ghost [length^D]
  bool *gone;       // somebody's flag, set when this fix is deleted; nullptr: nobody's

  // of the pair style that is gone, for the next one.  While there is one, this fix does nothing
  std::unique_ptr<SPHSolid::Ledger> kept_ledger;

  FixSPHSolidPartners(class LAMMPS *, int, char **);
  ~FixSPHSolidPartners() override;
  int setmask() override;
  void init() override;
  void setup_pre_exchange() override;
  void pre_exchange() override;
  void post_run() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  // particles of a group are without reference from now on
  void forget(int groupbit);
  // stop unless IDs, box and smoothing lengths are those of the reference, and nobody looks for partners
  // further away than it did (h, reach: of types, from 1)
  void require_same(const std::vector<double> &h, const std::vector<double> &reach);
  // give those without one the present configuration; list: full neighbor list,
  // setflag[t][t]: has type t a material; h, reach: of types, from 1, as above
  bool anyone_without(int **setflag) const;
  void refer(class NeighList *list, double **cutsq, int **setflag, const std::vector<double> &h,
             const std::vector<double> &reach);
  // local indices of the partners of own particles, in the order of IDs; setup:
  // partners may have been deleted before
  void find(bool setup, int **setflag);
  // are all particles and ghosts where find() saw them last?  Never in a periodic box, where the
  // nearest images of partners may have changed
  bool in_place() const;

  // the bodies that the particles with a reference form, which act on each other nowhere
  struct Bodies {
    std::vector<bigint> sizes;    // numbers of particles, descending
    bigint mixed_pairs;           // partners of different types
  };
  Bodies bodies() const;

  // after find(): stop if a plane across dimension d passes between partners
  void require_on_one_side(int d, double plane, double tolerance) const;

  // after find(): nobody reads rows any more.  Are they gone?
  bool forget_rows();

  // how often references or partners have changed
  int changes() const { return nchanges; }

  int nown() const { return static_cast<int>(own.size()); }
  int *own_list() { return own.data(); }
  int *counts() { return count.data(); }
  int **rows() { return row.data(); }

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_border(int, int *, double *) override;
  int unpack_border(int, int, double *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  double memory_usage() override;

 private:
  int *npartner;       // number of partners, -1: no reference yet
  tagint *self;        // own ID in the reference
  tagint **partner;    // their IDs, ascending
  float *href;         // smoothing length: in single precision another one is still another one
  const int dim;
  int nchanges;
  int maxpartner;       // columns of partner
  bool reach_is_new;    // the ghost cutoff has grown, and Comm does not know yet
  // lengths of the box that belong to the reference, 0 where it is not periodic
  std::vector<double> lengths;
  std::vector<double>
      reach_then;    // of types, from 1: partners are all up to there; empty: unknown

  // local view, valid until particles move between ranks
  int nlocal;    // particles, or -1
  std::vector<int> own, count, index;
  std::uint64_t seen;    // fingerprint of the IDs of all particles when this was found
  std::vector<int *> row;

  void widen(int);
  std::uint64_t fingerprint_of_ids() const;
  bool needs_reference(int i, int **setflag) const;
  void require_reach(const std::vector<double> &reach, const std::vector<int> &have_partners) const;
  std::vector<int> types_with_partners() const;
  void present_partners(class NeighList *list, int ii, double **cutsq,
                        std::vector<tagint> &found) const;
  int where(tagint) const;
  int where_own(tagint) const;
  std::vector<tagint> partners_elsewhere() const;
  bool cuts_body(int groupbit) const;
  std::vector<tagint> of_all_ranks(std::vector<tagint> &mine) const;
  Bodies joined(const std::map<tagint, bigint> &sizes, const std::vector<tagint> &same,
                bigint mixed) const;
  void drop_reused_ids();
  void resolve_missing(std::vector<tagint> &, bool setup);
  void drop(std::vector<tagint> &ids);
  bool periodic() const;
  double largest_distance() const;
  double largest_distance_by_id() const;
  double square_of_nearest(const double *a, const double *b) const;
  bool follows_partners() const;
  void enlarge_ghost_cutoff(double distance);
  int near_image(int i, int j) const;
  void require_near(int i, int image) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
