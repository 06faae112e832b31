/* ----------------------------------------------------------------------
   Artificial stress: acts on principal tension only, whatever the axes.
------------------------------------------------------------------------- */

#include "sph_solid_tensile.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace SPHSolid;

// (1 2; 2 -2) has the principal values 2 along (2,1)/sqrt5 and -3: what is left
// of tension is 2/5 (4 2; 2 1)

TEST(Tensile, ByHand)
{
  Tensor<2> sigma, expected;
  sigma << 1.0, 2.0, 2.0, -2.0;
  expected << 1.6, 0.8, 0.8, 0.4;
  EXPECT_LT((artificial_stress<2>(sigma, 0.3) + 0.3 * expected).norm(), 1e-15);
}

// uniaxial tension along z in 3d

TEST(Tensile, UniaxialThreeDimensions)
{
  Tensor<3> sigma = Tensor<3>::Zero(), expected = Tensor<3>::Zero();
  sigma.diagonal() << -1.0, -2.0, 5.0;
  expected(2, 2) = -1.5;
  EXPECT_LT((artificial_stress<3>(sigma, 0.3) - expected).norm(), 1e-15);
}

TEST(Tensile, CompressionGivesNothing)
{
  Tensor<3> sigma;
  sigma << -3.0, 1.0, 0.5, 1.0, -3.0, 0.2, 0.5, 0.2, -4.0;    // -5.2 <= eigenvalues <= -1.9
  EXPECT_EQ(artificial_stress<3>(sigma, 0.3).norm(), 0.0);
}

// R(Q sigma Q^T) = Q R(sigma) Q^T

TEST(Tensile, RotatesWithStress)
{
  Tensor<3> sigma;
  sigma << 1.0, 2.0, -0.5, 2.0, -3.0, 0.7, -0.5, 0.7, 2.0;
  const Tensor<3> Q = Eigen::AngleAxisd(1.1, Vector<3>(1.0, -2.0, 0.5).normalized()).matrix();
  const Tensor<3> rotated = artificial_stress<3>(Q * sigma * Q.transpose(), 0.3);
  EXPECT_LT((rotated - Q * artificial_stress<3>(sigma, 0.3) * Q.transpose()).norm(), 1e-14);
}

// the pair factor is one at the initial spacing; W(0)/W(h) = 4 of the spline,
// so four times four is 256 for n = 4

TEST(Tensile, Crowding)
{
  EXPECT_DOUBLE_EQ(crowding<2>(1.0, 1.3, 1.0, 4.0), 1.0);
  EXPECT_NEAR(crowding<3>(0.0, 1.3, 1.3, 4.0), 256.0, 1e-11);
  EXPECT_EQ(crowding<2>(2.6, 1.3, 1.0, 4.0), 0.0);
}

// whole exponents are products there

TEST(Tensile, CrowdingInVectors)
{
  double r[LANES];
  for (int m = 0; m < LANES; m++) r[m] = 2.6 * m / (LANES - 1);
  for (const double n : {1.0, 4.0, 3.5, 17.0}) {
    const Pack all = crowding<3>(load(r), Pack(1.3), Pack(1.0), n);
    for (int m = 0; m < LANES; m++) {
      const double one = crowding<3>(r[m], 1.3, 1.0, n);
      EXPECT_NEAR(all[m], one, 1.0e-14 * one) << n << " " << r[m];
    }
  }
}
