/* ----------------------------------------------------------------------
   One material point against exact solutions of the Jaumann rate: turning, shear,
   plane strain.
------------------------------------------------------------------------- */

#include "material_point.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

namespace {

Tensor<2> rotation(double angle)
{
  return Eigen::Rotation2Dd(angle).toRotationMatrix();
}

Tensor<2> simple_shear()
{
  Tensor<2> L;
  L << 0.0, 1.0, 0.0, 0.0;
  return L;
}

Tensor<3> deviator(const Tensor<3> &t)
{
  return t - t.trace() / 3.0 * Tensor<3>::Identity();
}

}    // namespace

/* ----------------------------------------------------------------------
   kinematics
------------------------------------------------------------------------- */

// the gradient at the middle belongs to (F0 + F1)/2

TEST(Strength, MidpointVelocityGradient)
{
  Tensor<2> F0, F1;
  F0 << 1.0, 0.1, -0.2, 0.9;
  F1 << 1.3, 0.0, 0.1, 0.8;
  const double dt = 0.5;
  const Tensor<2> rate = (F1 - F0) / dt;
  const Tensor<2> L = midpoint_velocity_gradient<2>(rate * F1.inverse(), dt);
  EXPECT_LT((L - rate * (0.5 * (F0 + F1)).inverse()).norm(), 1e-14);
}

// tan(theta/2) = w dt/2 of the Cayley transform, counter-clockwise for v = w (-y, x)

TEST(Strength, SpinRotation)
{
  Tensor<2> L;
  L << 0.0, -3.0, 3.0, 0.0;
  const Tensor<2> Q = spin_rotation<2>(L, 0.5);
  EXPECT_LT((Q - rotation(2.0 * std::atan(0.75))).norm(), 1e-15);
}

TEST(Strength, StretchDoesNotRotate)
{
  Tensor<3> D;
  D << 1.0, 0.2, 0.3, 0.2, -1.0, 0.4, 0.3, 0.4, 2.0;
  EXPECT_EQ(spin_rotation<3>(D, 0.5), Tensor<3>::Identity().eval());
}

// rho0/rho is the length of the bar, in steps of any size

TEST(Strength, DensityInUniaxialStrain)
{
  PointState<3> p = at_rest<3>();
  stretch(elastic, p, 1.0, 0.6, 3);
  EXPECT_NEAR(p.rho * 0.6 / RHO0, 1.0, 1e-15);
  stretch(elastic, p, 0.6, 1.5, 2);
  EXPECT_NEAR(p.rho * 1.5 / RHO0, 1.0, 1e-15);
}

// det F = 1

TEST(Strength, DensityInSimpleShear)
{
  PointState<2> p = at_rest<2>();
  Tensor<2> F = Tensor<2>::Identity();
  F(0, 1) = 0.8;
  deform<2>(elastic, p, Tensor<2>::Identity(), F, 1.0);
  EXPECT_DOUBLE_EQ(p.rho, RHO0);
}

/* ----------------------------------------------------------------------
   objective rate
------------------------------------------------------------------------- */

// one step from rest is Hooke's law, S = 2 mu dev(D) dt; it is so short that
// turning within it is less than rounding

TEST(Strength, HookesLaw)
{
  Tensor<3> L;
  L << 1.0, 0.7, -0.3, 0.1, 2.0, 0.5, 0.9, -0.2, -0.5;
  PointState<3> p = at_rest<3>();
  const double dt = 1e-15;
  advance<3>(elastic, p, L, dt);
  const Tensor<3> hooke = 2.0 * MU * deviator(0.5 * (L + L.transpose())) * dt;
  EXPECT_LT((p.S - hooke).norm(), 1e-14 * hooke.norm());
}

// elastic simple shear, Jaumann: S_xy = mu sin(gt), S_xx = -S_yy = mu (1 - cos gt),
// exact solution of S' = 2 mu D + W S - S W; here gt = 1

struct ShearError {
  double xx, xy;
};

ShearError shear_error(int n)
{
  PointState<2> p = at_rest<2>();
  steady<2>(elastic, p, simple_shear(), 1.0, n);
  EXPECT_NEAR(p.S(1, 1), -p.S(0, 0), 1e-12 * MU);
  EXPECT_NEAR(p.Szz, 0.0, 1e-12 * MU);
  return {p.S(0, 0) / MU - (1.0 - std::cos(1.0)), p.S(0, 1) / MU - std::sin(1.0)};
}

TEST(Strength, SimpleShear)
{
  const ShearError e = shear_error(40000);
  EXPECT_NEAR(e.xx, 0.0, 1e-10);
  EXPECT_NEAR(e.xy, 0.0, 1e-10);
}

TEST(Strength, SimpleShearIsSecondOrder)
{
  const ShearError coarse = shear_error(200), fine = shear_error(400);
  EXPECT_NEAR(coarse.xx / fine.xx, 4.0, 0.02);
  EXPECT_NEAR(coarse.xy / fine.xy, 4.0, 0.02);
}

// one revolution in five steps of 72 degrees: S turns with the body, S = Q S0 Q^T

TEST(Strength, RigidRotationTwoDimensions)
{
  PointState<2> p = at_rest<2>();
  p.S << 3.0, 1.0, 1.0, -1.0;
  p.S *= MU;
  p.Szz = -2.0 * MU;
  const Tensor<2> S0 = p.S;
  const double step = 2.0 * M_PI / 5.0;
  for (int i = 0; i < 5; i++) {
    deform<2>(elastic, p, rotation(i * step), rotation((i + 1) * step), 0.1);
    const Tensor<2> Q = rotation((i + 1) * step);
    EXPECT_LT((p.S - Q * S0 * Q.transpose()).norm(), 1e-12 * MU);
  }
  EXPECT_LT((p.S - S0).norm(), 1e-12 * MU);
  EXPECT_NEAR(p.Szz / MU, -2.0, 1e-12);
  EXPECT_NEAR(p.rho / RHO0, 1.0, 1e-14);
}

TEST(Strength, RigidRotationThreeDimensions)
{
  PointState<3> p = at_rest<3>();
  p.S << 3.0, 1.0, -0.5, 1.0, -1.0, 0.7, -0.5, 0.7, -2.0;
  p.S *= MU;
  const Tensor<3> S0 = p.S;
  const Vector<3> axis = Vector<3>(1.0, -2.0, 0.5).normalized();
  auto turned = [&axis](int i) {
    return Eigen::AngleAxisd(2.0 * M_PI * i / 7.0, axis).toRotationMatrix();
  };
  for (int i = 0; i < 7; i++) {
    deform<3>(elastic, p, turned(i), turned(i + 1), 0.1);
    EXPECT_LT((p.S - turned(i + 1) * S0 * turned(i + 1).transpose()).norm(), 1e-12 * MU);
  }
  EXPECT_LT((p.S - S0).norm(), 1e-12 * MU);
  EXPECT_NEAR(p.rho / RHO0, 1.0, 1e-14);
}

// a rotated observer sees the rotated stress of a deforming, turning body

TEST(Strength, SeenByRotatedObserver)
{
  Tensor<3> L;
  L << 1.0, 0.7, -0.3, 0.1, 2.0, 0.5, 0.9, -0.2, -0.5;
  const Tensor<3> Q = Eigen::AngleAxisd(0.9, Vector<3>(0.3, 1.0, -0.4).normalized()).matrix();
  PointState<3> here = at_rest<3>(), there = at_rest<3>();
  steady<3>(perfect, here, L, 0.01, 20);
  steady<3>(perfect, there, Q * L * Q.transpose(), 0.01, 20);
  EXPECT_GT(here.epl, 0.0);
  EXPECT_LT((there.S - Q * here.S * Q.transpose()).norm(), 1e-12 * Y0);
  EXPECT_NEAR(there.epl / here.epl, 1.0, 1e-12);
}

/* ----------------------------------------------------------------------
   plane strain
------------------------------------------------------------------------- */

TEST(Strength, PlaneStrainKeepsDeviator)
{
  Tensor<2> L;
  L << 2.0, 0.7, -0.4, -1.0;
  for (const Material &m : {elastic, perfect}) {
    PointState<2> p = at_rest<2>();
    for (int i = 0; i < 200; i++) {
      advance<2>(m, p, L, 1e-4);
      ASSERT_NEAR(p.Szz, -(p.S(0, 0) + p.S(1, 1)), 1e-14 * MU);
    }
  }
}

// two dimensions are three with nothing happening along z

TEST(Strength, PlaneStrainIsThreeDimensional)
{
  Tensor<2> L2;
  L2 << 2.0, 0.7, -0.4, -1.0;
  Tensor<3> L3 = Tensor<3>::Zero();
  L3.topLeftCorner<2, 2>() = L2;
  const Material hardening = solid(Strength::LINEAR, 1.0e9);
  PointState<2> flat = at_rest<2>();
  PointState<3> full = at_rest<3>();
  const double work2 = steady<2>(hardening, flat, L2, 0.02, 100);
  const double work3 = steady<3>(hardening, full, L3, 0.02, 100);
  Tensor<3> S = Tensor<3>::Zero();
  S.topLeftCorner<2, 2>() = flat.S;
  S(2, 2) = flat.Szz;
  EXPECT_GT(flat.epl, 0.01);
  EXPECT_LT((S - full.S).norm(), 1e-13 * Y0);
  EXPECT_NEAR(flat.rho / full.rho, 1.0, 1e-14);
  EXPECT_NEAR(flat.epl / full.epl, 1.0, 1e-13);
  EXPECT_NEAR(work2 / work3, 1.0, 1e-13);
}
