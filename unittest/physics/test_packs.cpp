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

TEST(Packs, LanesAsBitsAreThoseThatAreLarger)
{
  for (unsigned set = 0; set < 1u << LANES; set++) {
    EXPECT_EQ(larger_lanes(positive_in(set), Pack(0.0)), set);
    EXPECT_EQ(larger_lanes(Pack(2.0) + positive_in(set), Pack(2.0)), set);
    EXPECT_EQ(larger_lanes(Pack(0.0), -positive_in(set)), set);
    const Pack chosen = where_lanes(set, Pack(2.0), Pack(-3.0));
    for (int m = 0; m < LANES; m++) EXPECT_EQ(chosen[m], set >> m & 1u ? 2.0 : -3.0) << set;
  }
}

TEST(Packs, ArePositiveIfAllLanesAre)
{
  const unsigned all = (1u << LANES) - 1;
  for (unsigned set = 0; set <= all; set++) EXPECT_EQ(all_positive(positive_in(set)), set == all);
}

// IEEE numbers of single precision, whatever the instruction set

TEST(Packs, SinglePrecisionIsThatOfNumbers)
{
  for (float x = 1e-30f; x < 1e30f; x *= 1.37f) {
    const SinglePack pack = rounded(Pack(double(x) * (1.0 + 0x1p-30)));
    const float root = std::sqrt(x), shape = 2.0f - 0.75f * x * (1.0f / root);
    const SinglePack of_pack = 2.0 - 0.75 * pack * (1.0 / square_root(pack));
    for (int m = 0; m < LANES; m++) {
      EXPECT_EQ(pack[m], x);
      EXPECT_EQ(square_root(pack)[m], root);
      EXPECT_EQ(of_pack[m], shape);
    }
  }
}

TEST(Packs, SinglePrecisionIsChosenLaneByLane)
{
  const unsigned all = (1u << LANES) - 1;
  for (unsigned set = 0; set <= all; set++) {
    const SinglePack chosen =
        where_positive(rounded(positive_in(set)), SinglePack(2.0), SinglePack(-3.0));
    for (int m = 0; m < LANES; m++) EXPECT_EQ(chosen[m], set >> m & 1u ? 2.0f : -3.0f) << set;
    float stored[LANES];
    store(stored, chosen);
    EXPECT_EQ(sum(load(stored)), sum(where_lanes(set, Pack(2.0), Pack(-3.0))));
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
