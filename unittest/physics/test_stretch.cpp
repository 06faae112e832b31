/* ----------------------------------------------------------------------
   The least principal stretch is the least singular value of F, and its bound is never above it.
------------------------------------------------------------------------- */

#include "sph_solid_stretch.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <cstdlib>

using namespace SPHSolid;

namespace {

template <int D> double singular_value(const Tensor<D> &F)
{
  return Eigen::JacobiSVD<Tensor<D>>(F).singularValues()[D - 1];
}

// of the same F in all lanes but the last, which has the identity

template <int D> double bound(const Tensor<D> &F)
{
  Tensor<D, Pack> all;
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++)
      all(a, b) = pack_of([&](int lane) {
        return lane < LANES - 1 ? F(a, b) : (a == b ? 1.0 : 0.0);
      });
  const Pack s = stretch_bound<D>(all);
  EXPECT_NEAR(s[LANES - 1], 1.0, 1e-8);
  return s[0];
}

template <int D> void expect_bounded()
{
  std::srand(1);
  for (int k = 0; k < 1000; k++) {
    const Tensor<D> F = Tensor<D>::Identity() + (k / 500.0) * Tensor<D>::Random();
    const double s = singular_value<D>(F);
    EXPECT_NEAR(least_stretch<D>(F), s, 1e-7);
    EXPECT_LE(bound<D>(F), s + 1e-14);
    if (D == 2 && s > 0.01) { EXPECT_NEAR(bound<D>(F), s, 1e-6 * F.squaredNorm()); }
  }
}

}    // namespace

TEST(Stretch, Bounded2D)
{
  expect_bounded<2>();
}

TEST(Stretch, Bounded3D)
{
  expect_bounded<3>();
}

// in three dimensions it is the stretch itself where two of them are equal and larger

TEST(Stretch, ExactForOneSqueezedDirection)
{
  const Tensor<3> turn = Eigen::Quaterniond(0.3, 0.1, -0.7, 0.4).normalized().toRotationMatrix();
  for (double s : {1.0, 0.5, 0.1}) {
    const Tensor<3> F = turn * Vector<3>(1.2, s, 1.2).asDiagonal() * turn;
    EXPECT_NEAR(bound<3>(F), s, 1e-6);
  }
}

TEST(Stretch, FlatIsZero)
{
  EXPECT_EQ(bound<2>(Vector<2>(1.0, 0.0).asDiagonal()), 0.0);
  EXPECT_EQ(bound<3>(Vector<3>(1.0, 1.0, 0.0).asDiagonal()), 0.0);
}
