/* ----------------------------------------------------------------------
   The Lagrangian frame is exact for linear fields: the deformation gradient of
   x = A X, and what follows from it, at faces and corners of a disordered body too.
------------------------------------------------------------------------- */

#include "lagrangian_body.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

using namespace SPHSolid;

namespace {

// pressure 1 everywhere and nothing else, at the density of a body deformed by A:
// P = Gamma rho e where rho is the reference density of the equation of state

void press(Cloud &c, const Matrix3d &A)
{
  for (int i = 0; i < c.size(); i++) {
    c.rho[i] = c.mass[i] / (c.vref[i] * A.determinant());
    c.volume[i] = c.mass[i] / c.rho[i];
    c.e[i] = 1.0 / (1.8 * c.rho[i]);
    c.S[i] = {};
  }
}

Matrix3d rates(int dim)
{
  return dim == 2 ? rows(0.3, -0.2, 0, 0.4, -0.5, 0, 0, 0, 0)
                  : rows(0.3, -0.2, 0.1, 0.4, -0.5, 0.2, -0.3, 0.1, 0.2);
}

class LinearMap : public testing::TestWithParam<int> {};

}    // namespace

// Nanson: a pressure acts on deformed areas, J A^-T times those of the
// reference, so the forces of a body under uniform pressure follow the same
// law.  Only the exact F does that, at faces and corners too

TEST_P(LinearMap, ForcesOfAPressureFollowNanson)
{
  const int dim = GetParam();
  for (double size : {0.1, 1.0, 30.0}) {
    Cloud c = body(dim);
    Matrix3d A = size * large(dim);
    if (dim == 2) A(2, 2) = 1.0;
    press(c, Matrix3d::Identity());
    c.evaluate();
    const std::vector<Vector3d> before = forces(c);
    ASSERT_GT(largest(before), 0.1);

    deform(c, A);
    press(c, A);
    c.evaluate();
    const Matrix3d nanson = A.determinant() * A.inverse().transpose();
    std::vector<Vector3d> expected;
    for (const Vector3d &f : before) expected.push_back(nanson * f);
    EXPECT_LT(largest_difference(forces(c), expected), 1e-13 * largest(expected)) << size;
  }
}

// closed surface: interior particles of a lattice under uniform pressure feel nothing

TEST_P(LinearMap, PressureIsInBalanceInside)
{
  const int dim = GetParam();
  Cloud c = lattice(dim, 9);
  c.opt.frame = Frame::LAGRANGIAN;
  c.opt.viscosity = Viscosity::NONE;
  c.opt.h = 1.0;
  c.refer();
  deform(c, large(dim));
  press(c, large(dim));
  c.evaluate();
  EXPECT_GT(c.f(0).norm(), 0.1);
  EXPECT_LT(c.f(middle(c)).norm(), 1e-14);
}

// det F and least stretch as the frame reports them

TEST_P(LinearMap, DeterminantOfAMirroredBody)
{
  const int dim = GetParam();
  for (Viscosity viscosity : {Viscosity::NONE, Viscosity::CORRECT}) {
    Cloud c = body(dim);
    c.opt.viscosity = viscosity;
    Matrix3d A = large(dim);
    A.row(1) *= -1.0;
    deform(c, A);
    c.evaluate();
    const Overload end = c.sweeps->find_overload();
    EXPECT_EQ(end.kind, Overload::TURNED_OVER);
    EXPECT_EQ(end.particle, 0);
    EXPECT_NEAR(end.value, A.determinant(), 1e-12);
  }
}

// partners are those of the reference, however far they are

TEST_P(LinearMap, PartnersAreKept)
{
  const int dim = GetParam();
  Cloud c = body(dim);
  c.evaluate();
  std::vector<int> before(c.size());
  for (int i = 0; i < c.size(); i++) before[i] = c.sweeps->neighbor_count(i);
  Matrix3d A = 10.0 * large(dim);
  deform(c, A);
  c.evaluate();
  for (int i = 0; i < c.size(); i++) {
    EXPECT_EQ(c.sweeps->neighbor_count(i), before[i]);
    EXPECT_GT(before[i], dim == 2 ? 4 : 9);
  }
}

// the same linear motion everywhere gives every particle the same density, and
// the error of a finite step against det A falls with its square

TEST_P(LinearMap, DensityFollowsTheDeterminant)
{
  const int dim = GetParam();
  double error[2];
  for (int run : {0, 1}) {
    const int steps = run ? 40 : 20;
    const double dt = 1.0 / steps;
    Cloud c = body(dim);
    for (int n = 1; n <= steps; n++) {
      deform(c, Matrix3d::Identity() + n * dt * rates(dim), rates(dim));
      ASSERT_EQ(c.advance(dt), -1);
    }
    const double exact = 1.0 / (Matrix3d::Identity() + rates(dim)).determinant();
    error[run] = c.rho[0] / exact - 1.0;
    for (int i = 0; i < c.size(); i++) EXPECT_NEAR(c.rho[i] / c.rho[0], 1.0, 1e-13);
  }
  EXPECT_LT(std::fabs(error[1]), 1e-3);
  EXPECT_NEAR(error[0] / error[1], 4.0, 0.1);
}

// damping and the limited viscosity do not see a linear motion of a linearly
// deformed body, compression included; the standard viscosity does

TEST_P(LinearMap, HourglassForceVanishes)
{
  const int dim = GetParam();
  Cloud c = body(dim);
  deform(c, large(dim), rates(dim));
  press(c, large(dim));
  c.evaluate();
  const std::vector<Vector3d> without = forces(c);
  c.opt.hourglass = 1.0;
  c.evaluate();
  EXPECT_LT(largest_difference(forces(c), without), 1e-13 * largest(without));
  c.v[c.size() / 2][0] += 0.1;    // no linear motion any more
  c.evaluate();
  EXPECT_GT(largest_difference(forces(c), without), 0.01);
}

TEST_P(LinearMap, LimitedViscosityVanishes)
{
  const int dim = GetParam();
  Cloud c = body(dim);
  Matrix3d compression = -0.3 * large(dim);    // v = -0.3 x
  if (dim == 2) compression(2, 2) = 0.0;
  deform(c, large(dim), compression);
  press(c, large(dim));
  c.evaluate();
  const double without = largest(forces(c));
  c.opt.viscosity = Viscosity::LIMITED;
  EXPECT_LT(viscous_force(c), 1e-13 * without);
  c.opt.viscosity = Viscosity::MONAGHAN;
  EXPECT_GT(viscous_force(c), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Dimension, LinearMap, testing::Values(2, 3), [](const auto &info) {
  return info.param == 2 ? "Flat" : "Full";
});
