/* ----------------------------------------------------------------------
   Artificial viscosity of one pair: Shaw & Reid (2009), eqs 23-24.
------------------------------------------------------------------------- */

#include "sph_solid_viscosity.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

namespace {

// a1 = 2, a2 = 4, c = 5, rho = 2 of each of the two

struct Pair {
  double mu, Pi;
};

Pair pair(double vr, double r2, double h, double a1 = 2.0, double a2 = 4.0)
{
  const PairViscosity<double> of_pair(-a1 * h * 10.0, 2.0 * a2 * h * h, 4.0, vr, r2 + 0.01 * h * h);
  return {h * of_pair.approach, of_pair.Pi};
}

}    // namespace

// v.r = -6, r^2 = 4, h = 2: mu = 2(-6)/(4 + 0.01 4) = -2.970297...

TEST(Viscosity, ApproachRateByHand)
{
  EXPECT_DOUBLE_EQ(pair(-6.0, 4.0, 2.0).mu, -12.0 / 4.04);
}

TEST(Viscosity, SeparatingPairFeelsNothing)
{
  EXPECT_EQ(pair(6.0, 4.0, 2.0).mu, 0.0);
  EXPECT_EQ(pair(6.0, 4.0, 2.0).Pi, 0.0);
}

TEST(Viscosity, FiniteWhenParticlesMeet)
{
  EXPECT_DOUBLE_EQ(pair(-1.0, 0.0, 2.0).mu, -50.0);
}

// h = 1, r^2 = 0.99: mu = v.r = -3, and Pi = (2 5 3 + 4 9)/2 = 33

TEST(Viscosity, PiByHand)
{
  EXPECT_DOUBLE_EQ(pair(-3.0, 0.99, 1.0).Pi, 33.0);
}

TEST(Viscosity, PiRepels)
{
  EXPECT_GT(pair(-1e-3, 1.0, 1.0, 1.0, 0.0).Pi, 0.0);
  EXPECT_GT(pair(-1e-3, 1.0, 1.0, 0.0, 1.0).Pi, 0.0);
}

// momentum of the correction: m_i w_ij = m_j w_ji for any two particles

TEST(Viscosity, ConservativeWeightsTimesMassAreSymmetric)
{
  const double m_i = 2.0, m_j = 3.0, wbar = 0.7, n_i = 1.9, n_j = 2.3;
  const double w_ij = correction_weight(Weights::CONSERVATIVE, m_j * wbar, n_i, n_j);
  const double w_ji = correction_weight(Weights::CONSERVATIVE, m_i * wbar, n_j, n_i);
  EXPECT_NEAR(m_i * w_ij, m_j * w_ji, 1e-15);
}

// w_ij = m_j Wbar_ij/max(n_i, n_j), and shepard weights divide by the n of i alone

TEST(Viscosity, WeightsByHand)
{
  EXPECT_DOUBLE_EQ(correction_weight(Weights::CONSERVATIVE, 1.2, 3.0, 2.0), 0.4);
  EXPECT_DOUBLE_EQ(correction_weight(Weights::CONSERVATIVE, 1.2, 3.0, 4.0), 0.3);
  EXPECT_DOUBLE_EQ(correction_weight(Weights::SHEPARD, 1.2, 3.0, 4.0), 0.4);
}

// a row never sums to more than one, else the viscosity would feed noise.  On a square lattice of 6 x 6 with a
// kernel that ends before two spacings, a along axes and d along diagonals, n is 4a + 4d in the bulk, 3a + 2d on
// edges and 2a + d in corners: rows of shepard weights are one everywhere, conservative ones in the bulk only

TEST(Viscosity, RowSumAtMostOne)
{
  constexpr int N = 6;
  constexpr double a = 0.3, d = 0.1;
  auto wbar = [](int i, int j) {
    const int x = i % N - j % N, y = i / N - j / N, r2 = x * x + y * y;
    return r2 == 1 ? a : r2 == 2 ? d : 0.0;
  };
  double n[N * N] = {};
  for (int i = 0; i < N * N; i++)
    for (int j = 0; j < N * N; j++) n[i] += wbar(i, j);
  auto row = [&](Weights weights, int i) {
    double sum = 0.0;
    for (int j = 0; j < N * N; j++) sum += correction_weight(weights, wbar(i, j), n[i], n[j]);
    return sum;
  };
  for (int i = 0; i < N * N; i++) {
    EXPECT_LE(row(Weights::CONSERVATIVE, i), 1.0 + 1e-15);
    EXPECT_NEAR(row(Weights::SHEPARD, i), 1.0, 1e-15);
  }
  const double edge = 3.0 * a + 2.0 * d, bulk = 4.0 * a + 4.0 * d;
  EXPECT_NEAR(row(Weights::CONSERVATIVE, 2 + 2 * N), 1.0, 1e-15);
  EXPECT_NEAR(row(Weights::CONSERVATIVE, 2), 2.0 * a / edge + (a + 2.0 * d) / bulk, 1e-15);
  EXPECT_NEAR(row(Weights::CONSERVATIVE, 0), 2.0 * a / edge + d / bulk, 1e-15);
}

TEST(Viscosity, WeightsOfInversesAreTheSame)
{
  for (const Weights weights : {Weights::CONSERVATIVE, Weights::SHEPARD})
    for (const double n_j : {2.0, 4.0})
      EXPECT_DOUBLE_EQ(correction_weight_of_inverse(weights, 1.2, 1.0 / 3.0, 1.0 / n_j),
                       correction_weight(weights, 1.2, 3.0, n_j));
}
