/* ----------------------------------------------------------------------
   Fingerprints summed over ranks, ranges of numbers on all of them.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_RANKS_H
#define LMP_SPH_SOLID_RANKS_H

#include "lmptype.h"
#include "sph_solid_sweeps.h"

#include <cstdint>
#include <cstring>
#include <mpi.h>

namespace SPHSolid {

// as bigint: the MPI stubs of a serial LAMMPS know no unsigned type

inline std::uint64_t sum_over_ranks(std::uint64_t value, MPI_Comm world)
{
  LAMMPS_NS::bigint mine, all;
  std::memcpy(&mine, &value, sizeof(mine));
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  std::memcpy(&value, &all, sizeof(all));
  return value;
}

inline Range over_ranks(const Range &mine, MPI_Comm world)
{
  Range all;
  MPI_Allreduce(&mine.least, &all.least, 1, MPI_DOUBLE, MPI_MIN, world);
  MPI_Allreduce(&mine.most, &all.most, 1, MPI_DOUBLE, MPI_MAX, world);
  return all;
}

}    // namespace SPHSolid

#endif
