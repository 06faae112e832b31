/* ----------------------------------------------------------------------
   Fingerprints summed over ranks.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_RANKS_H
#define LMP_SPH_SOLID_RANKS_H

#include "lmptype.h"

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

}    // namespace SPHSolid

#endif
