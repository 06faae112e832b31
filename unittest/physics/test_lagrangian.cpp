/* ----------------------------------------------------------------------
   The Lagrangian frame: exact deformation gradients, conservation laws,
   hourglass damping, limited viscosity, periodic bodies and where it ends.

   Bodies have a disordered reference configuration with particles of different
   volume, and are deformed since.
------------------------------------------------------------------------- */

#include "cloud.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <tuple>

using namespace SPHSolid;

namespace {

Matrix3d rows(double xx, double xy, double xz, double yx, double yy, double yz, double zx,
              double zy, double zz)
{
  Matrix3d m;
  m << xx, xy, xz, yx, yy, yz, zx, zy, zz;
  return m;
}

// a jittered body at rest in its reference, without stress

Cloud body(int dim, int seed = 1, double jitter = 0.2)
{
  Cloud c(dim);
  c.opt.frame = Frame::LAGRANGIAN;
  c.opt.viscosity = Viscosity::NONE;
  if (dim == 2)
    c.add_lattice(9, 8);
  else
    c.add_lattice(5, 5, 4);
  Noise noise(seed);
  for (int i = 0; i < c.size(); i++) {
    c.x[i] += jitter * noise.vector(dim);
    c.volume[i] *= 1.0 + 0.2 * noise();
    c.mass[i] = c.volume[i] * c.material.rho0;
  }
  c.refer();
  return c;
}

// x = A X, v = G X

void deform(Cloud &c, const Matrix3d &A, const Matrix3d &G = Matrix3d::Zero())
{
  for (int i = 0; i < c.size(); i++) {
    c.x[i] = A * c.xref[i];
    c.v[i] = G * c.xref[i];
  }
}

// large stretch and shear with a rotation; plane in two dimensions

Matrix3d large(int dim)
{
  return dim == 2 ? rows(1.8, 0.6, 0, -0.5, 0.7, 0, 0, 0, 1)
                  : rows(1.8, 0.6, -0.2, -0.5, 0.7, 0.3, 0.2, 0.4, 1.3);
}

Matrix3d rates(int dim)
{
  return dim == 2 ? rows(0.3, -0.2, 0, 0.4, -0.5, 0, 0, 0, 0)
                  : rows(0.3, -0.2, 0.1, 0.4, -0.5, 0.2, -0.3, 0.1, 0.2);
}

// stretched, sheared, shaken, pre-stressed and in motion

Cloud shaken(int dim, int seed)
{
  Cloud c = body(dim, seed);
  const Matrix3d A = dim == 2 ? rows(1.2, 0.3, 0, -0.1, 0.8, 0, 0, 0, 1)
                              : rows(1.2, 0.3, -0.1, -0.1, 0.8, 0.2, 0.1, 0.1, 1.1);
  deform(c, A);
  Noise noise(100 + seed);
  c.stir(noise, 0.05);
  return c;
}

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

std::vector<Vector3d> forces(const Cloud &c)
{
  std::vector<Vector3d> f(c.size());
  for (int i = 0; i < c.size(); i++) f[i] = c.f(i);
  return f;
}

double largest(const std::vector<Vector3d> &all)
{
  double most = 0.0;
  for (const Vector3d &one : all) most = std::max(most, one.norm());
  return most;
}

double largest_difference(const std::vector<Vector3d> &a, const std::vector<Vector3d> &b)
{
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); i++) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

/* ----------------------------------------------------------------------
   for every viscosity, with and without hourglass damping
------------------------------------------------------------------------- */

using Choice = std::tuple<int, Viscosity, bool>;

class Lagrangian : public testing::TestWithParam<Choice> {
 protected:
  Cloud cloud(int seed) const
  {
    auto [dim, viscosity, hourglass] = GetParam();
    Cloud c = shaken(dim, seed);
    c.opt.viscosity = viscosity;
    c.opt.hourglass = hourglass ? 0.1 : 0.0;
    return c;
  }
};

std::string name(const testing::TestParamInfo<Choice> &info)
{
  auto [dim, viscosity, hourglass] = info.param;
  std::string s = dim == 2 ? "Flat" : "Full";
  s += name_of(viscosity);
  s += hourglass ? "Hourglass" : "";
  return s;
}

class LagrangianCentral : public Lagrangian {};

}    // namespace

/* ----------------------------------------------------------------------
   linear fields
------------------------------------------------------------------------- */

// Nanson: a pressure acts on deformed areas, J A^-T times those of the
// reference, so the forces of a body under uniform pressure follow the same
// law.  Only the exact F does that, at faces and corners too

class LinearMap : public testing::TestWithParam<int> {};

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
  Cloud c(dim);
  c.opt.frame = Frame::LAGRANGIAN;
  c.opt.viscosity = Viscosity::NONE;
  c.opt.h = 1.0;
  c.add_lattice(9, 9, 9);
  c.refer();
  deform(c, large(dim));
  press(c, large(dim));
  c.evaluate();
  EXPECT_GT(c.f(0).norm(), 0.1);
  const int middle = dim == 2 ? 4 * 9 + 4 : (4 * 9 + 4) * 9 + 4;
  EXPECT_LT(c.f(middle).norm(), 1e-14);
}

// det F and least stretch as the frame reports them

TEST_P(LinearMap, DeterminantOfAMirroredBody)
{
  const int dim = GetParam();
  Cloud c = body(dim);
  Matrix3d A = large(dim);
  A.row(1) *= -1.0;
  deform(c, A);
  c.evaluate();
  const Overload end = c.sweeps->find_overload(c.neighbors());
  EXPECT_EQ(end.kind, Overload::TURNED_OVER);
  EXPECT_EQ(end.particle, 0);
  EXPECT_NEAR(end.value, A.determinant(), 1e-12);
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
  const std::vector<Vector3d> without = forces(c);
  c.opt.viscosity = Viscosity::LIMITED;
  c.evaluate();
  EXPECT_LT(largest_difference(forces(c), without), 1e-13 * largest(without));
  c.opt.viscosity = Viscosity::MONAGHAN;
  c.evaluate();
  EXPECT_GT(largest_difference(forces(c), without), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Dimension, LinearMap, testing::Values(2, 3), [](const auto &info) {
  return info.param == 2 ? "Flat" : "Full";
});

/* ----------------------------------------------------------------------
   conservation laws
------------------------------------------------------------------------- */

TEST_P(Lagrangian, LinearMomentum)
{
  Cloud c = cloud(1);
  c.evaluate();
  EXPECT_LT(net_force(c), 1e-13);
}

TEST_P(Lagrangian, LinearMomentumAfterStep)
{
  Cloud c = cloud(2);
  c.material.strength = Strength::PERFECT;
  c.material.Y = 0.02;
  c.evaluate(0.1);
  EXPECT_LT(net_force(c), 1e-13);
}

// the correction is not central; all the rest is

TEST_P(LagrangianCentral, AngularMomentum)
{
  Cloud c = cloud(3);
  c.evaluate();
  EXPECT_LT(torque(c).norm(), 1e-13 * absolute_torque(c));
}

TEST_P(LagrangianCentral, AngularMomentumAfterStep)
{
  Cloud c = cloud(4);
  c.evaluate(0.1);
  EXPECT_LT(torque(c).norm(), 1e-13 * absolute_torque(c));
}

// what any displacement takes from the forces is heat

TEST_P(Lagrangian, HeatOfAnyDisplacement)
{
  for (double dt : {0.0, 0.1}) {
    Cloud c = cloud(5);
    c.evaluate(dt);
    Noise noise(6);
    std::vector<Vector3d> u(c.size());
    double work = 0.0, all = 0.0;
    for (int i = 0; i < c.size(); i++) {
      u[i] = noise.vector(c.dim);
      work += u[i].dot(c.f(i));
      all += std::fabs(u[i].dot(c.f(i)));
    }
    EXPECT_LT(std::fabs(work + sum(c.heat(u))), 1e-13 * all);
  }
}

TEST_P(Lagrangian, HeatIsGalileanInvariant)
{
  Cloud c = cloud(7);
  c.evaluate();
  const std::vector<double> at_rest = c.heat(c.v);
  std::vector<Vector3d> u = c.v;
  for (Vector3d &one : u) one += Vector3d(1.0, -2.0, c.dim == 3 ? 0.5 : 0.0);
  const std::vector<double> passing = c.heat(u);
  double scale = 0.0;
  for (double q : at_rest) scale = std::max(scale, std::fabs(q));
  for (int i = 0; i < c.size(); i++) EXPECT_NEAR(passing[i], at_rest[i], 1e-12 * scale);
}

TEST_P(Lagrangian, Virial)
{
  Cloud c = cloud(8);
  c.evaluate();
  double six[6] = {};
  c.sweeps->virial(c.particles(), c.neighbors(), six);
  Matrix3d exact = Matrix3d::Zero(), found;
  for (int i = 0; i < c.size(); i++) exact += c.x[i] * c.f(i).transpose();
  found << six[0], six[3], six[4], six[3], six[1], six[5], six[4], six[5], six[2];
  const Matrix3d difference = (found - exact).triangularView<Eigen::Upper>();
  EXPECT_LT(difference.norm(), 1e-13 * absolute_torque(c));
}

// a body that somebody has turned: the same forces, turned; the same density

TEST_P(Lagrangian, TurnedBody)
{
  for (double dt : {0.0, 0.1}) {
    Cloud a = cloud(9);
    const Eigen::AngleAxisd turn(2.0,
                                 a.dim == 2 ? Vector3d(0, 0, 1) : Vector3d(1, 2, -1).normalized());
    const Matrix3d Q = turn.toRotationMatrix();
    Cloud b = cloud(9);
    for (int i = 0; i < b.size(); i++) {
      b.x[i] = Q * a.x[i] + Vector3d(3, 4, a.dim == 3 ? 5 : 0);
      b.v[i] = Q * a.v[i];
      const std::array<double, 6> &s = a.S[i];
      const Matrix3d S =
          Q * rows(s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2]) * Q.transpose();
      b.S[i] = {S(0, 0), S(1, 1), S(2, 2), S(0, 1), S(0, 2), S(1, 2)};
    }
    a.evaluate(dt);
    b.evaluate(dt);
    std::vector<Vector3d> expected;
    for (const Vector3d &f : forces(a)) expected.push_back(Q * f);
    EXPECT_LT(largest_difference(forces(b), expected), 1e-12 * largest(expected));
    for (int i = 0; i < a.size(); i++) EXPECT_NEAR(b.rho[i], a.rho[i], 1e-13);
  }
}

TEST_P(Lagrangian, ThreadsChangeNothing)
{
  Cloud a = cloud(10), b = cloud(10);
  b.nthreads = 3;
  a.evaluate(0.1);
  b.evaluate(0.1);
  const std::vector<double> heat_a = a.heat(a.v), heat_b = b.heat(b.v);
  for (int i = 0; i < a.size(); i++) {
    for (int k = 0; k < 3; k++) EXPECT_EQ(a.f(i)[k], b.f(i)[k]);
    EXPECT_EQ(a.rho[i], b.rho[i]);
    EXPECT_EQ(a.S[i], b.S[i]);
    EXPECT_EQ(heat_a[i], heat_b[i]);
  }
}

// a body that is periodic along x is the middle one of three, as far as the
// ends of the three are too far away to matter

TEST_P(Lagrangian, PeriodicBody)
{
  auto [dim, viscosity, hourglass] = GetParam();
  Cloud one(dim);
  one.opt.frame = Frame::LAGRANGIAN;
  one.opt.viscosity = viscosity;
  one.opt.hourglass = hourglass ? 0.1 : 0.0;
  one.opt.h = 1.2;
  one.period = 8.0;
  one.add_lattice(8, 4, 3);
  Noise noise(11);
  for (Vector3d &x : one.x) x += 0.2 * noise.vector(dim);
  one.refer();
  one.stir(noise, 0.1);

  Cloud three(dim);
  three.opt = one.opt;
  for (int copy : {0, 1, 2})
    for (int i = 0; i < one.size(); i++) {
      const Vector3d shift((copy - 1) * one.period, 0, 0);
      three.add(one.x[i] + shift, one.v[i]);
      three.rho.back() = one.rho[i];
      three.e.back() = one.e[i];
      three.S.back() = one.S[i];
      three.xref.push_back(one.xref[i] + shift);
      three.vref.push_back(one.vref[i]);
    }
  one.evaluate(0.1);
  three.evaluate(0.1);
  const std::vector<double> heat_one = one.heat(one.v), heat_three = three.heat(three.v);
  double worst = 0.0;
  const int n = one.size();
  for (int i = 0; i < n; i++) {
    EXPECT_EQ(one.sweeps->neighbor_count(i), three.sweeps->neighbor_count(n + i));
    worst = std::max(worst, (one.f(i) - three.f(n + i)).norm());
    EXPECT_NEAR(one.rho[i], three.rho[n + i], 1e-13);
    EXPECT_NEAR(heat_one[i], heat_three[n + i], 1e-13);
  }
  EXPECT_LT(worst, 1e-13);    // forces are of order 0.1
  EXPECT_LT(net_force(one), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Options, Lagrangian,
                         testing::Combine(testing::Values(2, 3), testing::ValuesIn(VISCOSITIES),
                                          testing::Bool()),
                         name);
INSTANTIATE_TEST_SUITE_P(Options, LagrangianCentral,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(Viscosity::NONE, Viscosity::MONAGHAN,
                                                          Viscosity::LIMITED, Viscosity::BALSARA,
                                                          Viscosity::FRONT),
                                          testing::Bool()),
                         name);

/* ----------------------------------------------------------------------
   viscosity
------------------------------------------------------------------------- */

// every pair dissipates: so half of the heat of all its pairs is positive for
// each particle, and no particle is cooled

TEST(LimitedViscosity, HeatsEveryParticle)
{
  for (int dim : {2, 3}) {
    Cloud c = shaken(dim, 1);
    c.evaluate();
    const std::vector<double> without = c.heat(c.v);
    c.opt.viscosity = Viscosity::LIMITED;
    c.evaluate();
    const std::vector<double> with = c.heat(c.v);
    c.opt.viscosity = Viscosity::MONAGHAN;
    c.evaluate();
    const std::vector<double> standard = c.heat(c.v);
    for (int i = 0; i < c.size(); i++) EXPECT_GE(with[i] - without[i], -1e-16);
    const double limited = sum(with) - sum(without), all = sum(standard) - sum(without);
    EXPECT_GT(limited, 0.0);
    EXPECT_LT(limited, all);
  }
}

// by hand: 4 l_i l_j/(l_i + l_j)^2

TEST(LimitedViscosity, VanLeersLimiter)
{
  EXPECT_DOUBLE_EQ(van_leer(1.0, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(van_leer(-2.0, -2.0), 1.0);
  EXPECT_DOUBLE_EQ(van_leer(1.0, 3.0), 0.75);
  EXPECT_DOUBLE_EQ(van_leer(3.0, 1.0), 0.75);
  EXPECT_DOUBLE_EQ(van_leer(-1.0, -9.0), 0.36);
  EXPECT_EQ(van_leer(1.0, -1.0), 0.0);
  EXPECT_EQ(van_leer(-5.0, 2.0), 0.0);
  EXPECT_EQ(van_leer(0.0, 4.0), 0.0);
  EXPECT_EQ(van_leer(0.0, 0.0), 0.0);
}

TEST(LimitedViscosity, JumpThatIsLeft)
{
  EXPECT_EQ(limited_jump(-4.0, -4.0, -4.0), 0.0);            // linear
  EXPECT_DOUBLE_EQ(limited_jump(-4.0, -1.0, -3.0), -2.5);    // -4 + 0.75 * 2
  EXPECT_DOUBLE_EQ(limited_jump(-4.0, -0.5, -4.5), -3.1);    // -4 + 0.36 * 2.5
  EXPECT_EQ(limited_jump(-4.0, -8.0, -8.0), 0.0);            // would change its sign
  EXPECT_EQ(limited_jump(-4.0, 2.0, 2.0), -4.0);             // would grow
  EXPECT_EQ(limited_jump(-4.0, 3.0, -3.0), -4.0);            // no common slope
  EXPECT_EQ(limited_jump(-4.0, 0.0, 0.0), -4.0);             // a shock
  EXPECT_DOUBLE_EQ(limited_jump(4.0, 1.0, 3.0), 2.5);
  EXPECT_EQ(limited_jump(0.0, 1.0, 3.0), 0.0);
}

TEST(LimitedViscosity, JumpIsBetweenZeroAndTheWholeOne)
{
  Noise noise(1);
  for (int k = 0; k < 10000; k++) {
    const double vr = noise(), left = limited_jump(vr, noise(), noise());
    EXPECT_GE(left * vr, 0.0);
    EXPECT_LE(std::fabs(left), std::fabs(vr));
  }
}

// the filter of the acceleration correction: nothing is left of a constant

TEST(LagrangianCorrection, VanishesForAConstant)
{
  for (int dim : {2, 3}) {
    Cloud c = shaken(dim, 2);
    c.opt.viscosity = Viscosity::CORRECT;
    c.evaluate();
    const std::vector<Vector3d> before = forces(c);
    for (int i = 0; i < c.size(); i++)
      for (int a = 0; a < dim; a++) c.sweeps->viscous_acceleration(i)[a] = 7.0 + a;
    c.sweeps->correction(c.particles(), c.neighbors());
    EXPECT_EQ(largest_difference(forces(c), before), 0.0);
  }
}

// and of a chess board, on a lattice with hbar = 1.5: neighbors along the axes
// have Wbar(4/3) ~ (2/3)^3 and differ, those on the diagonals Wbar(4 sqrt(2)/3) ~
// (2 - 4 sqrt(2)/3)^3 and do not.  Positions do not count, those in the reference do

TEST(LagrangianCorrection, LeavesAChessBoard)
{
  Cloud c(2);
  c.opt.frame = Frame::LAGRANGIAN;
  c.opt.viscosity = Viscosity::CORRECT;
  c.add_lattice(9, 9);
  c.refer();
  deform(c, large(2));
  c.evaluate();
  const std::vector<Vector3d> before = forces(c);
  for (int i = 0; i < c.size(); i++) {
    c.sweeps->viscous_acceleration(i)[0] = i % 2 ? -1.0 : 1.0;    // 9 to a row
    c.sweeps->viscous_acceleration(i)[1] = 0.0;
  }
  c.sweeps->correction(c.particles(), c.neighbors());
  const double axis = std::pow(2.0 / 3.0, 3),
               diagonal = std::pow(2.0 - 4.0 / 3.0 * std::sqrt(2.0), 3);
  EXPECT_NEAR(c.f(40)[0] - before[40][0], axis / (axis + diagonal), 1e-14);
  EXPECT_NEAR(c.f(41)[0] - before[41][0], -axis / (axis + diagonal), 1e-14);
}

// the ledger: heat that is left and heat given back are the standard heating

TEST(LagrangianLedger, AddsUp)
{
  for (int dim : {2, 3}) {
    Cloud c = shaken(dim, 3);
    c.evaluate();
    const double inviscid = sum(c.heat(c.v));
    c.opt.viscosity = Viscosity::MONAGHAN;
    c.evaluate();
    const double standard = sum(c.heat(c.v)) - inviscid;
    c.opt.viscosity = Viscosity::CORRECT;
    c.evaluate();
    const double left = sum(c.heat(c.v, true)) - inviscid;
    EXPECT_NEAR(c.sweeps->ledger.viscous_heat / left, 1.0, 1e-11);
    EXPECT_NEAR(c.sweeps->ledger.returned / (standard - left), 1.0, 1e-11);
    EXPECT_EQ(c.sweeps->ledger.hourglass, 0.0);
  }
}

TEST(LagrangianLedger, HoldsTheHourglassHeat)
{
  for (int dim : {2, 3}) {
    Cloud c = shaken(dim, 4);
    c.evaluate();
    const double without = power(c);
    c.opt.hourglass = 0.1;
    c.evaluate();
    c.heat(c.v, true);
    EXPECT_GT(c.sweeps->ledger.hourglass, 0.0);
    EXPECT_NEAR(c.sweeps->ledger.hourglass / (without - power(c)), 1.0, 1e-11);
    EXPECT_EQ(c.sweeps->ledger.viscous_heat, 0.0);
  }
}

/* ----------------------------------------------------------------------
   bodies of one and two particles have no gradients of their own
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
      EXPECT_EQ(c.sweeps->find_overload(c.neighbors()).kind, Overload::NONE);
    }
}

TEST(FewParticles, Two)
{
  for (int dim : {2, 3})
    for (Viscosity viscosity : VISCOSITIES)
      for (double distance : {1.0, 2.0}) {    // 2.0: no nearest neighbor for the correction
        Cloud c(dim);
        c.opt.frame = Frame::LAGRANGIAN;
        c.opt.viscosity = viscosity;
        c.add(Vector3d(0, 0, 0), Vector3d(0.1, 0, 0));
        c.add(Vector3d(distance, 0, 0), Vector3d(-0.1, 0, 0));
        EXPECT_EQ(c.evaluate(0.1), -1);
        EXPECT_TRUE(std::isfinite(c.f(0).norm()));
        EXPECT_LT(c.f(0)[0], 0.0);    // they approach each other
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
    Cloud c(2);
    c.opt.frame = Frame::LAGRANGIAN;
    c.opt.viscosity = k ? Viscosity::CORRECT : Viscosity::MONAGHAN;
    c.add(Vector3d(0, 0, 0), Vector3d(0.1, 0, 0));
    c.add(Vector3d(2.0, 0, 0), Vector3d(-0.1, 0, 0));
    c.evaluate();
    force[k] = c.f(0)[0];
  }
  EXPECT_LT(force[0], -1e-6);
  EXPECT_DOUBLE_EQ(force[0], force[1]);
}

/* ----------------------------------------------------------------------
   where the frame ends, and the time step before
------------------------------------------------------------------------- */

TEST(Overload, NoneForLargeDeformation)
{
  for (int dim : {2, 3}) {
    Cloud c = body(dim);
    deform(c, large(dim));
    c.evaluate();
    EXPECT_EQ(c.sweeps->find_overload(c.neighbors()).kind, Overload::NONE);
  }
}

TEST(Overload, SqueezedFlat)
{
  for (int dim : {2, 3}) {
    Cloud c = body(dim);
    const Matrix3d turn = Eigen::AngleAxisd(0.5, Vector3d(0, 0, 1)).toRotationMatrix();
    deform(c, turn * Vector3d(0.005, 2.0, 1.0).asDiagonal() * turn);
    c.evaluate();
    const Overload end = c.sweeps->find_overload(c.neighbors());
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
  const Overload end = c.sweeps->find_overload(c.neighbors());
  EXPECT_EQ(end.kind, Overload::OVERLAP);
  EXPECT_EQ(end.particle, i);
  EXPECT_NEAR(end.value, 0.004, 1e-12);
}

// h over the longitudinal wave speed, less by the least principal stretch

TEST(TimeStep, ShrinksWithTheLeastStretch)
{
  for (int dim : {2, 3})
    for (double stretch : {3.0, 1.0, 0.8, 0.4, 0.1}) {
      Cloud c = body(dim);
      const Matrix3d turn = Eigen::AngleAxisd(0.5, Vector3d(0, 0, 1)).toRotationMatrix();
      deform(c, turn * Vector3d(stretch, 1.5, 1.2).asDiagonal() * turn);
      c.evaluate();
      const double c_l = std::sqrt(1.0 + 4.0 / 3.0 * 0.786);
      EXPECT_NEAR(c.sweeps->time_step_limit(c.particles(), c.neighbors()),
                  1.3 * std::min(1.0, stretch) / c_l, 1e-12);
    }
}
