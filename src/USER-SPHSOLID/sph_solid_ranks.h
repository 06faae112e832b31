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
   What all ranks know together: sums, ranges, whether there is one.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_RANKS_H
#define LMP_SPH_SOLID_RANKS_H

#include "lmptype.h"
#include "sph_solid_fingerprint.h"
#include "sph_solid_sweeps.h"

#include <cstdint>
#include <cstring>
#include <mpi.h>

namespace SPHSolid {

inline LAMMPS_NS::bigint sum_over_ranks(LAMMPS_NS::bigint mine, MPI_Comm world)
{
  LAMMPS_NS::bigint all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

inline bool on_any_rank(bool here, MPI_Comm world)
{
  return sum_over_ranks(LAMMPS_NS::bigint(here ? 1 : 0), world) > 0;
}

// as bigint: the MPI stubs of a serial LAMMPS know no unsigned type

inline std::uint64_t sum_over_ranks(std::uint64_t value, MPI_Comm world)
{
  LAMMPS_NS::bigint mine;
  std::memcpy(&mine, &value, sizeof(mine));
  mine = sum_over_ranks(mine, world);
  std::memcpy(&value, &mine, sizeof(mine));
  return value;
}

// of n particles, whatever their order is; add(print, i) says what counts of particle i

template <class Add>
std::uint64_t fingerprint_of_particles(int n, const LAMMPS_NS::tagint *tag, MPI_Comm world, Add add)
{
  std::uint64_t mine = 0;
  for (int i = 0; i < n; i++) {
    Fingerprint print(static_cast<std::uint64_t>(tag[i]));
    add(print, i);
    mine += print.value();
  }
  return sum_over_ranks(mine, world);
}

inline Range over_ranks(Range mine, MPI_Comm world)    // a copy: the MPI stubs take no const
{
  Range all;
  MPI_Allreduce(&mine.least, &all.least, 1, MPI_DOUBLE, MPI_MIN, world);
  MPI_Allreduce(&mine.most, &all.most, 1, MPI_DOUBLE, MPI_MAX, world);
  return all;
}

}    // namespace SPHSolid

#endif
