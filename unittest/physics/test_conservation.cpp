/* ----------------------------------------------------------------------
   Conservation laws of one force evaluation on clouds of particles with
   random positions, velocities, densities, energies and stresses.

   A law holds to rounding or it does not hold: the sums cancel to about
   1e-16 of their terms.
------------------------------------------------------------------------- */

#include "spline_by_hand.h"
#include "sums.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <tuple>

using namespace SPHSolid;

namespace {

// is the gradient of a particle not corrected?  Its moment matrix: less than 0.4 of a round one of the same
// trace, or a mean below 0.8 of the quarter of a corner of half cells

bool is_plain(const Matrix3d &moment)
{
  const Eigen::Matrix2d m = moment.topLeftCorner<2, 2>();
  const double mean = 0.5 * m.trace();
  return m.determinant() <= 0.4 * mean * mean || mean <= 0.8 / 4.0;
}

// what the standard viscosity takes from the motion per time

double standard_heating(Cloud &c)
{
  const Viscosity chosen = c.opt.viscosity;
  c.opt.viscosity = Viscosity::MONAGHAN;
  c.evaluate();
  const double with = power(c);
  c.opt.viscosity = Viscosity::NONE;
  c.evaluate();
  c.opt.viscosity = chosen;
  return power(c) - with;
}

Matrix3d cauchy_stress(const Cloud &c, int i)
{
  // P(rho,e), Shaw & Reid (2009), eqs 8-13, with rho0 = C = 1, S = Gamma = 1.8
  const double eta = c.rho[i] * c.volume[i] / c.mass[i] - 1.0;
  double P_H = eta;
  if (eta > 0.0) P_H += eta * eta * (2.6 + eta * 3.52);
  const double P = (1.0 - 0.9 * eta) * P_H + 1.8 * c.rho[i] * c.e[i];
  return symmetric(c.S[i].data()) - P * Matrix3d::Identity();
}

// every numerical option there is: dimension, viscosity, gradient, tensile

using Choice = std::tuple<int, Viscosity, bool, bool>;

class Conservation : public testing::TestWithParam<Choice> {
 protected:
  Cloud cloud(int seed) const
  {
    auto [dim, viscosity, corrected, tensile] = GetParam();
    Cloud c = random_cloud(dim, seed);
    c.opt.viscosity = viscosity;
    c.opt.corrected = corrected;
    c.opt.tensile = tensile;
    c.opt.tensile_eps = 0.3;
    return c;
  }
};

std::string name(const testing::TestParamInfo<Choice> &info)
{
  auto [dim, viscosity, corrected, tensile] = info.param;
  std::string s = dim == 2 ? "Flat" : "Full";
  s += name_of(viscosity);
  s += corrected ? "Corrected" : "Plain";
  s += tensile ? "Tensile" : "";
  return s;
}

}    // namespace

/* ---------------------------------------------------------------------- */

// action and reaction

TEST_P(Conservation, LinearMomentum)
{
  Cloud c = cloud(1);
  c.evaluate();
  EXPECT_LT(net_force(c), 1e-14);
}

// also after an update of density and stress

TEST_P(Conservation, LinearMomentumAfterStep)
{
  Cloud c = cloud(2);
  c.material.strength = Strength::PERFECT;
  c.material.Y = 0.02;
  c.evaluate(0.1);
  EXPECT_LT(net_force(c), 1e-14);
}

// what the motion loses becomes heat: sum m v.a + sum heat = 0

TEST_P(Conservation, Energy)
{
  Cloud c = cloud(3);
  c.evaluate();
  EXPECT_LT(energy_error(c, c.v), 1e-13);
}

TEST_P(Conservation, EnergyAfterStep)
{
  Cloud c = cloud(4);
  c.evaluate(0.1);
  EXPECT_LT(energy_error(c, c.v), 1e-13);
}

// a train passing by sees the same heating of every particle

TEST_P(Conservation, HeatIsGalileanInvariant)
{
  Cloud c = cloud(5);
  c.evaluate();
  EXPECT_LT(galilean_error(c), 1e-12);
}

// the virial is sum x_i f_i, whatever the pairs

TEST_P(Conservation, Virial)
{
  Cloud c = cloud(6);
  c.evaluate();
  EXPECT_LT(virial_error(c), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Options, Conservation,
                         testing::Combine(testing::Values(2, 3), testing::ValuesIn(VISCOSITIES),
                                          testing::Bool(), testing::Bool()),
                         name);

/* ----------------------------------------------------------------------
   the acceleration correction: who conserves what
------------------------------------------------------------------------- */

// shepard weights are not symmetric: momentum leaks, energy does not

TEST(Correction, ShepardConservesEnergy)
{
  for (int dim : {2, 3}) {
    Cloud c = random_cloud(dim);
    c.opt.weights = Weights::SHEPARD;
    c.evaluate();
    EXPECT_LT(energy_error(c, c.v), 1e-13);
    EXPECT_GT(net_force(c), 1e-4);
  }
}

// eq. 30 of Shaw & Reid (2009) as printed makes one whole standard heating too
// much.  With m_i w_ij symmetric the surplus is
//   sum 1/2 m_i w_ij (v_i.da_i - v_j.da_j) = 0  plus  the standard heating:
// exactly one, whatever the weights sum to (own derivation)

TEST(Correction, PrintedHeatingIsOneStandardTooMuch)
{
  for (int dim : {2, 3}) {
    Cloud c = random_cloud(dim);
    const double standard = standard_heating(c);
    ASSERT_GT(standard, 0.0);
    c.opt.heating = Heating::PRINTED;
    c.evaluate();
    const double surplus = power(c) + sum(c.heat(c.v));
    EXPECT_NEAR(surplus / standard, 1.0, 1e-12);
  }
}

// the ledger: heat that is left and heat given back are the standard heating

TEST(Correction, LedgerAddsUpToStandardHeating)
{
  Cloud c = random_cloud(2);
  const double standard = standard_heating(c);
  const Ledger ledger = booked_heat(c);
  EXPECT_NEAR((ledger.viscous_heat + ledger.returned) / standard, 1.0, 1e-12);
}

TEST(Correction, LedgerHoldsViscousHeat)
{
  Cloud c = random_cloud(2);
  const double heat = sum(viscous_heat(c));
  EXPECT_NEAR(booked_heat(c).viscous_heat / heat, 1.0, 1e-12);
  EXPECT_GT(heat, 0.0);
}

TEST(Correction, UnbookedHeatIsNotInLedger)
{
  Cloud c = random_cloud(2);
  c.evaluate();
  c.heat(c.v);
  EXPECT_EQ(c.sweeps->ledger.viscous_heat, 0.0);
  EXPECT_EQ(c.sweeps->ledger.returned, 0.0);
}

// what is booked is what the energies of particles rise by

TEST(Correction, HeatBecomesEnergyOfParticles)
{
  for (const Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN})
    for (int dim : {2, 3}) {
      Cloud c = random_cloud(dim);
      c.opt.frame = frame;
      c.refer();
      c.evaluate();
      const std::vector<double> heat = c.heat(c.v), before = c.e;
      c.add_heat(c.v);
      for (int i = 0; i < c.size(); i++)
        EXPECT_NEAR(c.e[i] - before[i], heat[i] / c.mass[i],
                    1e-13 * std::abs(heat[i] / c.mass[i]) + 1e-15);
      EXPECT_NE(c.sweeps->ledger.viscous_heat, 0.0);
    }
}

/* ----------------------------------------------------------------------
   which particles are corrected: thin bodies of half cells
------------------------------------------------------------------------- */

namespace {

// M without the code's kernel

Matrix3d moment_by_hand(const Cloud &c, int i)
{
  Matrix3d m = Matrix3d::Zero();
  for (int j = 0; j < c.size(); j++) {
    if (j == i) continue;
    const Vector3d d = c.x[j] - c.x[i];
    m += c.mass[j] / c.rho[j] * psi_by_hand(2, d.norm(), c.opt.h) * d * d.transpose();
  }
  return m;
}

// nx x ny particles, those on faces with half cells; h = 1.5 spacings

Cloud half_cells(int nx, int ny)
{
  Cloud c(2);
  c.opt.h = 1.5;
  c.opt.viscosity = Viscosity::NONE;
  c.add_lattice(nx, ny);
  for (int i = 0; i < c.size(); i++) {
    if (c.x[i][0] == 0.0 || c.x[i][0] == nx - 1.0) c.volume[i] *= 0.5;
    if (c.x[i][1] == 0.0 || c.x[i][1] == ny - 1.0) c.volume[i] *= 0.5;
  }
  c.mass = c.volume;
  return c;
}

constexpr double TURN = 1e-7;    // in one step, in which a rotation leaves stresses of its square

// the deviator that a rotation makes in one step, over mu times its angle

Matrix3d false_stress(Cloud &c, int i)
{
  c.move([](Vector3d x) -> Vector3d {
    return TURN * Vector3d(-x[1], x[0], 0.0);
  });
  EXPECT_EQ(c.advance(1.0), -1);
  return symmetric(c.S[i].data()) / (c.material.shear * TURN);
}

// and what sums have that are not corrected: with v = G x, L = G M, M is known

Matrix3d false_stress_without_correction(const Cloud &c, int i)
{
  Matrix3d G = Matrix3d::Zero();
  G(0, 1) = -1.0;
  G(1, 0) = 1.0;
  const Matrix3d L = G * moment_by_hand(c, i);
  return L + L.transpose() - 2.0 / 3.0 * L.trace() * Matrix3d::Identity();
}

}    // namespace

// a rotation deforms nothing where the gradient is corrected.  It is where tr M/d is more than
// 0.8/2^d = 0.2, 0.8 of that in a corner of half cells: in the middle of two rows, 0.254, and in the corner of a
// thick body, 0.252, but not in that of the two rows, 0.127

TEST(ThinBodies, CornersOfTwoRowsAreNotCorrectedAndTheirMiddleIs)
{
  Cloud c = half_cells(13, 2);
  const int corner = 0, inner = 12;
  ASSERT_EQ(c.x[inner][0], 6.0);
  EXPECT_NEAR(0.5 * moment_by_hand(c, corner).trace(), 0.127, 0.0005);
  EXPECT_NEAR(0.5 * moment_by_hand(c, inner).trace(), 0.254, 0.0005);
  const Matrix3d expected = false_stress_without_correction(c, corner);
  EXPECT_LT(false_stress(c, inner).norm(), 1e-6);
  EXPECT_GT(expected.norm(), 0.05);
  Cloud again = half_cells(13, 2);
  EXPECT_LT((false_stress(again, corner) - expected).norm(), 1e-6);
}

TEST(ThinBodies, CornersOfThickOnesAreCorrected)
{
  Cloud c = half_cells(9, 9);
  EXPECT_NEAR(0.5 * moment_by_hand(c, 0).trace(), 0.252, 0.0005);
  EXPECT_GT(false_stress_without_correction(c, 0).norm(), 0.05);
  EXPECT_LT(false_stress(c, 0).norm(), 1e-6);
}

/* ----------------------------------------------------------------------
   angular momentum
------------------------------------------------------------------------- */

// the standard viscosity acts along the line of centers

TEST(AngularMomentum, MonaghanViscosity)
{
  for (int dim : {2, 3}) {
    Cloud c = random_cloud(dim);
    c.no_stress();
    c.opt.viscosity = Viscosity::MONAGHAN;
    c.evaluate();
    EXPECT_LT(net_torque(c), 1e-14);
  }
}

// so does pressure without gradient correction

TEST(AngularMomentum, PlainPressure)
{
  for (int dim : {2, 3}) {
    Cloud c = random_cloud(dim);
    for (auto &s : c.S) s = {};
    c.opt.viscosity = Viscosity::NONE;
    c.opt.corrected = false;
    c.evaluate();
    EXPECT_LT(net_torque(c), 1e-14);
  }
}

// shear stress does not.  Sorting the pair torques by the stress they come
// from, with M_i = sum_j V_j (x_j - x_i) (x) grad W_ij and forces
// V_i V_j (sigma_i B_i + sigma_j B_j) grad W:
//   torque = sum_i V_i (sigma_i B_i M_i)_xy - (..)_yx   (own derivation).
// With B = M^-1 nothing is left of it, since sigma is symmetric, at corners of the body neither; it leaks
// where all neighbors lie in a row and B = 1

TEST(AngularMomentum, CorrectedGradientWithCorners)
{
  Cloud c = random_cloud(2);
  c.opt.viscosity = Viscosity::NONE;
  int corners = 0;
  for (int i = 0; i < c.size(); i++) {
    ASSERT_FALSE(is_plain(moment(c, i)));
    if (moment(c, i).determinant() < 0.15) corners++;
  }
  EXPECT_GE(corners, 4);
  c.evaluate();
  EXPECT_LT(net_torque(c), 1e-14);
}

TEST(AngularMomentum, CorrectedGradientLeaksInARowOnly)
{
  Cloud c(2);
  c.add_lattice(14, 14);
  for (int k = 14; k < 22; k++) c.add(Vector3d(k, 6, 0), Vector3d::Zero());
  Noise noise(1);
  c.stir(noise, 0.05);
  c.opt.viscosity = Viscosity::NONE;
  c.evaluate();
  double exact = 0.0;
  int in_a_row = 0;
  for (int i = 0; i < c.size(); i++) {
    const Matrix3d m = moment(c, i);
    if (!is_plain(m)) continue;
    in_a_row++;
    const Matrix3d t = c.mass[i] / c.rho[i] * cauchy_stress(c, i) * m;
    exact += t(0, 1) - t(1, 0);
  }
  EXPECT_GE(in_a_row, 4);
  EXPECT_LE(in_a_row, 8);
  EXPECT_GT(std::fabs(exact), 1e-4 * absolute_torque(c));
  EXPECT_NEAR(torque(c)[2], exact, SINGLE * absolute_torque(c));
}

TEST(AngularMomentum, CorrectedGradientOfDisc)
{
  Cloud c = disc();
  c.opt.viscosity = Viscosity::NONE;
  for (int i = 0; i < c.size(); i++) ASSERT_FALSE(is_plain(moment(c, i)));
  c.evaluate();
  EXPECT_LT(net_torque(c), 1e-14);
}

// plain: m_i m_j (sigma_i/rho_i^2 + sigma_j/rho_j^2) grad W leaks everywhere, this much

TEST(AngularMomentum, PlainShearStressLeaks)
{
  Cloud c = random_cloud(2);
  c.opt.viscosity = Viscosity::NONE;
  c.opt.corrected = false;
  c.evaluate();
  double exact = 0.0;
  for (int i = 0; i < c.size(); i++) {
    const Matrix3d t = c.mass[i] / (c.rho[i] * c.rho[i]) * cauchy_stress(c, i) * moment(c, i, true);
    exact += t(0, 1) - t(1, 0);
  }
  EXPECT_NEAR(torque(c)[2], exact, SINGLE * absolute_torque(c));
  EXPECT_GT(std::fabs(exact), 1e-4 * absolute_torque(c));
}
