/* ----------------------------------------------------------------------
   Where the Lagrangian frame ends: bodies squeezed flat, particles on their partners.
------------------------------------------------------------------------- */

#include "lagrangian_body.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

TEST(Overload, NoneForLargeDeformation)
{
  for (int dim : {2, 3}) {
    Cloud c = body(dim);
    deform(c, large(dim));
    c.evaluate();
    EXPECT_EQ(c.sweeps->find_overload().kind, Overload::NONE);
  }
}

TEST(Overload, SqueezedFlat)
{
  for (int dim : {2, 3}) {
    Cloud c = body(dim);
    deform(c, turned_stretch(0.005, 2.0, 1.0));
    c.evaluate();
    const Overload end = c.sweeps->find_overload();
    EXPECT_EQ(end.kind, Overload::STRETCH);
    EXPECT_NEAR(end.value, 0.005, 1e-12);
  }
}

TEST(Overload, ParticleOnItsPartner)
{
  Cloud c = body(2, 1, 0.0);
  const int i = 3 * 8 + 3, j = 4 * 8 + 3;
  c.x[i][0] += 0.498;
  c.x[j][0] -= 0.498;
  c.evaluate();
  const Overload end = c.sweeps->find_overload();
  EXPECT_EQ(end.kind, Overload::OVERLAP);
  EXPECT_EQ(end.particle, i);
  EXPECT_NEAR(end.value, 0.004, 1e-12);
}
