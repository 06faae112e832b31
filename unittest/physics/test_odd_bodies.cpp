/* ----------------------------------------------------------------------
   Bodies that have no gradients of their own, particles on top of each other, and
   states that nothing can be done with: no force from nowhere, and a report.
------------------------------------------------------------------------- */

#include "sums.h"

#include <gtest/gtest.h>

#include <limits>

using namespace SPHSolid;

TEST(OddBody, SingleParticleFeelsNothing)
{
  for (int dim : {2, 3})
    for (Viscosity viscosity : VISCOSITIES) {
      Cloud c(dim);
      c.opt.viscosity = viscosity;
      c.add({0, 0, 0}, {1, 2, 0});
      c.S[0] = {0.1, 0.2, -0.3, 0.4, 0.0, 0.0};
      EXPECT_EQ(c.evaluate(0.1), -1);
      EXPECT_EQ(c.f(0), Vector3d::Zero().eval());
      EXPECT_EQ(c.heat(c.v)[0], 0.0);
      EXPECT_EQ(c.rho[0], 1.0);
      EXPECT_EQ(c.sweeps->neighbor_count(0), 0);
    }
}

// a fragment far away, the last particle of all: it has no candidates, and its row no place in
// what pairs are stored in.  (With the library's checks of indices that once stopped a run)

TEST(OddBody, FragmentFarAwayFeelsNothing)
{
  for (int dim : {2, 3})
    for (Viscosity viscosity : VISCOSITIES)
      for (Weights weights : {Weights::CONSERVATIVE, Weights::SHEPARD, Weights::SAFE}) {
        Cloud c = random_cloud(dim);
        c.opt.viscosity = viscosity;
        c.opt.weights = weights;
        c.add({100, 0, 0}, {1, 2, 0});
        const int last = c.size() - 1;
        EXPECT_EQ(c.evaluate(0.01), -1);
        EXPECT_EQ(c.f(last), Vector3d::Zero().eval());
        EXPECT_EQ(c.heat(c.v)[last], 0.0);
      }
}

// where two particles coincide the pair has no direction: no force between them

TEST(OddBody, CoincidingPair)
{
  for (Viscosity viscosity : VISCOSITIES) {
    Cloud c(2);
    c.opt.viscosity = viscosity;
    c.add({1, 1, 0}, {0.1, 0.2, 0});
    c.add({1, 1, 0}, {-0.1, 0.3, 0});
    c.S[0] = c.S[1] = {0.1, 0.2, -0.3, 0.4, 0.0, 0.0};
    EXPECT_EQ(c.evaluate(0.1), -1);
    EXPECT_EQ(c.f(0), Vector3d::Zero().eval());
    EXPECT_EQ(c.f(1), Vector3d::Zero().eval());
  }
}

TEST(OddBody, CoincidingPairInBody)
{
  for (int dim : {2, 3}) {
    Cloud c = random_cloud(dim);
    c.x[20] = c.x[40];
    EXPECT_EQ(c.evaluate(0.1), -1);
    for (int i = 0; i < c.size(); i++) ASSERT_TRUE(c.f(i).allFinite());
    EXPECT_LT(net_force(c), 1e-14);
  }
}

// equal masses and densities: forces are opposite to the last bit

TEST(OddBody, ActionIsReaction)
{
  for (int dim : {2, 3})
    for (Viscosity viscosity : VISCOSITIES) {
      Noise noise(5);
      Cloud c(dim);
      c.opt.viscosity = viscosity;
      c.add({0, 0, 0}, {0, 0, 0});
      c.add({1, 0, 0}, {0, 0, 0});
      c.stir(noise, 0.2, 0.0);
      c.evaluate();
      EXPECT_GT(c.f(0).norm(), 0.0);
      EXPECT_LT((c.f(0) + c.f(1)).norm(), 1e-15 * c.f(0).norm());
    }
}

TEST(OddBody, UnphysicalStateIsReported)
{
  Cloud c = lattice(2, 5);
  c.v[7][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_GE(c.evaluate(0.1), 0);
}

// expansion by more than 200 % in one step: density below zero

TEST(OddBody, TooLongStepIsReported)
{
  Cloud c = lattice(2, 5);
  c.move([](Vector3d x) -> Vector3d {
    return x;
  });
  EXPECT_GE(c.evaluate(1.5), 0);
}

/* ----------------------------------------------------------------------
   Lagrangian frame: one and two particles
------------------------------------------------------------------------- */

TEST(FewParticles, One)
{
  for (int dim : {2, 3})
    for (Viscosity viscosity : VISCOSITIES) {
      Cloud c(dim);
      c.opt.frame = Frame::LAGRANGIAN;
      c.opt.viscosity = viscosity;
      c.opt.hourglass = 0.1;
      c.add(Vector3d(1, 2, 0), Vector3d(3, 4, 0));
      EXPECT_EQ(c.evaluate(0.1), -1);
      EXPECT_EQ(c.f(0).norm(), 0.0);
      EXPECT_EQ(c.rho[0], 1.0);
      EXPECT_EQ(c.heat(c.v)[0], 0.0);
      EXPECT_EQ(c.sweeps->find_overload().kind, Overload::NONE);
    }
}

TEST(FewParticles, Two)
{
  for (int dim : {2, 3})
    for (Viscosity viscosity : VISCOSITIES)
      for (double distance : {1.0, 2.0}) {    // 2.0: no nearest neighbor for the correction
        Cloud c = closing_pair(distance, dim);
        c.opt.frame = Frame::LAGRANGIAN;
        c.opt.viscosity = viscosity;
        EXPECT_EQ(c.evaluate(0.1), -1);
        EXPECT_TRUE(std::isfinite(c.f(0).norm()));
        EXPECT_LT(c.f(0)[0], 0.0);
        EXPECT_EQ(c.f(0)[0], -c.f(1)[0]);
        EXPECT_EQ(c.f(0)[1], 0.0);
        EXPECT_NEAR(power(c) + sum(c.heat(c.v)), 0.0, 1e-17);
      }
}

// without a nearest neighbor the correction leaves the standard viscosity

TEST(FewParticles, LonelyPairKeepsTheStandardViscosity)
{
  double force[2];
  for (int k : {0, 1}) {
    Cloud c = closing_pair(2.0);
    c.opt.frame = Frame::LAGRANGIAN;
    c.opt.viscosity = k ? Viscosity::CORRECT : Viscosity::MONAGHAN;
    c.evaluate();
    force[k] = c.f(0)[0];
  }
  EXPECT_LT(force[0], -1e-6);
  EXPECT_DOUBLE_EQ(force[0], force[1]);
}
