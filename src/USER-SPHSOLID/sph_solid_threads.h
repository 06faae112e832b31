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
   Loops in threads: each thread has one share of the particles, which lie side by side,
   and what shares add up to is joined in their order.

   The only file with OpenMP in it.  One thread has no parallel region: even alone, it would
   ask the kernel at the end of each to wake others, a microsecond each time.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_THREADS_H
#define LMP_SPH_SOLID_THREADS_H

#include <cstdint>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace SPHSolid {

// call(share, first, end) for the shares of [0, n), of which there may be fewer than threads asked
// for; returns how many

template <class Call> int number_shares([[maybe_unused]] int nthreads, int n, Call call)
{
#if defined(_OPENMP)
  if (nthreads > 1) {
    int number = 0;
#pragma omp parallel num_threads(nthreads)
    {
      const std::int64_t share = omp_get_thread_num(), shares = omp_get_num_threads();
      if (share == 0) number = static_cast<int>(shares);
      call(static_cast<int>(share), static_cast<int>(share * n / shares),
           static_cast<int>((share + 1) * n / shares));
    }
    return number;
  }
#endif
  call(0, 0, n);
  return 1;
}

// call(first, end) for each

template <class Call> void each_share(int nthreads, int n, Call call)
{
  number_shares(nthreads, n, [&](int, int first, int end) {
    call(first, end);
  });
}

// join(total, result of a share) for the results of all, which call(first, end) returns

template <class Result, class Call, class Join>
Result join_shares(int nthreads, int n, Result total, Call call, Join join)
{
  std::vector<Result> of(nthreads, total);
  const int number = number_shares(nthreads, n, [&](int share, int first, int end) {
    of[share] = call(first, end);
  });
  for (int k = 0; k < number; k++) join(total, of[k]);
  return total;
}

}    // namespace SPHSolid

#endif
