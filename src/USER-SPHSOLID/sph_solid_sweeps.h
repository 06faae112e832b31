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

/* ----------------------------------------------------------------------
   One force evaluation as sweeps over rows of neighbors.

   The order is that of pair style sph/solid (its compute() is the list):
     gradient     velocity gradient, correction matrix, constitutive update
     switch       of the viscosity, from the velocity gradients of all neighbors
     force        stress and viscosity
     correction   acceleration correction of Shaw & Reid over nearest neighbors
     heat         work of the pair forces on a given displacement field
   Every row writes to its own particle only.  Between the sweeps the pair
   style sends the rows of own particles to their ghosts; mirror images are
   filled here.  No LAMMPS include: only its raw arrays come in.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_SWEEPS_H
#define LMP_SPH_SOLID_SWEEPS_H

#include "sph_solid_images.h"
#include "sph_solid_material.h"
#include "sph_solid_viscosity.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace SPHSolid {

enum class Frame { EULERIAN, LAGRANGIAN };
enum class Distortion { ERROR, WARN, IGNORE };

// the numerics one run uses

struct Options {
  double h = 0.0;    // smoothing length [length]
  Frame frame = Frame::LAGRANGIAN;
  Viscosity viscosity = Viscosity::CORRECT;
  double a1 = 1.0, a2 = 1.0;    // coefficients of eq. 23
  double hbar = 1.5;            // support of the correction kernel in spacings
  Weights weights = Weights::CONSERVATIVE;
  Heating heating = Heating::COMPATIBLE;
  bool corrected = true;    // gradient correction
  bool tensile = false;     // artificial stress
  double tensile_eps = 0.0, tensile_n = 4.0;
  double hourglass = 0.0;    // damping of what no linear field contains, lagrangian
  Distortion distortion = Distortion::ERROR;    // where the lagrangian frame ends
  bool energy = true;                           // the energy equation
  bool mixed = false;                           // precision: sph_solid_precision.h
};

inline double square_of_distance(const double *a, const double *b)
{
  double r2 = 0.0;
  for (int k = 0; k < 3; k++) r2 += (a[k] - b[k]) * (a[k] - b[k]);
  return r2;
}

// have two particles, apart by r, been created twice?  But for rounding; squares, kernel: its range
inline bool at_same_place(double r2, double kernel2)
{
  return r2 <= 1.0e-12 * kernel2;
}

// the Courant number that fix sph/solid/dt takes with cfl auto: Taylor rods whose foot tears stop with
// 0.8, one of those without viscosity with 0.6.  doc/fix_sph_solid_dt.rst has the runs.  In the lagrangian
// frame it follows from the reference (pair_sph_solid_resonance.cpp), and is never more than the
// largest: beyond, results begin to depend on the step

constexpr double EULERIAN_COURANT_NUMBER = 0.5;
constexpr double LARGEST_COURANT_NUMBER = 1.5;

// why the lagrangian frame has come to its end at a particle

struct Overload {
  enum Kind { NONE, TURNED_OVER, STRETCH, OVERLAP, APART } kind = NONE;
  int particle = -1;
  // det F, least principal stretch, distance over that in the reference, distance (mixed precision)
  double value = 0.0;
};

// LAMMPS's arrays of own and ghost particles, valid for one evaluation.  Rows of own ones lie one after the
// other from row 0 on: who reads the place of each from x, v, f and stress reads 8 bytes more

struct Particles {
  int nlocal, nall;
  double **x, **v, **f;
  int *type;
  double *mass, *volume, *rho, *e;    // volume: initial, V0
  double **stress, *epl, *rho_weight;

  // IDs, to sort by while neighbors are new; without them local indices
  const std::int64_t *id = nullptr;

  // lagrangian: reference positions and volumes, box lengths (0: not periodic)
  double **xref = nullptr, *vref = nullptr;
  double period[3] = {0.0, 0.0, 0.0};
};

// eulerian: neighbors by present distance; lagrangian: the partners

struct NeighborRows {
  int inum;
  int *ilist, *numneigh, **firstneigh;
};

// one material for every type, with lengths already resolved

struct TypeData {
  Material material;
  double h = 0.0;          // smoothing length
  double spacing = 0.0;    // particle spacing, cube (2d: square) root of the largest volume
};

// sums over own particles since the first run, restart files included [energy]

struct Ledger {
  double plastic_work = 0.0;
  double viscous_heat = 0.0;    // heat of the viscosity that is left
  double returned = 0.0;        // heat the standard viscosity would have made, less that
  double hourglass = 0.0;       // heat of the hourglass damping
};

// displacements v_scale v + a_scale f/m; without a force of those that are not kicked

struct Kick {
  double v_scale, a_scale;    // [time, time^2]
  const int *mask;
  int kicked;    // group bits, for mask
};

// what a particle has to send to its ghosts between two sweeps: what the constitutive update has
// found, the switch of a viscosity, da of eq. 28, and displacements (D numbers) before heat()

enum class Message { STRESS, SWITCH, VISCOUS, DISPLACEMENT };

// of any frame and options, in doubles per particle: Eulerian in three dimensions, with artificial stress
// and rates of deformation
constexpr int LARGEST_MESSAGE = 28;

class Sweeps {
 public:
  virtual ~Sweeps() = default;
  static std::unique_ptr<Sweeps> create(int dimension, const Options &,
                                        const std::vector<TypeData> &);

  Images images;
  int nthreads = 1;
  Ledger ledger;
  bool limits_step = true;    // will time_step_limit() be asked for?

  // Heat on the way.  The work of the pair forces of an evaluation on the kick from v to v' is
  // that on the displacements due (v + v'), due = (dt1 + dt2)/4 with the steps before and
  // after.  It is linear in velocities: the sweeps that find the forces find the share of v, and
  // the gradient sweep of the next evaluation, which reads v' anyway, the share of v'.  Where
  // kernel gradients are constant that takes no sweep of its own
  bool keeps_heat = false;    // the share of v is to be found: only where can_keep_heat()
  double due = 0.0;    // 0: nothing is; the next gradient sweep adds it to p.e and clears it [time]
  bool unlike = false;    // lagrangian: do materials differ (Likeness)?  Before new_neighbors()
  bool wants_virial = true;    // will virial() be called for the forces to come?

  // neighbor lists are new: find images, size the storage.  reach: largest
  // cutoff with skin
  virtual void new_neighbors(const Particles &, const NeighborRows &, double reach) = 0;

  // fill the kinematic rows; v: velocities to use; weights from p.rho_weight
  virtual void pack_kinematics(const Particles &, const double *const *v) = 0;

  // velocity gradients and, over dt, the constitutive update of all particles
  // in the list.  Returns the local index of a particle whose state is not
  // physical any more, or -1
  virtual int gradient(const Particles &, const NeighborRows &, double dt) = 0;

  // what neighbors need of own particles, for forward communication: size numbers of particle i
  virtual int message_size(Message) const = 0;
  virtual void pack(Message, int i, double *out) const = 0;
  virtual void unpack(Message, const Particles &, int i, const double *in) = 0;
  // displacements of own particles: u, or those of a kick
  virtual void displace(const double *const *u) = 0;
  virtual void displace(const Particles &, const Kick &) = 0;
  virtual void mirror_stress() = 0;    // to images

  // the switch of a viscosity that needs one more sweep for it
  virtual bool sweeps_for_switch() const = 0;
  virtual void find_switch(const Particles &, const NeighborRows &) = 0;
  virtual void mirror_switch() = 0;

  // add stress and viscous forces to p.f, or leave that to the correction that follows
  virtual void force(const Particles &, const NeighborRows &) = 0;

  virtual bool needs_correction() const = 0;
  virtual void correction(const Particles &, const NeighborRows &) = 0;

  // the energy the pair forces give to particles while every particle moves by its displacement in
  // this time, of own and ghosts set by displace() or unpack(): heat[i] of particle i or, with heat
  // null, added to p.e and to the ledger
  virtual void heat(const Particles &, const NeighborRows &, double time, double *heat) = 0;

  virtual bool can_keep_heat() const { return false; }
  // the share that the next gradient sweep would add, to the same bits: before rows change
  virtual void add_due_heat(const Particles &, const NeighborRows &) {}

  // lagrangian: linear elastic stress of the displacements that unpack() has set, about the
  // reference, and its forces, added to p.f
  virtual void elastic_stress(const Particles &) {}
  virtual void elastic_force(const Particles &) {}

  // the pair forces' virial as LAMMPS has it, sum of r_ij f_ij over pairs, 6 numbers
  virtual void virial(const Particles &, const NeighborRows &, double *six) = 0;

  // of an own particle, what pack_kinematics() was given for it (until unpack() sets displacements)
  virtual void velocity(int i, double *v) const = 0;

  // per particle, own: for the time step and for output
  virtual double time_step_limit(const Particles &, const NeighborRows &) const = 0;
  // lagrangian: times factor sqrt(V/m), V the initial volume, where that is less than 1; a factor per type
  virtual double scaled_time_step_limit(const Particles &, const std::vector<double> &) const
  {
    return 0.0;
  }
  virtual int neighbor_count(int i) const = 0;
  virtual double memory_usage() const = 0;

  // own particles whose neighbors or partners do not allow the gradient correction that is asked for
  virtual int uncorrected() const = 0;

  // the particle that the frame can follow no further, if there is one
  virtual Overload find_overload() const { return {}; }
  // and the one whose partner is too far away for this precision
  virtual Overload find_torn() const { return {}; }
};

// one per frame, dimension and precision, for create()

template <int D, class Precision>
std::unique_ptr<Sweeps> eulerian_sweeps(const Options &, const std::vector<TypeData> &);
template <int D, class Precision>
std::unique_ptr<Sweeps> lagrangian_sweeps(const Options &, const std::vector<TypeData> &);

// the reference density of a particle: its mass over its initial volume

inline double reference_density(double mass, double volume)
{
  return mass / volume;
}

// the least and the largest of positive numbers, which differ by more than rounding or not

struct Range {
  double least = HUGE_VAL, most = 0.0;
  void add(double value)
  {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  bool wide() const { return most > (1.0 + 1.0e-12) * least; }
};

// Viscosity and hourglass damping of the Lagrangian frame take the harmonic mean of densities and
// impedances, so that what a heavy particle does to a light one is at most twice what another light one
// would do.  Where all are alike that is the arithmetic mean, which costs no division

struct Likeness {
  Range density, impedance;    // in the reference
  void add(const TypeData &type, double mass, double reference_volume)
  {
    const double rho = mass / reference_volume;
    density.add(rho);
    impedance.add(std::sqrt(rho * type.material.longitudinal_modulus()) * type.h);
  }
  bool unlike(const Options &o) const
  {
    const bool viscous = o.viscosity != Viscosity::NONE;
    return (viscous && density.wide()) || (o.hourglass > 0.0 && impedance.wide());
  }
};

}    // namespace SPHSolid

#endif
