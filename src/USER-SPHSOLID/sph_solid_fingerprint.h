/* ----------------------------------------------------------------------
   A number that any change of some numbers, to the last bit, changes; of many, in any
   order and on any number of ranks, their sum.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_FINGERPRINT_H
#define LMP_SPH_SOLID_FINGERPRINT_H

#include "lmptype.h"

#include <cstdint>
#include <cstring>
#include <mpi.h>

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
