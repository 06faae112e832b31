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
   A number that any change of some numbers, to the last bit, changes; of many, in any
   order and on any number of ranks, their sum (sph_solid_ranks.h).
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_FINGERPRINT_H
#define LMP_SPH_SOLID_FINGERPRINT_H

#include <cstdint>
#include <cstring>

namespace SPHSolid {

class Fingerprint {
 public:
  explicit Fingerprint(std::uint64_t of) : hash(of) {}
  void add(double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 29;
  }
  std::uint64_t value() const { return hash; }

 private:
  std::uint64_t hash;
};

}    // namespace SPHSolid

#endif
