/* ----------------------------------------------------------------------
   Conservation laws of the Lagrangian frame, for every viscosity, with and without
   hourglass damping; and that nothing depends on how a body is turned, cut into a
   periodic piece or shared out among threads.
------------------------------------------------------------------------- */

#include "lagrangian_body.h"

#include <gtest/gtest.h>

#include <tuple>

using namespace SPHSolid;

namespace {

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
  EXPECT_LT(net_torque(c), 1e-13);
}

TEST_P(LagrangianCentral, AngularMomentumAfterStep)
{
  Cloud c = cloud(4);
  c.evaluate(0.1);
  EXPECT_LT(net_torque(c), 1e-13);
}

// what any displacement takes from the forces is heat

TEST_P(Lagrangian, HeatOfAnyDisplacement)
{
  for (double dt : {0.0, 0.1}) {
    Cloud c = cloud(5);
    c.evaluate(dt);
    EXPECT_LT(energy_error(c, random_displacement(c, 6)), 1e-13);
  }
}

TEST_P(Lagrangian, HeatIsGalileanInvariant)
{
  Cloud c = cloud(7);
  c.evaluate();
  EXPECT_LT(galilean_error(c), 1e-12);
}

// viscosity and hourglass damping: where displacements differ from those of the velocities that the forces
// come from, each particle has the work of its own force

TEST_P(Lagrangian, ChangeOfVelocityIsWorkOfTheOwnForce)
{
  Cloud with = cloud(14), without = cloud(14);
  without.opt.viscosity = Viscosity::NONE;
  without.opt.hourglass = 0.0;
  with.evaluate();
  without.evaluate();
  const std::vector<Vector3d> u = random_displacement(with, 6);
  const std::vector<double> heat = with.heat(u), heat_of_v = with.heat(with.v),
                            stress = without.heat(u), stress_of_v = without.heat(without.v);
  double worst = 0.0, most = 0.0;
  for (int i = 0; i < with.size(); i++) {
    const double change = (heat[i] - heat_of_v[i]) - (stress[i] - stress_of_v[i]),
                 work = -(with.f(i) - without.f(i)).dot(u[i] - with.v[i]);
    worst = std::max(worst, std::fabs(change - work));
    most = std::max(most, std::fabs(work));
  }
  const bool dissipates = with.opt.viscosity != Viscosity::NONE || with.opt.hourglass > 0.0;
  EXPECT_EQ(most > 0.0, dissipates);
  EXPECT_LE(worst, 1e-12 * most);
}

TEST_P(Lagrangian, Virial)
{
  Cloud c = cloud(8);
  c.evaluate();
  EXPECT_LT(virial_error(c), 1e-13);
}

// who does not ask for a virial has the same forces and heat, and pays no memory for it

TEST_P(Lagrangian, NothingIsKeptForAVirialThatNobodyAsksFor)
{
  Cloud with = cloud(8), without = cloud(8);
  without.wants_virial = false;
  with.evaluate();
  without.evaluate();
  EXPECT_EQ(forces(with), forces(without));
  EXPECT_EQ(with.heat(with.v), without.heat(without.v));
  const double more = with.sweeps->memory_usage() - without.sweeps->memory_usage();
  const Viscosity viscosity = with.opt.viscosity;
  if (with.opt.hourglass > 0.0 ||
      !(viscosity == Viscosity::NONE || viscosity == Viscosity::CORRECT))
    EXPECT_GE(more, with.size() * 3 * sizeof(double));
  else
    EXPECT_EQ(more, 0.0);
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
      b.S[i] = components(Q * symmetric(a.S[i].data()) * Q.transpose());
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

// half cells on the faces of a block, and an eighth of one on its corners in three dimensions: with
// partners on one side only and small moments they need their gradient correction no less

TEST(LagrangianCorners, OfHalfCellsHaveNoTorque)
{
  for (int dim : {2, 3})
    for (double h : {0.8, 1.0, 1.3}) {
      const int n = 5;
      Cloud c = lattice(dim, n);
      c.opt.frame = Frame::LAGRANGIAN;
      c.opt.viscosity = Viscosity::MONAGHAN;
      c.opt.h = h;
      for (int i = 0; i < c.size(); i++)
        for (int a = 0; a < dim; a++)
          if (c.x[i][a] == 0.0 || c.x[i][a] == n - 1.0) c.volume[i] *= 0.5;
      c.mass = c.volume;
      c.refer();
      deform(c, large(dim));
      Noise noise(31);
      c.stir(noise, 0.05, 0.0);
      c.evaluate();
      EXPECT_EQ(c.sweeps->uncorrected(), 0);
      EXPECT_LT(net_torque(c), 1e-13);
    }
}

// in a row nothing can be known of what is across it

TEST(LagrangianCorners, RowsAreNotCorrected)
{
  for (int dim : {2, 3}) {
    Cloud c(dim);
    c.opt.frame = Frame::LAGRANGIAN;
    c.add_lattice(7, 1);
    c.add(Vector3d(100.0, 0.0, 0.0),
          Vector3d::Zero());    // without partners: there is nothing to correct
    c.evaluate();
    EXPECT_EQ(c.sweeps->uncorrected(), 7);
  }
}

// stretched, its F is 1 + sum V0 (u_j - u_i) (x) g, which is not that of the stretch: the sum is not corrected

TEST(LagrangianCorners, RowsThatAreStretchedPullByTheirDefinition)
{
  constexpr double STRETCH = 0.1, SIGMA = 0.3;
  for (int dim : {2, 3}) {
    Cloud c(dim);
    c.opt.frame = Frame::LAGRANGIAN;
    c.add_lattice(7, 1);
    c.refer();
    for (int i = 0; i < 7; i++) {
      c.x[i] *= 1.0 + STRETCH;
      c.S[i] = {SIGMA, -0.1, -0.2, 0.0, 0.0, 0.0};
    }
    EXPECT_EQ(c.evaluate(), -1);
    // X_ij g_ij of particles one and two spacings away; what is further is no partner
    auto along = [&](int i, int j) {
      const double r = std::fabs(i - j);
      if (i == j || r > 2.0) return 0.0;
      return r * r *
          (dim == 2 ? CubicSpline<2>::gradient_factor(r, c.opt.h)
                    : CubicSpline<3>::gradient_factor(r, c.opt.h));
    };
    auto F = [&](int i) {
      double sum = 1.0;
      for (int j = 0; j < 7; j++) sum -= STRETCH * along(i, j);
      return sum;
    };
    for (int i = 0; i < 7; i++) {
      double f = 0.0;
      for (int j = 0; j < 7; j++)
        if (j != i) f += SIGMA * (1.0 / F(i) + 1.0 / F(j)) * along(i, j) / (i - j);
      EXPECT_NEAR(c.f(i)[0], f, 2.0 * SINGLE) << dim << "D, " << i;
    }
  }
}

// heating printed (SR 30) makes one standard heating too much, whatever the weights sum to, as long as
// m_i w_ij is symmetric: the derivation in test_conservation.cpp has no frame

TEST(LagrangianHeating, PrintedIsOneStandardTooMuch)
{
  for (int dim : {2, 3}) {
    Cloud c = shaken(dim, 12);
    c.opt.viscosity = Viscosity::NONE;
    c.evaluate();
    const double without = power(c);
    c.opt.viscosity = Viscosity::MONAGHAN;
    c.evaluate();
    const double standard = without - power(c);
    ASSERT_GT(standard, 0.0);
    c.opt.viscosity = Viscosity::CORRECT;
    c.opt.heating = Heating::PRINTED;
    c.evaluate();
    const double surplus = power(c) + sum(c.heat(c.v));
    EXPECT_NEAR(surplus / standard, 1.0, 1e-11);
  }
}

// heat can be found on the way only where it is the work of pair forces, half of it for either particle:
// not for weights shepard or safe, nor for the printed heating, and there has to be an energy equation

TEST(LagrangianHeating, IsKeptOnTheWayOfEvenPairsOnly)
{
  Cloud c = shaken(2, 13);
  auto keeps = [&c](Viscosity viscosity) {
    c.opt.viscosity = viscosity;
    c.evaluate();
    return c.sweeps->can_keep_heat();
  };
  for (Viscosity viscosity : VISCOSITIES) EXPECT_TRUE(keeps(viscosity)) << name_of(viscosity);
  c.opt.weights = Weights::SHEPARD;
  for (Viscosity viscosity : VISCOSITIES)    // weights are those of the correction
    EXPECT_EQ(keeps(viscosity), viscosity != Viscosity::CORRECT) << name_of(viscosity);
  c.opt.weights = Weights::SAFE;
  EXPECT_FALSE(keeps(Viscosity::CORRECT));
  c.opt.weights = Weights::CONSERVATIVE;
  c.opt.heating = Heating::PRINTED;
  EXPECT_FALSE(keeps(Viscosity::CORRECT));
  c.opt.heating = Heating::COMPATIBLE;
  EXPECT_TRUE(keeps(Viscosity::CORRECT));
  c.opt.energy = false;
  EXPECT_FALSE(keeps(Viscosity::MONAGHAN));
  c.opt.energy = true;
  c.opt.frame = Frame::EULERIAN;
  EXPECT_FALSE(keeps(Viscosity::MONAGHAN));
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
