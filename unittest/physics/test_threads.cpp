/* ----------------------------------------------------------------------
   Shares of threads: together they are the whole, once, and their results are joined in the
   order of the particles.
------------------------------------------------------------------------- */

#include "sph_solid_threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

using namespace SPHSolid;

TEST(Threads, EveryParticleOnce)
{
  for (int nthreads : {1, 2, 3, 8})
    for (int n : {0, 1, 2, 7, 1000}) {
      std::vector<std::atomic<int>> times(n);
      each_share(nthreads, n, [&](int first, int end) {
        for (int i = first; i < end; i++) times[i]++;
      });
      for (int i = 0; i < n; i++) EXPECT_EQ(times[i], 1) << i << " of " << n;
    }
}

TEST(Threads, ResultsInOrder)
{
  std::string all;
  for (int i = 0; i < 100; i++) all += std::to_string(i) + " ";
  for (int nthreads : {1, 2, 3, 8})
    EXPECT_EQ(join_shares(
                  nthreads, 100, std::string(),
                  [](int first, int end) {
                    std::string share;
                    for (int i = first; i < end; i++) share += std::to_string(i) + " ";
                    return share;
                  },
                  [](std::string &sum, const std::string &share) {
                    sum += share;
                  }),
              all);
}

// join() sees each share's result and the first value only: what a sum begins with counts once

TEST(Threads, FirstValueCountsOnce)
{
  for (int nthreads : {1, 2, 3, 8})
    EXPECT_EQ(join_shares(
                  nthreads, 10, 100,
                  [](int first, int end) {
                    return end - first;
                  },
                  [](int &sum, int share) {
                    sum += share;
                  }),
              110);
}
