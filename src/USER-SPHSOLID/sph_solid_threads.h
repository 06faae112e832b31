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

// call(first, end) for the shares of [0, n)

template <class Call> void each_share(int nthreads, int n, Call call)
{
#if defined(_OPENMP)
  if (nthreads > 1) {
#pragma omp parallel num_threads(nthreads)
    {
      const std::int64_t share = omp_get_thread_num(), shares = omp_get_num_threads();
      call(static_cast<int>(share * n / shares), static_cast<int>((share + 1) * n / shares));
    }
    return;
  }
#endif
  call(0, n);
}

// join(total, result of a share) for the results of all, which call(first, end) returns

template <class Result, class Call, class Join>
Result join_shares(int nthreads, int n, Result total, Call call, Join join)
{
#if defined(_OPENMP)
  if (nthreads > 1) {
    std::vector<Result> of(nthreads, total);
    int joined = 0;    // there may be fewer threads than asked for
#pragma omp parallel num_threads(nthreads)
    {
      const std::int64_t share = omp_get_thread_num(), shares = omp_get_num_threads();
      if (share == 0) joined = static_cast<int>(shares);
      of[share] =
          call(static_cast<int>(share * n / shares), static_cast<int>((share + 1) * n / shares));
    }
    for (int k = 0; k < joined; k++) join(total, of[k]);
    return total;
  }
#endif
  join(total, call(0, n));
  return total;
}

}    // namespace SPHSolid

#endif
