/* ----------------------------------------------------------------------
   One material point against exact solutions of perfect and hardening von Mises
   plasticity: uniaxial strain, non-proportional loading, the return map, work.
------------------------------------------------------------------------- */

#include "material_point.h"

#include <gtest/gtest.h>

#include <vector>

using namespace SPHSolid;

namespace {

// limit for n to infinity of values at n, 2n, 4n ...: error terms 1/n, 1/n^2 ...

double romberg(std::vector<double> value)
{
  for (std::size_t k = 1; k < value.size(); k++)
    for (std::size_t i = value.size() - 1; i >= k; i--)
      value[i] += (value[i] - value[i - 1]) / (std::pow(2.0, k) - 1.0);
  return value.back();
}

template <int D> double von_mises(const Tensor<D> &S, double Szz)
{
  return std::sqrt(von_mises_squared<D>(S, Szz));
}

}    // namespace

// uniaxial tension: the stress itself.  S = (2, -1, -1)/3 sigma

TEST(Strength, VonMisesOfUniaxialStress)
{
  Tensor<3> S = Tensor<3>::Zero();
  S.diagonal() << 2.0, -1.0, -1.0;
  EXPECT_NEAR(von_mises<3>(S, 0.0), 3.0, 1e-15);
  EXPECT_NEAR(von_mises<2>(S.topLeftCorner<2, 2>(), -1.0), 3.0, 1e-15);
}

// pure shear: sqrt(3) tau

TEST(Strength, VonMisesOfPureShear)
{
  Tensor<2> S;
  S << 0.0, 5.0, 5.0, 0.0;
  EXPECT_NEAR(von_mises<2>(S, 0.0), 5.0 * std::sqrt(3.0), 1e-14);
}

// elastic uniaxial strain: S_11 = -(4/3) mu ln(rho/rho0)

TEST(Strength, UniaxialStrainElastic)
{
  PointState<3> p = at_rest<3>();
  stretch(perfect, p, 1.0, 0.9965, 400);
  const double S = -4.0 / 3.0 * MU * std::log(p.rho / RHO0);
  EXPECT_EQ(p.epl, 0.0);
  EXPECT_NEAR(p.S(0, 0) / S, 1.0, 1e-10);
  EXPECT_NEAR(p.S(1, 1) / S, -0.5, 1e-10);
  EXPECT_NEAR(p.S(2, 2) / S, -0.5, 1e-10);
}

// yield in compression at rho0 exp(Y/2mu), neither before nor after

TEST(Strength, UniaxialStrainYieldDensity)
{
  const double length = std::exp(-Y0 / (2.0 * MU));
  PointState<3> before = at_rest<3>(), after = at_rest<3>();
  stretch(perfect, before, 1.0, length * (1.0 + 1e-10), 1000);
  stretch(perfect, after, 1.0, length * (1.0 - 1e-10), 1000);
  EXPECT_EQ(before.epl, 0.0);
  EXPECT_GT(after.epl, 0.0);
}

// then S stays at -2/3 Y while the plastic strain takes the rest:
// 3 mu epl = 2 mu ln(rho/rho0) - Y

TEST(Strength, UniaxialStrainPlastic)
{
  PointState<3> p = at_rest<3>();
  const double work = stretch(perfect, p, 1.0, 0.98, 4000);
  EXPECT_NEAR(p.S(0, 0) / Y0, -2.0 / 3.0, 1e-13);
  EXPECT_NEAR(p.S(1, 1) / Y0, 1.0 / 3.0, 1e-13);
  const double epl = (-2.0 * MU * std::log(0.98) - Y0) / (3.0 * MU);
  EXPECT_NEAR(p.epl / epl, 1.0, 1e-10);
  EXPECT_NEAR(work / (Y0 * epl), 1.0, 1e-10);
}

// release from there: elastic with slope 4/3 mu until S = +2/3 Y, which takes
// the strain Y/mu, then plastic again

TEST(Strength, UniaxialStrainUnloadAndReverse)
{
  PointState<3> p = at_rest<3>();
  stretch(perfect, p, 1.0, 0.98, 4000);
  const double loaded = p.epl, half = 0.98 * std::exp(0.5 * Y0 / MU);
  const double full = 0.98 * std::exp(Y0 / MU);
  stretch(perfect, p, 0.98, half, 1000);
  EXPECT_NEAR(p.S(0, 0) / Y0, 0.0, 1e-9);
  stretch(perfect, p, half, full * (1.0 - 1e-9), 1000);
  EXPECT_EQ(p.epl, loaded);
  EXPECT_NEAR(p.S(0, 0) / Y0, 2.0 / 3.0, 1e-6);
  stretch(perfect, p, full * (1.0 - 1e-9), full * 1.001, 100);
  EXPECT_NEAR(p.S(0, 0) / Y0, 2.0 / 3.0, 1e-13);
  EXPECT_NEAR((p.epl - loaded) / (2.0 / 3.0 * std::log(1.001)), 1.0, 1e-5);
}

// the whole way back, against S_11 = -2/3 Y + 4/3 mu ln(rho_max/rho) with rho
// from the length of the bar; and loading again to where it left the surface

TEST(Strength, UniaxialStrainUnloadingAndReloading)
{
  PointState<3> p = at_rest<3>();
  stretch(perfect, p, 1.0, 0.98, 4000);
  const double loaded = p.epl;
  double length = 0.98;
  for (int k = 1; k <= 9; k++) {
    const double next = 0.98 * std::exp(0.1 * k * Y0 / MU);
    stretch(perfect, p, length, next, 400);
    length = next;
    const double S = -2.0 / 3.0 * Y0 + 4.0 / 3.0 * MU * std::log(length / 0.98);
    EXPECT_NEAR(p.S(0, 0) / Y0, S / Y0, 1e-10) << k;
    EXPECT_NEAR(p.S(1, 1) / Y0, -0.5 * S / Y0, 1e-10) << k;
    EXPECT_EQ(p.epl, loaded) << k;
  }
  stretch(perfect, p, length, 0.98 * std::exp(1e-6), 4000);
  EXPECT_EQ(p.epl, loaded);
  EXPECT_NEAR(p.S(0, 0) / Y0, -2.0 / 3.0 + 4.0 / 3.0 * MU / Y0 * 1e-6, 1e-10);
}

// uniaxial stress to yield, then pure shear at constant rate (Prandtl-Reuss).
// In the deviatoric plane S, of length R = sqrt(2/3) Y, turns towards D:
// psi' = -(2 mu |D|/R) sin psi from psi = 90 degrees, so with
// tau = 2 mu |D| t/R the part along D is R tanh(tau), the old part decays as
// 1/cosh(tau).  Own derivation.  Radial return is of first order in the step.

struct Turned {
  double along, across;    // in units of R
};

Turned tension_then_shear(double tau, int n)
{
  const double R = std::sqrt(2.0 / 3.0) * Y0;
  PointState<3> p = at_rest<3>();
  p.S.diagonal() << 2.0 / 3.0 * Y0, -Y0 / 3.0, -Y0 / 3.0;
  Tensor<3> D = Tensor<3>::Zero();
  D(0, 1) = D(1, 0) = 1.0 / std::sqrt(2.0);    // |D| = 1
  steady<3>(perfect, p, D, tau * R / (2.0 * MU), n);
  return {p.S.cwiseProduct(D).sum() / R, p.S(0, 0) / (2.0 / 3.0 * Y0)};
}

TEST(Strength, NonProportionalLoading)
{
  const double tau = 1.2;
  std::vector<double> along, across;
  for (int n = 50; n <= 3200; n *= 2) {
    const Turned s = tension_then_shear(tau, n);
    along.push_back(s.along);
    across.push_back(s.across);
  }
  EXPECT_NEAR(romberg(along), std::tanh(tau), 1e-11);
  EXPECT_NEAR(romberg(across), 1.0 / std::cosh(tau), 1e-11);
}

TEST(Strength, NonProportionalLoadingIsFirstOrder)
{
  const double exact = std::tanh(1.2);
  const double coarse = tension_then_shear(1.2, 400).along - exact;
  const double fine = tension_then_shear(1.2, 800).along - exact;
  EXPECT_NEAR(coarse / fine, 2.0, 0.01);
  EXPECT_LT(std::fabs(fine), 1e-3);
}

// a point that the return map left is on the surface and stays there

TEST(Strength, ReturnMapIsConsistent)
{
  for (const Material &m : {perfect, solid(Strength::LINEAR, 5.0e9)})
    for (double overshoot : {1.0 + 1e-9, 1.5, 100.0}) {
      PointState<3> p = at_rest<3>();
      p.S << 3.0, 1.0, -0.5, 1.0, -1.0, 0.7, -0.5, 0.7, -2.0;
      p.S *= overshoot * Y0 / von_mises<3>(p.S, 0.0);
      radial_return<3>(m, p);
      EXPECT_NEAR(von_mises<3>(p.S, 0.0) / (Y0 + m.H * p.epl), 1.0, 1e-14);
    }
}

TEST(Strength, ReturnMapIsIdempotent)
{
  PointState<2> p = at_rest<2>();
  p.S << 9.0e8, 2.0e8, 2.0e8, -5.0e8;
  p.Szz = -4.0e8;
  EXPECT_GT(radial_return<2>(perfect, p), 0.0);
  const PointState<2> once = p;
  radial_return<2>(perfect, p);
  EXPECT_LT((p.S - once.S).norm(), 1e-14 * Y0);
  EXPECT_NEAR(p.epl, once.epl, 1e-14 * Y0 / MU);
}

// inside the surface nothing happens

TEST(Strength, ReturnMapLeavesElasticAlone)
{
  PointState<2> p = at_rest<2>();
  p.S << 1.0e8, 2.0e8, 2.0e8, -3.0e8;
  p.Szz = 2.0e8;
  const Tensor<2> S = p.S;
  EXPECT_EQ(radial_return<2>(perfect, p), 0.0);
  EXPECT_EQ(p.S, S);
  EXPECT_EQ(p.epl, 0.0);
}

// return along the radius: the direction of S does not change

TEST(Strength, ReturnMapIsRadial)
{
  PointState<2> p = at_rest<2>();
  p.S << 9.0e8, 2.0e8, 2.0e8, -5.0e8;
  p.Szz = -4.0e8;
  radial_return<2>(perfect, p);
  EXPECT_NEAR(p.S(0, 0) / p.Szz, 9.0 / -4.0, 1e-15);
  EXPECT_NEAR(p.S(0, 1) / p.Szz, 2.0 / -4.0, 1e-15);
}

// proportional loading to the equivalent strain eps with linear hardening:
// Y + H epl = 3 mu (eps - epl), in any number of steps

TEST(Strength, LinearHardening)
{
  const double H = 2.0e9, eps = 0.01;
  Tensor<3> D = Tensor<3>::Zero();
  D.diagonal() << 1.0, -0.5, -0.5;    // sqrt(2/3 D:D) = 1
  const double epl = (3.0 * MU * eps - Y0) / (3.0 * MU + H);
  for (int n : {1, 7, 100}) {
    PointState<3> p = at_rest<3>();
    steady<3>(solid(Strength::LINEAR, H), p, D, eps, n);
    EXPECT_NEAR(p.epl / epl, 1.0, 1e-12) << n;
    EXPECT_NEAR(p.S(0, 0) / (2.0 / 3.0 * (Y0 + H * epl)), 1.0, 1e-12) << n;
  }
}

// shear there and back to zero stress: the elastic energy S:S/4mu is returned,
// so the plastic work is all the work of S on the way, sum of S:D dt.
// Yield falls on the end of a step, where the trapezoidal rule is exact

TEST(Strength, PlasticWorkOfClosedCycle)
{
  Tensor<3> D = Tensor<3>::Zero();
  D.diagonal() << 1.0, -0.5, -0.5;
  const double yield = Y0 / (3.0 * MU);    // equivalent strain
  PointState<3> p = at_rest<3>();
  double work = 0.0, plastic = 0.0;
  auto strain = [&](double eps) {
    for (int i = 0; i < 10; i++) {
      const Tensor<3> before = p.S;
      plastic += advance<3>(perfect, p, D, eps / 10.0);
      work += 0.5 * (before + p.S).cwiseProduct(D).sum() * eps / 10.0;
    }
  };
  strain(yield);
  strain(3.0 * yield);
  strain(-2.0 * yield);    // to yield on the other side
  strain(-2.0 * yield);
  strain(yield);
  EXPECT_LT(p.S.norm(), 1e-13 * Y0);
  EXPECT_NEAR(plastic / (5.0 * Y0 * yield), 1.0, 1e-13);
  EXPECT_NEAR(work / plastic, 1.0, 1e-13);
}

// half way, the work is elastic energy plus plastic work

TEST(Strength, WorkIsElasticPlusPlastic)
{
  Tensor<2> D;
  D << 0.0, 0.5, 0.5, 0.0;
  PointState<2> p = at_rest<2>();
  const double plastic = steady<2>(perfect, p, D, 2.0 * Y0 / (std::sqrt(3.0) * MU), 2);
  const double tau = Y0 / std::sqrt(3.0), stored = p.S.squaredNorm() / (4.0 * MU);
  EXPECT_NEAR(p.S(0, 1) / tau, 1.0, 1e-14);
  // triangle to yield and rectangle after it: 1/2 tau g + tau g, g = tau/mu
  EXPECT_NEAR((stored + plastic) / (1.5 * tau * tau / MU), 1.0, 1e-13);
}
