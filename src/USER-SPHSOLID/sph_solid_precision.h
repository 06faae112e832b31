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
   In which precision the sweeps over pairs compute.

   Double: everything.  Mixed: what is read of particles, pairs and their sums in single precision, and so twice
   as many particles at a time; the state of particles, and what is added to it and to forces, in double
   precision.  Positions are whole numbers of 2^-22 h there, so that a difference is exact wherever a
   body is: up to 4h or 2^24 units single precision has it exactly.  Of a whole number
   its last 32 bits are enough, since differences are less than 2^31 units, 512 h.  h is the least one of all
   types; pairs of larger ones are rounded like all other numbers.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_PRECISION_H
#define LMP_SPH_SOLID_PRECISION_H

#include "sph_solid_kernel.h"
#include "sph_solid_storage.h"
#include "sph_solid_vector.h"

namespace SPHSolid {

struct DoublePrecision {
  using Number = double;
  using Pack = SPHSolid::Pack;
  using Single = SinglePack;     // of what is kept in single precision in any case
  using Place = Pack;            // a component of positions
  using Bits = unsigned char;    // one for each lane
  static constexpr double SUPPORT = SPHSolid::SUPPORT;

  static Pack load(const double *from) { return SPHSolid::load(from); }
  static Pack load(const float *from) { return SPHSolid::load(from); }
  template <class F> static Pack pack_of_numbers(F value) { return doubles_of(value); }
  static Single load_single(const float *from) { return SPHSolid::load_single(from); }

  // positions in columns, and what two of them are apart [length]
  class Ruler {
   public:
    explicit Ruler(double) {}
    static void store_place(double *to, Pack x) { store(to, x); }
    static double number_of(double x) { return x; }
    static Place place(const double *from) { return load(from); }
    static Pack apart(Place a, Place b) { return a - b; }
    static double apart(const double *a, const double *b) { return *a - *b; }
    // added to squares of distances that may be 0
    static double least_r2() { return 1.0e-200; }
    // partners that are further apart cannot be told from nearer ones; 0: all can
    static double furthest() { return 0.0; }
  };
};

struct MixedPrecision {
  using Number = float;
  using Pack = WidePack;
  using Single = WidePack;
  using Place = WholePack;
  using Bits = unsigned short;
  static constexpr double SUPPORT =
      2.0 * (1.0 - 1.0e-6);    // as sph_solid_kernel.h, in single precision

  static Pack load(const float *from) { return load_wide(from); }
  template <class F> static Pack pack_of_numbers(F value) { return floats_of(value); }
  static Single load_single(const float *from) { return load_wide(from); }

  class Ruler {
   public:
    explicit Ruler(double h) : unit(h * UNIT), units(1.0 / unit), wide_unit(unit) {}
    void store_place(float *to, SPHSolid::Pack x) const { store_whole(to, x * units); }
    float number_of(double x) const
    {
      float all[SPHSolid::LANES];
      store_place(all, x);
      return all[0];
    }
    static Place place(const float *from) { return load_whole(from); }
    Pack apart(Place a, Place b) const { return difference(a, b) * wide_unit; }
    double apart(const float *a, const float *b) const
    {
      unsigned at[2];
      std::memcpy(&at[0], a, sizeof(*a));
      std::memcpy(&at[1], b, sizeof(*b));
      return unit * static_cast<int>(at[0] - at[1]);
    }

    // 10^-12 h^2: nothing beside that of partners whose frame is not at its end
    double least_r2() const { return 18.0 * unit * unit; }
    // half of what differences can be, so that what grows beyond is seen in time
    double furthest() const { return unit * 0x1p30; }    // MIXED_REACH h

   private:
    static constexpr double UNIT = 0x1p-22;
    double unit, units;    // [length], [1/length]
    Pack wide_unit;
  };
};

// what mixed precision needs: coordinates of less than so many smoothing lengths (2^51 units); smoothing lengths
// of types, and what neighbor lists reach beyond the least of them, that differ by no more than these factors; and in
// the units of the input numbers that single precision has, with room for products of a few of them

constexpr double MIXED_FURTHEST = 1.0e8, MIXED_LENGTHS = 64.0, MIXED_REACH = 256.0,
                 MIXED_LEAST = 1.0e-30, MIXED_MOST = 1.0e30;

}    // namespace SPHSolid

#endif
