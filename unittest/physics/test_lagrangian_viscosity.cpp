/* ----------------------------------------------------------------------
   Viscosity in the Lagrangian frame: what the limited one leaves, what the
   acceleration correction filters out, and where the ledger has the heat.
------------------------------------------------------------------------- */

#include "lagrangian_body.h"

#include <gtest/gtest.h>

#include <functional>

using namespace SPHSolid;

// every pair dissipates: so half of the heat of all its pairs is positive for
// each particle, and no particle is cooled

TEST(LimitedViscosity, HeatsEveryParticle)
{
  for (int dim : {2, 3}) {
    Cloud c = shaken(dim, 1);
    c.opt.viscosity = Viscosity::LIMITED;
    const std::vector<double> limited = viscous_heat(c);
    for (double one : limited) EXPECT_GE(one, -1e-16);
    c.opt.viscosity = Viscosity::MONAGHAN;
    EXPECT_GT(sum(limited), 0.0);
    EXPECT_LT(sum(limited), sum(viscous_heat(c)));
  }
}

// half of all particles, at random, become another material

void mix(Cloud &c, double denser, double C)
{
  Noise noise(22);
  std::vector<int> others;
  for (int i = 0; i < c.size(); i++)
    if (noise() > 0.0) others.push_back(i);
  c.make_others(others, denser, C);
}

// a lattice that is smaller by the same factor along all axes, and turned, is what a kernel with a
// smaller h would have made of it: whatever the velocities, viscous forces in the bulk are those of
// the Eulerian frame (test_viscosity.cpp), times B, which that one does not have.  Kernel gradients
// have 24 bits

class LagrangianViscosity : public testing::TestWithParam<int> {};

// denser: of two materials, mixed at random, the second is so many times denser than the first and has
// another speed of sound

void compare_with_a_smaller_lattice(int dim, double denser)
{
  const int n = dim == 2 ? 15 : 13;
  const double smaller = 0.8;
  const Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(0, 0, 1)).toRotationMatrix();
  Cloud c = lattice(dim, n);
  const double B = dim / (moment(c, middle(c)).trace() - (3 - dim));
  if (denser != 1.0) mix(c, denser, 0.5);
  c.refer();
  Noise noise(21);
  for (int i = 0; i < c.size(); i++) {
    c.x[i] = smaller * turn * c.x[i];
    c.v[i] = noise.vector(dim);
    c.rho[i] *= std::pow(smaller, -dim);
  }
  c.opt.a1 = 1.0;
  c.opt.a2 = 2.0;
  auto viscous = [&](Frame frame, double h) -> Vector3d {
    c.opt.frame = frame;
    c.opt.h = h;
    c.opt.viscosity = Viscosity::NONE;
    c.evaluate();
    const Vector3d without = c.f(middle(c));
    c.opt.viscosity = Viscosity::MONAGHAN;
    c.evaluate();
    return c.f(middle(c)) - without;
  };
  const Vector3d expected = B * viscous(Frame::EULERIAN, smaller * 1.3);
  EXPECT_GT(expected.norm(), 0.1 * B);
  EXPECT_LT((viscous(Frame::LAGRANGIAN, 1.3) - expected).norm(), 3e-7 * expected.norm() / B);
}

TEST_P(LagrangianViscosity, IsTheEulerianOneOfASmallerLattice)
{
  compare_with_a_smaller_lattice(GetParam(), 1.0);
}

TEST_P(LagrangianViscosity, IsTheEulerianOneOfTwoMaterials)
{
  for (double denser : {10.0, 100.0}) compare_with_a_smaller_lattice(GetParam(), denser);
}

// one particle moves in a lattice at rest.  Of the harmonic mean 2ab/(a+b) of what it has itself, a, and what
// all others have, b = R a, is 2R/(1+R) a: so many times as large are the forces on it as among its own kind.
// Speeds of sound are those of its own kind.  That one pulls with the material: it needs no viscosity

TEST_P(LagrangianViscosity, HarmonicMeansOfAStranger)
{
  const int dim = GetParam();
  auto on_stranger = [dim](double denser, bool hourglass) -> Vector3d {
    Cloud c = lattice(dim, dim == 2 ? 11 : 9);
    c.opt.frame = Frame::LAGRANGIAN;
    c.opt.viscosity = hourglass ? Viscosity::NONE : Viscosity::MONAGHAN;
    c.opt.hourglass = hourglass ? 0.3 : 0.0;
    std::vector<int> others;
    for (int i = 0; i < c.size(); i++)
      if (i != middle(c)) others.push_back(i);
    if (denser != 1.0) c.make_others(others, denser, 1.0);
    c.v[middle(c)] = Vector3d(0.1, 0.2, dim == 3 ? 0.3 : 0.0);
    c.evaluate();    // nothing has moved yet: no stress
    return c.f(middle(c));
  };
  for (bool hourglass : {false, true}) {
    // hourglass forces of pairs are numbers in single precision
    const double rounding = hourglass ? 0x1p-24 : 1e-13;
    const Vector3d alike = on_stranger(1.0, hourglass);
    EXPECT_GT(alike.norm(), 0.01);
    for (double denser : {0.01, 0.1, 10.0, 100.0}) {
      const Vector3d expected = 2.0 * denser / (1.0 + denser) * alike;
      EXPECT_LT((on_stranger(denser, hourglass) - expected).norm(), rounding * expected.norm());
    }
  }
}

// conservation does not depend on which mean it is, nor does that every pair dissipates

TEST_P(LagrangianViscosity, OfTwoMaterialsConservesAndDissipates)
{
  for (Viscosity viscosity : VISCOSITIES)
    for (double hourglass : {0.0, 0.3}) {
      Cloud c = body(GetParam(), 6);
      mix(c, 100.0, 2.0);
      c.opt.viscosity = viscosity;
      c.opt.hourglass = hourglass;
      c.refer();
      deform(c, large(c.dim));
      Noise noise(32);
      c.stir(noise, 0.05);
      c.evaluate(0.01);
      EXPECT_LT(net_force(c), 1e-13);
      const bool central = viscosity != Viscosity::CORRECT;
      EXPECT_LT(central ? net_torque(c) : 0.0, 1e-13);
      EXPECT_LT(energy_error(c, random_displacement(c, 6)), 1e-13);
      if (viscosity == Viscosity::NONE || viscosity == Viscosity::CORRECT) continue;
      for (double one : viscous_heat(c)) EXPECT_GE(one, -1e-14);
    }
}

// densities that differ by rounding only, as after a mass that is a product, are alike

TEST_P(LagrangianViscosity, RoundingMakesNoMaterialUnlike)
{
  Cloud c = shaken(GetParam(), 7);
  c.opt.viscosity = Viscosity::MONAGHAN;
  c.opt.hourglass = 0.3;
  for (int i = 0; i < c.size(); i++) c.vref[i] = c.mass[i];
  c.vref[3] *= 1.0 + 2e-15;
  c.evaluate();
  EXPECT_FALSE(c.sweeps->unlike);
  c.vref[3] *= 1.0 + 1e-11;
  c.evaluate();
  EXPECT_TRUE(c.sweeps->unlike);
}

// a body turns that is deformed in any way, such as its kernel does not resolve: no particle comes
// closer to another, and neither damping nor viscosity feels anything

TEST_P(LagrangianViscosity, NothingOfItInARotation)
{
  Cloud c = shaken(GetParam(), 5);
  const Vector3d axis = c.dim == 2 ? Vector3d(0, 0, 3) : Vector3d(1, -2, 3);
  c.move([&](const Vector3d &x) -> Vector3d {
    return axis.cross(x);
  });
  c.evaluate();
  const std::vector<Vector3d> without = forces(c);
  c.opt.hourglass = 10.0;
  for (Viscosity viscosity : {Viscosity::NONE, Viscosity::LIMITED, Viscosity::FRONT}) {
    c.opt.viscosity = viscosity;
    c.evaluate();
    EXPECT_LT(largest_difference(forces(c), without), 1e-12 * largest(without));
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, LagrangianViscosity, testing::Values(2, 3));

// all forces of the last evaluation, but with these viscous accelerations for the correction

std::vector<Vector3d> forces_with(Cloud &c, const std::function<Vector3d(int)> &acceleration)
{
  c.sweeps->force(c.particles(), c.neighbors());
  c.forget_forces();
  for (int i = 0; i < c.size(); i++) c.set(Message::VISCOUS, i, acceleration(i));
  c.sweeps->correction(c.particles(), c.neighbors());
  return forces(c);
}

Vector3d nothing(int)
{
  return Vector3d::Zero();
}

// the filter of the acceleration correction: nothing is left of a constant

TEST(LagrangianCorrection, VanishesForAConstant)
{
  for (int dim : {2, 3}) {
    Cloud c = shaken(dim, 2);
    c.opt.viscosity = Viscosity::CORRECT;
    c.evaluate();
    const std::vector<Vector3d> without = forces_with(c, nothing),
                                of_constant = forces_with(c, [](int) {
                                  return Vector3d(7.0, 8.0, 9.0);
                                });
    EXPECT_GT(largest(without), 0.0);
    EXPECT_EQ(largest_difference(of_constant, without), 0.0);
  }
}

// and of a chess board, on a lattice with hbar = 1.5: neighbors along the axes
// have Wbar(4/3) ~ (2/3)^3 and differ, those on the diagonals Wbar(4 sqrt(2)/3) ~
// (2 - 4 sqrt(2)/3)^3 and do not.  Positions do not count, those in the reference do.  Weights have
// 32 bits

TEST(LagrangianCorrection, LeavesAChessBoard)
{
  Cloud c = lattice(2, 9);
  c.opt.frame = Frame::LAGRANGIAN;
  c.opt.viscosity = Viscosity::CORRECT;
  c.refer();
  deform(c, large(2));
  c.evaluate();
  const std::vector<Vector3d> without = forces_with(c, nothing);
  const std::vector<Vector3d> with = forces_with(c, [](int i) {    // 9 to a row
    return Vector3d(i % 2 ? -1.0 : 1.0, 0.0, 0.0);
  });
  const double axis = std::pow(2.0 / 3.0, 3),
               diagonal = std::pow(2.0 - 4.0 / 3.0 * std::sqrt(2.0), 3);
  EXPECT_NEAR(with[40][0] - without[40][0], axis / (axis + diagonal), 0x1p-32);
  EXPECT_NEAR(with[41][0] - without[41][0], -axis / (axis + diagonal), 0x1p-32);
}

// the ledger: heat that is left and heat given back are the standard heating

TEST(LagrangianLedger, AddsUp)
{
  for (int dim : {2, 3}) {
    Cloud c = shaken(dim, 3);
    c.opt.viscosity = Viscosity::MONAGHAN;
    const double standard = sum(viscous_heat(c));
    c.opt.viscosity = Viscosity::CORRECT;
    const double left = sum(viscous_heat(c));
    const Ledger ledger = booked_heat(c);
    EXPECT_NEAR(ledger.viscous_heat / left, 1.0, 1e-11);
    EXPECT_NEAR(ledger.returned / (standard - left), 1.0, 1e-11);
    EXPECT_EQ(ledger.hourglass, 0.0);
  }
}

TEST(LagrangianLedger, HoldsTheHourglassHeat)
{
  for (int dim : {2, 3}) {
    Cloud c = shaken(dim, 4);
    c.evaluate();
    const double without = power(c);
    c.opt.hourglass = 0.1;
    const Ledger ledger = booked_heat(c);
    EXPECT_GT(ledger.hourglass, 0.0);
    EXPECT_NEAR(ledger.hourglass / (without - power(c)), 1.0, 1e-11);
    EXPECT_EQ(ledger.viscous_heat, 0.0);
  }
}
