/* ----------------------------------------------------------------------
   Vectors in space, three doubles of each particle one after the other, as packs: what becomes of
   every number.
------------------------------------------------------------------------- */

#include "sph_solid_space.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

namespace {

constexpr int N = SPACE * LANES;

Pack counted(double first, double step)
{
  return pack_of([&](int m) {
    return first + step * m;
  });
}

TEST(SpaceVectors, Components)
{
  double of[N];
  for (int e = 0; e < N; e++) of[e] = 100.0 + e;
  Pack plane[2], space[3];
  load_components<2>(of, plane);
  load_components<3>(of, space);
  for (int m = 0; m < LANES; m++)
    for (int a = 0; a < SPACE; a++) {
      EXPECT_EQ(space[a][m], 100.0 + SPACE * m + a);
      if (a < 2) { EXPECT_EQ(plane[a][m], space[a][m]); }
    }
}

TEST(SpaceVectors, AddedComponents)
{
  const Pack v[3] = {counted(1.0, 0.5), counted(-7.0, 0.25), counted(100.0, 3.0)};
  double plane[N], space[N];
  for (int e = 0; e < N; e++) plane[e] = space[e] = 1000.0 * e;
  add_components<2>(plane, v);
  add_components<3>(space, v);
  for (int m = 0; m < LANES; m++)
    for (int a = 0; a < SPACE; a++) {
      const int e = SPACE * m + a;
      EXPECT_EQ(space[e], 1000.0 * e + v[a][m]);
      EXPECT_EQ(plane[e], 1000.0 * e + (a < 2 ? v[a][m] : 0.0));
    }
}

// in two dimensions z stays, whatever would be added

TEST(SpaceVectors, AddedMultiples)
{
  const Pack factor = counted(0.1, 0.7);
  double from[N], plane[N], space[N];
  for (int e = 0; e < N; e++) {
    from[e] = 3.0 + e;
    plane[e] = space[e] = -0.3 * e;
  }
  add_multiples<2>(plane, from, factor);
  add_multiples<3>(space, from, factor);
  for (int m = 0; m < LANES; m++)
    for (int a = 0; a < SPACE; a++) {
      const int e = SPACE * m + a;
      const double product = factor[m] * from[e];    // rounded: no fused multiply-add
      EXPECT_EQ(space[e], -0.3 * e + product);
      EXPECT_EQ(plane[e], a < 2 ? -0.3 * e + product : -0.3 * e);
    }
}

}    // namespace
