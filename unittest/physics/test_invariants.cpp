/* ----------------------------------------------------------------------
   Equivalent stress and elastic energy, from the textbook's simple states of stress.
------------------------------------------------------------------------- */

#include "sph_solid_invariants.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

namespace {

Material iron()
{
  Material m;
  m.rho0 = 7850.0;
  m.eos = EOS::LINEAR;
  m.K = 170.0e9;
  m.shear = 80.0e9;
  return m;
}

constexpr double SIGMA = 3.0e8;

// tension along y: P = -sigma/3

const double TENSION[6] = {-SIGMA / 3.0, 2.0 * SIGMA / 3.0, -SIGMA / 3.0, 0.0, 0.0, 0.0};

}    // namespace

TEST(Invariants, EquivalentStressOfTensionIsTheTension)
{
  EXPECT_NEAR(von_mises(TENSION), SIGMA, 1.0e-14 * SIGMA);
}

TEST(Invariants, EquivalentStressOfShearIsRootThreeOfIt)
{
  for (int k = 3; k < 6; k++) {
    double shear[6] = {};
    shear[k] = SIGMA;
    EXPECT_NEAR(von_mises(shear), std::sqrt(3.0) * SIGMA, 1.0e-14 * SIGMA);
  }
}

// sigma^2/(2 E), tau^2/(2 mu), P^2/(2 K)

TEST(Invariants, ElasticEnergyOfTension)
{
  const double E = 9.0 * 170.0e9 * 80.0e9 / (3.0 * 170.0e9 + 80.0e9);
  const double expected = SIGMA * SIGMA / (2.0 * E);
  EXPECT_NEAR(elastic_energy_density(iron(), TENSION, -SIGMA / 3.0), expected, 1.0e-14 * expected);
}

TEST(Invariants, ElasticEnergyOfShear)
{
  const double shear[6] = {0.0, 0.0, 0.0, 0.0, SIGMA, 0.0},
               expected = SIGMA * SIGMA / (2.0 * 80.0e9);
  EXPECT_NEAR(elastic_energy_density(iron(), shear, 0.0), expected, 1.0e-14 * expected);
}

TEST(Invariants, ElasticEnergyOfPressure)
{
  const double none[6] = {}, expected = SIGMA * SIGMA / (2.0 * 170.0e9);
  EXPECT_NEAR(elastic_energy_density(iron(), none, SIGMA), expected, 1.0e-14 * expected);
}
