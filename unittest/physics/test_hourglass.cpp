/* ----------------------------------------------------------------------
   Strength of the hourglass damping in the Lagrangian frame, against its formula on the theory page,
   written out here with a kernel of its own: nothing of it comes from the sweeps.

   Unit factors would hide a power of h, of the density or of the speed of sound: here none of these is 1.
------------------------------------------------------------------------- */

#include "lagrangian_body.h"
#include "spline_by_hand.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

using namespace SPHSolid;

namespace {

constexpr double RHO0 = 7.85, K = 3.1, SHEAR = 1.7, H = 0.9, C_HOURGLASS = 0.3;
// of the other material
constexpr double DENSER = 4.0, OTHER_K = 20.0, OTHER_SHEAR = 9.0, OTHER_H = 1.1;

Cloud empty_cloud(int dim)
{
  Cloud c(dim);
  c.opt.frame = Frame::LAGRANGIAN;
  c.opt.viscosity = Viscosity::NONE;
  c.opt.h = H;
  c.spacing = 0.7;
  c.material.rho0 = RHO0;
  c.material.eos = EOS::LINEAR;    // c^2 = K/rho_ref, whatever the density is
  c.material.K = K;
  c.material.shear = SHEAR;
  return c;
}

void make_another_material(Cloud &c, const std::vector<int> &which)
{
  c.make_others(which, DENSER, 1.0);
  c.other_material->K = OTHER_K;
  c.other_material->shear = OTHER_SHEAR;
  c.other_h = OTHER_H;
}

bool is_other(const Cloud &c, int i)
{
  return std::count(c.others.begin(), c.others.end(), i) > 0;
}

double h_of(const Cloud &c, int i)
{
  return is_other(c, i) ? OTHER_H : H;
}

// partners end at q = 1.98

double psi(int dim, double r, double h)
{
  return r / h < 1.98 ? psi_by_hand(dim, r, h) : 0.0;
}

double psi(const Cloud &c, int i, int j)
{
  return psi(c.dim, (c.xref[i] - c.xref[j]).norm(), 0.5 * (h_of(c, i) + h_of(c, j)));
}

// rho c_L h with c_L^2 = K/rho_ref + 4/3 mu/rho, and its mean over a pair

double impedance(const Cloud &c, int i)
{
  const double rho = c.rho[i], rho_ref = c.mass[i] / c.volume[i];
  const bool other = is_other(c, i);
  const double bulk = other ? OTHER_K : K, shear = other ? OTHER_SHEAR : SHEAR;
  return rho * std::sqrt(bulk / rho_ref + 4.0 / 3.0 * shear / rho) * h_of(c, i);
}

double mean_impedance(const Cloud &c, int i, int j)
{
  const double a = impedance(c, i), b = impedance(c, j);
  return c.others.empty() ? 0.5 * (a + b) : 2.0 * a * b / (a + b);
}

// D = sym(F' F^-1)

Matrix3d rate_of_deformation(const Cloud &c, int i)
{
  Matrix3d M = Matrix3d::Zero(), F = Matrix3d::Zero(), rate = Matrix3d::Zero();
  for (int j = 0; j < c.size(); j++) {
    if (j == i) continue;
    const Vector3d X = c.xref[i] - c.xref[j];
    const Vector3d g = -c.vref[j] * psi(c, i, j) * X;
    M -= X * g.transpose();
    F -= (c.x[i] - c.x[j] - X) * g.transpose();
    rate -= (c.v[i] - c.v[j]) * g.transpose();
  }
  if (c.dim == 2) M(2, 2) = 1.0;
  const Matrix3d B = M.inverse(), L = rate * B * (Matrix3d::Identity() + F * B).inverse();
  return 0.5 * (L + L.transpose());
}

std::vector<Vector3d> expected_damping(const Cloud &c)
{
  std::vector<Matrix3d> D;
  for (int i = 0; i < c.size(); i++) D.push_back(rate_of_deformation(c, i));
  std::vector<Vector3d> f(c.size(), Vector3d::Zero());
  for (int i = 0; i < c.size(); i++)
    for (int j = 0; j < c.size(); j++) {
      if (j == i) continue;
      const Vector3d x = c.x[i] - c.x[j];
      const double nu = (c.v[i] - c.v[j]).dot(x) - 0.5 * x.dot((D[i] + D[j]) * x);
      f[i] -= C_HOURGLASS * c.vref[i] * c.vref[j] * psi(c, i, j) * mean_impedance(c, i, j) * nu /
          x.squaredNorm() * x;
    }
  return f;
}

std::vector<Vector3d> damping(Cloud &c)
{
  c.opt.hourglass = 0.0;
  EXPECT_EQ(c.evaluate(), -1);
  std::vector<Vector3d> f = forces(c);
  c.opt.hourglass = C_HOURGLASS;
  c.evaluate();
  for (int i = 0; i < c.size(); i++) f[i] = c.f(i) - f[i];
  return f;
}

class Hourglass : public testing::TestWithParam<int> {};

}    // namespace

// two particles at rest but for their velocities are a row, B = 1, and with F = 1
// x.D_i x = V_j psi (v_ij.x) x^2: what is left is nu = (v_ij.x) [1 - (V_i + V_j)/2 psi x^2]

TEST_P(Hourglass, OfAPairByHand)
{
  const int dim = GetParam();
  for (const bool unlike : {false, true})
    for (const double distance : {0.6, 1.3}) {    // q on both branches of the spline
      Cloud c = empty_cloud(dim);
      c.add({0, 0, 0}, {0.2, 0.1, 0}, 0.3);
      c.add({distance, 0, 0}, {-0.1, 0.3, 0}, 0.4);
      if (unlike) make_another_material(c, {1});
      c.refer();
      const double a = RHO0 * std::sqrt((K + 4.0 / 3.0 * SHEAR) / RHO0) * H;
      const double rho = DENSER * RHO0,
                   b = rho * std::sqrt((OTHER_K + 4.0 / 3.0 * OTHER_SHEAR) / rho) * OTHER_H;
      const double mean = unlike ? 2.0 * a * b / (a + b) : a;
      const double p = psi(dim, distance, unlike ? 0.5 * (H + OTHER_H) : H);
      const double jump =
          -0.3 * distance * (1.0 - 0.35 * p * distance * distance);    // v_ij.x_ij < 0
      const double f = -C_HOURGLASS * 0.3 * 0.4 * p * mean * jump / (-distance);
      const std::vector<Vector3d> found = damping(c);
      EXPECT_NEAR(found[0][0] / f, 1.0, 1e-6);
      EXPECT_NEAR(found[1][0] / f, -1.0, 1e-6);
      EXPECT_EQ(found[0][1], 0.0);    // along the pair, and nothing of how it slides
    }
}

// a disordered body that is stretched, sheared, shaken and compressed unevenly: its densities are not those
// of the reference, so that the two means are not the same either

TEST_P(Hourglass, OfADeformedBodyIsThatOfTheFormula)
{
  const int dim = GetParam();
  for (const bool unlike : {false, true}) {
    Cloud c = empty_cloud(dim);
    c.add_lattice(dim == 2 ? 7 : 5, dim == 2 ? 6 : 4, 4);
    Noise noise(41);
    for (Vector3d &x : c.x) x += 0.15 * c.spacing * noise.vector(dim);
    std::vector<int> half;
    for (int i = 0; i < c.size(); i++)
      if (noise() > 0.0) half.push_back(i);
    if (unlike) make_another_material(c, half);
    c.refer();
    deform(c, large(dim));
    c.stir(noise, 0.05, 0.1);
    const std::vector<Vector3d> expected = expected_damping(c), found = damping(c);
    EXPECT_EQ(c.sweeps->unlike, unlike);
    EXPECT_EQ(c.sweeps->uncorrected(), 0);
    EXPECT_GT(largest(expected), 0.01);
    EXPECT_LT(largest_difference(found, expected), 1e-6 * largest(expected));
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Hourglass, testing::Values(2, 3));
