/* ----------------------------------------------------------------------
   What packs can do between their lanes, against loops over lanes.
------------------------------------------------------------------------- */

#include "sph_solid_blocks.h"

#include <gtest/gtest.h>

#include <limits>

using namespace SPHSolid;

namespace {

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

// positive in the lanes that are in a set, elsewhere in turns -1, 0 and no number

Pack positive_in(unsigned set)
{
  constexpr double OTHERS[3] = {-1.0, 0.0, NOT_A_NUMBER};
  return pack_of([=](int m) {
    return set >> m & 1u ? 0.5 + m : OTHERS[(m + set) % 3];
  });
}

TEST(Packs, CollectedLanesKeepTheirOrder)
{
  int j[LANES], to_j[LANES];
  double v[LANES], to_v[LANES];
  for (int m = 0; m < LANES; m++) {
    j[m] = 1000000007 + 13 * m;
    v[m] = 0.1 + m;
  }
  for (unsigned set = 0; set < 1u << LANES; set++) {
    const int n = collect_positive(positive_in(set), j, load(v), to_j, to_v);
    int expected = 0;
    for (int m = 0; m < LANES; m++) {
      if (!(set >> m & 1u)) continue;
      ASSERT_LT(expected, n) << set;
      EXPECT_EQ(to_j[expected], j[m]) << set;
      EXPECT_EQ(to_v[expected], v[m]) << set;
      expected++;
    }
    EXPECT_EQ(n, expected) << set;
  }
}

TEST(Packs, FirstLanesAreStoredAndNoOthers)
{
  for (int n = 1; n <= LANES + 1; n++) {
    double to[LANES + 2];
    for (double &number : to) number = -7.0;
    store_first(to, pack_of([](int m) {
                  return 0.5 + m;
                }),
                n);
    for (int m = 0; m < LANES + 2; m++) EXPECT_EQ(to[m], m < n && m < LANES ? 0.5 + m : -7.0) << n;
  }
}

TEST(Packs, ArePositiveIfAllLanesAre)
{
  const unsigned all = (1u << LANES) - 1;
  for (unsigned set = 0; set <= all; set++) EXPECT_EQ(all_positive(positive_in(set)), set == all);
}

// 1 + 2^-30 squared less 1: with one rounding or two, alike in both

TEST(Packs, MultiplyAddsAsNumbersDo)
{
  const double a = 1.0 + 0x1p-30, number = multiply_add(a, a, -1.0);
  const Pack pack = multiply_add(Pack(a), Pack(a), Pack(-1.0));
  for (int m = 0; m < LANES; m++) EXPECT_EQ(pack[m], number);
  EXPECT_NEAR(number, 0x1p-29, 0x1p-52);
}

}    // namespace
