/* ----------------------------------------------------------------------
   The cubic spline kernel: a unit volume, a gradient that belongs to it,
   and what its sums on lattices do to the speed of waves.
------------------------------------------------------------------------- */

#include "sph_solid_kernel.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SPHSolid;

namespace {

constexpr double PI = 3.14159265358979323846;

// integral of f over [a,b] by the 5-point Gauss-Legendre rule, exact for
// polynomials up to degree 9: the spline times r^2 has degree 5

template <class F> double gauss(F f, double a, double b)
{
  const double node[5] = {0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                          -0.9061798459386640};
  const double weight[5] = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                            0.2369268850561891, 0.2369268850561891};
  double sum = 0.0;
  for (int k = 0; k < 5; k++) sum += weight[k] * f(0.5 * (a + b) + 0.5 * (b - a) * node[k]);
  return 0.5 * (b - a) * sum;
}

struct LatticeSum {
  double gradient;    // d/dx of the field x
  int neighbors;
};

// gradient of a linear field on a lattice of spacing one, cell volume one

template <int D> LatticeSum lattice_sum(double h)
{
  LatticeSum out = {0.0, 0};
  const int n = 5, nz = D == 3 ? n : 0;
  for (int i = -n; i <= n; i++)
    for (int j = -n; j <= n; j++)
      for (int k = -nz; k <= nz; k++) {
        if (i == 0 && j == 0 && k == 0) continue;
        const double r = std::sqrt(double(i * i + j * j + k * k));
        const double F = CubicSpline<D>::gradient_factor(r, h);
        if (F != 0.0) out.neighbors++;
        out.gradient -= F * i * i;
      }
  return out;
}

}    // namespace

// a kernel has the volume one

TEST(Kernel, NormTwoDimensions)
{
  for (double h : {0.37, 1.0, 2.6}) {
    auto ring = [h](double r) {
      return 2.0 * PI * r * CubicSpline<2>::w(r, h);
    };
    EXPECT_NEAR(gauss(ring, 0.0, h) + gauss(ring, h, 2.0 * h), 1.0, 1e-14);
  }
}

TEST(Kernel, NormThreeDimensions)
{
  for (double h : {0.37, 1.0, 2.6}) {
    auto shell = [h](double r) {
      return 4.0 * PI * r * r * CubicSpline<3>::w(r, h);
    };
    EXPECT_NEAR(gauss(shell, 0.0, h) + gauss(shell, h, 2.0 * h), 1.0, 1e-14);
  }
}

// alpha_D of Shaw & Reid, Curr. Sci. 97 (2009), eq. 22, with W = alpha_D at r = 0

TEST(Kernel, ValueAtOrigin)
{
  EXPECT_DOUBLE_EQ(CubicSpline<2>::w(0.0, 1.3), 10.0 / (7.0 * PI * 1.3 * 1.3));
  EXPECT_DOUBLE_EQ(CubicSpline<3>::w(0.0, 1.3), 1.0 / (PI * 1.3 * 1.3 * 1.3));
}

// both branches of eq. 22 at their middle: 1 - 3/2 q^2 + 3/4 q^3 = 23/32 at
// q = 1/2 and (2-q)^3/4 = 1/32 at q = 3/2

TEST(Kernel, ValueInBothBranches)
{
  const double h = 0.8, alpha = 10.0 / (7.0 * PI * h * h);
  EXPECT_NEAR(CubicSpline<2>::w(0.5 * h, h), alpha * 23.0 / 32.0, 1e-15 * alpha);
  EXPECT_NEAR(CubicSpline<2>::w(1.5 * h, h), alpha / 32.0, 1e-15 * alpha);
}

// central difference of fourth order; its error at this step is 1e-11

template <int D> void gradient_is_derivative()
{
  const double h = 1.3, d = 1e-3 * h;
  for (double q : {0.1, 0.4, 0.8, 0.99, 1.01, 1.2, 1.6, 1.9}) {
    auto w = [h, q, d](double step) {
      return CubicSpline<D>::w(q * h + step * d, h);
    };
    const double slope = (8.0 * (w(1) - w(-1)) - (w(2) - w(-2))) / (12.0 * d);
    EXPECT_NEAR(CubicSpline<D>::gradient_factor(q * h, h) * q * h, slope, 1e-11) << "q = " << q;
  }
}

TEST(Kernel, GradientIsDerivativeTwoDimensions)
{
  gradient_is_derivative<2>();
}
TEST(Kernel, GradientIsDerivativeThreeDimensions)
{
  gradient_is_derivative<3>();
}

// (dW/dr)/r has the limit -3 alpha/h^2 at r = 0, finite for coinciding particles

TEST(Kernel, GradientFactorAtOrigin)
{
  const double h = 1.3;
  EXPECT_DOUBLE_EQ(CubicSpline<2>::gradient_factor(0.0, h), -30.0 / (7.0 * PI * h * h * h * h));
  EXPECT_DOUBLE_EQ(CubicSpline<3>::gradient_factor(0.0, h), -3.0 / (PI * h * h * h * h * h));
}

TEST(Kernel, ZeroOutsideSupport)
{
  for (double q : {2.0, 2.0 + 1e-12, 2.5, 100.0}) {
    EXPECT_EQ(CubicSpline<2>::w(q * 1.3, 1.3), 0.0);
    EXPECT_EQ(CubicSpline<3>::w(q * 1.3, 1.3), 0.0);
    EXPECT_EQ(CubicSpline<2>::gradient_factor(q * 1.3, 1.3), 0.0);
    EXPECT_EQ(CubicSpline<3>::gradient_factor(q * 1.3, 1.3), 0.0);
  }
}

TEST(Kernel, PositiveAndAttractiveInsideSupport)
{
  for (double q = 0.01; q < 1.995; q += 0.01) {
    EXPECT_GT(CubicSpline<2>::w(q, 1.0), 0.0) << q;
    EXPECT_LT(CubicSpline<2>::gradient_factor(q, 1.0), 0.0) << q;
  }
}

// a B-spline of third degree has two continuous derivatives: no jump of W, of
// W' or of the slope of W' where the branches meet

TEST(Kernel, BranchesMeetSmoothly)
{
  const double d = 1e-7;
  auto w = [](double q) {
    return CubicSpline<2>::w(q, 1.0);
  };
  auto dw = [](double q) {
    return CubicSpline<2>::gradient_factor(q, 1.0) * q;
  };
  // W = alpha/4, W' = -3/4 alpha, W'' = 3/2 alpha on both sides of q = 1
  const double alpha = 10.0 / (7.0 * PI);
  EXPECT_NEAR(w(1.0 - d), alpha * (0.25 + 0.75 * d), 1e-13);
  EXPECT_NEAR(w(1.0 + d), alpha * (0.25 - 0.75 * d), 1e-13);
  EXPECT_NEAR(dw(1.0 - d), alpha * (-0.75 - 1.5 * d), 1e-13);
  EXPECT_NEAR(dw(1.0 + d), alpha * (-0.75 + 1.5 * d), 1e-13);
}

// what the sum makes of a gradient of one, and so of every wave speed without
// gradient correction.  Own evaluation of eq. 22 with 30 digits; neighbors
// counted by hand as lattice points within 2h

TEST(Kernel, LatticeSumsTwoDimensions)
{
  const double h[4] = {1.2, 1.3, 1.5, 2.0};
  const double gradient[4] = {0.9907930613688714, 1.010542957253394, 1.006724514752872,
                              0.999100206588479};
  const int neighbors[4] = {20, 20, 24, 44};
  for (int k = 0; k < 4; k++) {
    const LatticeSum sum = lattice_sum<2>(h[k]);
    EXPECT_NEAR(sum.gradient, gradient[k], 1e-14) << "h = " << h[k];
    EXPECT_EQ(sum.neighbors, neighbors[k]) << "h = " << h[k];
  }
}

TEST(Kernel, LatticeSumsThreeDimensions)
{
  const double h[4] = {1.2, 1.3, 1.5, 2.0};
  const double gradient[4] = {0.98168856707997, 0.9934836999441075, 1.010122810111531,
                              0.9999506537427412};
  const int neighbors[4] = {56, 80, 92, 250};
  for (int k = 0; k < 4; k++) {
    const LatticeSum sum = lattice_sum<3>(h[k]);
    EXPECT_NEAR(sum.gradient, gradient[k], 1e-14) << "h = " << h[k];
    EXPECT_EQ(sum.neighbors, neighbors[k]) << "h = " << h[k];
  }
}
