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

TEST(Packs, LanesAsBitsAreThoseThatArePositive)
{
  for (unsigned set = 0; set < 1u << LANES; set++) {
    EXPECT_EQ(positive_lanes(positive_in(set)), set);
    const Pack chosen = where_lanes(set, Pack(2.0), Pack(-3.0));
    for (int m = 0; m < LANES; m++) EXPECT_EQ(chosen[m], set >> m & 1u ? 2.0 : -3.0) << set;
  }
}

TEST(Packs, ArePositiveIfAllLanesAre)
{
  const unsigned all = (1u << LANES) - 1;
  for (unsigned set = 0; set <= all; set++) EXPECT_EQ(all_positive(positive_in(set)), set == all);
}

TEST(Packs, RootsAndTheirInverses)
{
  for (double x = 1e-30; x < 1e30; x *= 1.37) {
    const RootAndInverse of(x);
    EXPECT_NEAR(of.root[0], std::sqrt(x), 0x1p-46 * std::sqrt(x));
    EXPECT_NEAR(of.inverse[LANES - 1], 1.0 / std::sqrt(x), 0x1p-46 / std::sqrt(x));
  }
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
