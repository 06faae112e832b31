/* ----------------------------------------------------------------------
   The force sweep: divergence and power of stresses that are linear in space,
   artificial stress, and the standard viscosity of a pair by hand.
------------------------------------------------------------------------- */

#include "turned_body.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

// rho a = div sigma: pressure falls along x (through the energy, P = Gamma rho e),
// shear stress grows along y.  Exact for a linear field in the bulk

TEST(Force, DivergenceOfLinearStress)
{
  for (int dim : {2, 3}) {
    Cloud c = lattice(dim, 9);
    c.opt.viscosity = Viscosity::NONE;
    for (int i = 0; i < c.size(); i++) {
      c.e[i] = 0.01 * c.x[i][0];
      c.S[i][3] = 0.03 * c.x[i][1];
    }
    c.evaluate();
    EXPECT_NEAR(c.f(middle(c))[0], -1.8 * 0.01 + 0.03, 1e-15);
    EXPECT_NEAR(c.f(middle(c))[1], 0.0, 1e-15);
  }
}

// the same without correction is off by the lattice sum of the gradient

TEST(Force, DivergenceOfLinearStressPlain)
{
  for (int dim : {2, 3}) {
    Cloud c = lattice(dim, 9);
    c.opt.viscosity = Viscosity::NONE;
    c.opt.corrected = false;
    for (int i = 0; i < c.size(); i++) c.S[i][3] = 0.03 * c.x[i][1];
    c.evaluate();
    const double lattice_sum = dim == 2 ? 1.010542957253394 : 0.9934836999441075;
    EXPECT_NEAR(c.f(middle(c))[0], 0.03 * lattice_sum, KERNEL_ERROR * 0.03 * lattice_sum);
  }
}

// power of the stress in a linear velocity field: V sigma : grad v, bulk and faces

TEST(Force, StressPowerOfLinearField)
{
  for (int dim : {2, 3}) {
    Cloud c = turned_body(dim);
    c.opt.viscosity = Viscosity::NONE;
    for (int i = 0; i < c.size(); i++) {    // no pressure: sigma = S
      c.volume[i] = c.mass[i] / c.rho[i];
      c.e[i] = 0.0;
    }
    const Matrix3d G = any_gradient(dim);
    c.evaluate();
    std::vector<Vector3d> u;
    for (auto &x : c.x) u.push_back(G * x);
    const std::vector<double> heat = c.heat(u);
    for (int i : well_surrounded(c)) {
      const double exact = c.volume[i] * symmetric(c.S[i].data()).cwiseProduct(G).sum();
      EXPECT_NEAR(heat[i], exact, 1e-14);
    }
  }
}

// artificial stress with eps = 0.3, n = 4 takes this share of every uniaxial
// tension (lattice sums of the spline, own evaluation with 30 digits;
// formula of Gray, Monaghan & Swift 2001)

TEST(Force, TensionLostToArtificialStress)
{
  const double h[4] = {1.2, 1.3, 1.5, 2.0};
  const double lost[2][4] = {
      {0.151174876192017, 0.1232956729346827, 0.08781872336178966, 0.0457346075888995},
      {0.09005602859703442, 0.06938231513979342, 0.04458522494153258, 0.0221879665087753}};
  for (int dim : {2, 3})
    for (bool corrected : {false, true})
      for (int k = 0; k < 4; k++) {
        Cloud c = lattice(dim, 9);
        c.opt.h = h[k];
        c.opt.corrected = corrected;
        c.opt.viscosity = Viscosity::NONE;
        // 2/3, -1/3, -1/3 and a pressure of -1/3: tension along x alone
        for (int i = 0; i < c.size(); i++) {
          c.S[i] = {0.02, -0.01, -0.01, 0.0, 0.0, 0.0};
          c.e[i] = -0.01 / 1.8;
        }
        std::vector<Vector3d> u;
        for (auto &x : c.x) u.push_back({x[0], 0.0, 0.0});
        c.evaluate();
        const double full = c.heat(u)[middle(c)];
        c.opt.tensile = true;
        c.opt.tensile_eps = 0.3;
        c.opt.tensile_n = 4.0;
        c.evaluate();
        const double left = c.heat(u)[middle(c)];
        EXPECT_NEAR(1.0 - left / full, lost[dim - 2][k], SINGLE) << "h = " << h[k];
      }
}

// standard viscosity of two particles by hand: h = 1, r = 1, closing at 0.2:
// mu = -0.2/1.01, Pi = -mu + mu^2 with c = rho = 1 (P = 0 at rest density)

TEST(Force, MonaghanPairByHand)
{
  Cloud c = closing_pair(1.0);
  c.opt.h = 1.0;
  c.opt.viscosity = Viscosity::MONAGHAN;
  c.evaluate();
  const double mu = -0.2 / 1.01, Pi = -mu + mu * mu, slope = -30.0 / (28.0 * M_PI);
  EXPECT_NEAR(c.f(0)[0], Pi * slope, SINGLE * Pi * std::fabs(slope));
  EXPECT_EQ(c.f(0)[1], 0.0);
}

// mass enters the viscous force as a product, the sound speed and density as means

TEST(Force, MonaghanPairOfUnlikeParticles)
{
  Cloud c = closing_pair(1.0);
  c.opt.h = 1.0;
  c.opt.viscosity = Viscosity::MONAGHAN;
  c.opt.a1 = 0.5;
  c.opt.a2 = 2.0;
  // rest density 4: P = 0 and c^2 = K/rho = 1/4
  c.mass[1] = 4.0;
  c.rho[1] = 4.0;
  c.evaluate();
  const double mu = -0.2 / 1.01, slope = -30.0 / (28.0 * M_PI);
  const double Pi = (-0.5 * 0.75 * mu + 2.0 * mu * mu) / 2.5;
  const double error = SINGLE * 4.0 * Pi * std::fabs(slope);
  EXPECT_NEAR(c.f(0)[0], 4.0 * Pi * slope, error);
  EXPECT_NEAR(c.f(1)[0], -4.0 * Pi * slope, error);
  EXPECT_NEAR(c.f(0)[0] + c.f(1)[0], 0.0, 1e-16);
}
