/* ----------------------------------------------------------------------
   One material point against exact solutions of the Jaumann rate and of
   perfect and hardening von Mises plasticity.
------------------------------------------------------------------------- */

#include "sph_solid_strength.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

using namespace SPHSolid;

namespace {

constexpr double RHO0 = 7850.0, MU = 80.0e9, Y0 = 600.0e6;

Material solid(Strength strength, double H = 0.0)
{
  Material m;
  m.rho0 = RHO0;
  m.shear = MU;
  m.strength = strength;
  m.Y = Y0;
  m.H = H;
  return m;
}

const Material elastic = solid(Strength::ELASTIC);
const Material perfect = solid(Strength::PERFECT);

template <int D> PointState<D> at_rest()
{
  PointState<D> p;
  p.rho = RHO0;
  return p;
}

// n equal steps of a constant spatial velocity gradient over the time t

template <int D>
double steady(const Material &m, PointState<D> &p, const Tensor<D> &L, double t, int n)
{
  double work = 0.0;
  for (int i = 0; i < n; i++) work += advance<D>(m, p, L, t / n);
  return work;
}

// one step that takes the deformation gradient from F0 to F1, as the package
// sees it: gradient of the velocity with respect to the positions at the end

template <int D>
double deform(const Material &m, PointState<D> &p, const Tensor<D> &F0, const Tensor<D> &F1,
              double dt)
{
  const Tensor<D> L_end = (F1 - F0) / dt * F1.inverse();
  return advance<D>(m, p, midpoint_velocity_gradient<D>(L_end, dt), dt);
}

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

// stretch along x of a bar of unit length in n steps

double stretch(const Material &m, PointState<3> &p, double from, double to, int n)
{
  double work = 0.0;
  for (int i = 0; i < n; i++) {
    Tensor<3> F0 = Tensor<3>::Identity(), F1 = F0;
    F0(0, 0) = from + (to - from) * i / n;
    F1(0, 0) = from + (to - from) * (i + 1) / n;
    work += deform<3>(m, p, F0, F1, 1.0e-6);
  }
  return work;
}

Tensor<3> deviator(const Tensor<3> &t)
{
  return t - t.trace() / 3.0 * Tensor<3>::Identity();
}

// limit for n to infinity of values at n, 2n, 4n ...: error terms 1/n, 1/n^2 ...

double romberg(std::vector<double> value)
{
  for (std::size_t k = 1; k < value.size(); k++)
    for (std::size_t i = value.size() - 1; i >= k; i--)
      value[i] += (value[i] - value[i - 1]) / (std::pow(2.0, k) - 1.0);
  return value.back();
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

/* ----------------------------------------------------------------------
   plasticity
------------------------------------------------------------------------- */

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
