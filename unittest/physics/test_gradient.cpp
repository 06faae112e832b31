/* ----------------------------------------------------------------------
   The gradient sweep: linear fields are met exactly, rigid motion leaves the
   material alone, and plastic work is in the ledger.
------------------------------------------------------------------------- */

#include "turned_body.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

// stretch by v = g (n.x) n: positions at the end of the step are known, so at
// its start n.x was n.x (1 - g dt), and rho changes by exactly that factor

TEST(Gradient, UniaxialStretchOfDisorderedBody)
{
  for (int dim : {2, 3}) {
    Cloud c = turned_body(dim);
    const std::vector<double> rho = c.rho;
    const std::vector<int> inside = well_surrounded(c);
    const Vector3d n = Vector3d(0.8, 0.5, dim == 3 ? -0.3 : 0.0).normalized();
    const double g = 0.4, dt = 0.5;
    c.move([&](Vector3d x) -> Vector3d {
      return g * n.dot(x) * n;
    });
    c.advance(dt);
    EXPECT_GT(inside.size(), dim == 2 ? 0.9 * c.size() : 0.7 * c.size());    // bulk and faces
    for (int i : inside) EXPECT_NEAR(c.rho[i] / rho[i], 1.0 - g * dt, 1e-13);
  }
}

// simple shear: det F = 1

TEST(Gradient, ShearOfDisorderedBodyKeepsDensity)
{
  Cloud c = turned_body(2);
  const std::vector<double> rho = c.rho;
  const std::vector<int> inside = well_surrounded(c);
  c.move([](Vector3d x) -> Vector3d {
    return {0.6 * x[1], 0.0, 0.0};
  });
  c.advance(0.5);
  for (int i : inside) EXPECT_NEAR(c.rho[i] / rho[i], 1.0, 1e-13);
}

// a linear field of any kind: Hooke's law for a step from rest, so short that
// turning and stretching within it are less than rounding

TEST(Gradient, AnyLinearFieldInDisorderedBody)
{
  for (int dim : {2, 3}) {
    Cloud c = turned_body(dim);
    for (auto &s : c.S) s = {};
    const std::vector<int> inside = well_surrounded(c);
    const Matrix3d G = any_gradient(dim);
    const double dt = 1e-14;
    c.move([&](Vector3d x) -> Vector3d {
      return G * x;
    });
    c.advance(dt);
    Matrix3d D = 0.5 * (G + G.transpose());
    D -= D.trace() / 3.0 * Matrix3d::Identity();
    const Matrix3d hooke = 2.0 * c.material.shear * dt * D;
    double worst = 0.0;
    for (int i : inside) worst = std::max(worst, (symmetric(c.S[i].data()) - hooke).norm());
    EXPECT_LT(worst, 1e-12 * hooke.norm());
  }
}

// uncorrected on a lattice: the gradient is that of the lattice sums with
// h = 1.3 spacings (own evaluation of the spline with 30 digits)

TEST(Gradient, PlainGradientOnLattice)
{
  for (int dim : {2, 3}) {
    Cloud c = lattice(dim, 7);
    c.opt.corrected = false;
    const double g = 0.4, dt = 0.5, lattice_sum = dim == 2 ? 1.010542957253394 : 0.9934836999441075;
    c.move([&](Vector3d x) -> Vector3d {
      return {g * x[0], 0.0, 0.0};
    });
    c.advance(dt);
    EXPECT_NEAR(c.rho[middle(c)], 1.0 - lattice_sum * g * dt, KERNEL_ERROR * lattice_sum * g * dt);
  }
}

// two particles do not span a plane: no correction.  h = 1 = distance:
// dW/dr = -(3/4) 10/(7 pi), each sees L_xx = 30/(28 pi) dv

TEST(Gradient, TooFewNeighborsAreNotCorrected)
{
  Cloud c(2);
  c.opt.h = 1.0;
  c.add({0, 0, 0}, {0, 0, 0});
  c.add({1, 0, 0}, {0.3, 0, 0});
  c.advance(0.1);
  const double change = 0.1 * 0.3 * 30.0 / (28.0 * M_PI);
  EXPECT_NEAR(c.rho[0], 1.0 - change, SINGLE * change);
  EXPECT_NEAR(c.rho[1], 1.0 - change, SINGLE * change);
}

// all particles of a body turn by 40 degrees in one step: S turns along,
// density stays

TEST(Gradient, RigidRotation)
{
  for (int dim : {2, 3}) {
    Cloud c = turned_body(dim);
    const std::vector<double> rho = c.rho;
    const auto S = c.S;
    const std::vector<int> inside = well_surrounded(c);
    const Vector3d axis = dim == 3 ? Vector3d(1.0, -2.0, 0.5).normalized() : Vector3d(0, 0, 1);
    const Matrix3d Q = Eigen::AngleAxisd(40.0 * M_PI / 180.0, axis).matrix();
    const double dt = 0.1;
    c.move([&](Vector3d x) -> Vector3d {
      return (x - Q.transpose() * x) / dt;
    });
    c.advance(dt);
    for (int i : inside) {
      EXPECT_NEAR(c.rho[i] / rho[i], 1.0, 1e-13);
      const Matrix3d turned = Q * symmetric(S[i].data()) * Q.transpose();
      EXPECT_LT((symmetric(c.S[i].data()) - turned).norm(), 1e-13);
    }
  }
}

// a translation is no change at all, to the last bit

TEST(Gradient, Translation)
{
  for (int dim : {2, 3}) {
    Cloud c = random_cloud(dim);
    const std::vector<double> rho = c.rho;
    const auto S = c.S;
    c.move([&](Vector3d) -> Vector3d {
      return {1.7, -0.3, dim == 3 ? 2.1 : 0.0};
    });
    c.advance(0.1);
    EXPECT_EQ(c.rho, rho);
    EXPECT_EQ(c.S, S);
  }
}

// a step of no time changes nothing

TEST(Gradient, NoTimeNoChange)
{
  Cloud c = random_cloud(2);
  const std::vector<double> rho = c.rho;
  const auto S = c.S;
  c.advance(0.0);
  EXPECT_EQ(c.rho, rho);
  EXPECT_EQ(c.S, S);
}

// uniform pure shear far beyond yield: each unit of volume takes the plastic
// work Y epl, epl = (sqrt(3) mu gamma - Y)/(3 mu)

TEST(Gradient, PlasticWorkInLedger)
{
  Cloud c = turned_body(2);
  for (auto &s : c.S) s = {};
  c.material.strength = Strength::PERFECT;
  c.material.Y = 0.001;
  const std::vector<int> inside = well_surrounded(c);
  const double dt = 1e-4, gamma = 100.0 * dt;    // mu gamma >> Y
  c.move([](Vector3d x) -> Vector3d {
    return {50.0 * x[1], 50.0 * x[0], 0.0};
  });
  c.advance(dt);
  const double mu = c.material.shear;
  // the middle of the step is stretched: D = G (1 - G dt/2)^-1
  const double a = 50.0, twice_ddt = 2.0 * a * dt / (1.0 - 0.25 * a * a * dt * dt);
  const double isotropic = 0.5 * a * a * dt * dt / (1.0 - 0.25 * a * a * dt * dt);
  // D = [isotropic/..., shear]: equivalent strain sqrt(2/3 dev:dev)
  const double tr = 2.0 * isotropic;
  const double dev =
      2.0 * std::pow(isotropic - tr / 3.0, 2) + std::pow(tr / 3.0, 2) + 0.5 * twice_ddt * twice_ddt;
  const double epl = std::sqrt(2.0 / 3.0 * dev) - c.material.Y / (3.0 * mu);
  EXPECT_NEAR(twice_ddt / gamma, 1.0, 1e-4);
  double work = 0.0;
  for (int i : inside) {
    EXPECT_NEAR(c.epl[i] / epl, 1.0, 1e-11);
    work += c.material.Y * epl * c.mass[i] / c.rho[i];
  }
  for (int i = 0; i < c.size(); i++)
    if (std::find(inside.begin(), inside.end(), i) == inside.end())
      work += c.material.Y * c.epl[i] * c.mass[i] / c.rho[i];
  EXPECT_NEAR(c.sweeps->ledger.plastic_work / work, 1.0, 1e-11);
}
