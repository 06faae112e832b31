/* ----------------------------------------------------------------------
   Elastic constants that belong together.
------------------------------------------------------------------------- */

#include "sph_solid_material.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

namespace {

// the iron of Shaw & Reid (2009), table 1

Material iron()
{
  Material m;
  m.rho0 = 7850.0;
  m.eos = EOS::MIE_GRUNEISEN;
  m.C = 3600.0;
  m.S = 1.8;
  m.Gamma = 1.8;
  m.shear = 80.0e9;
  return m;
}

}    // namespace

// K = rho0 C^2 = 101.736 GPa; with mu = 80 GPa the material behaves as
// E = 9 K mu/(3 K + mu) = 190.157 GPa, nu = 0.18848, not as the 208 GPa of the
// table (own evaluation)

TEST(Material, ConstantsOfMieGruneisenIron)
{
  const Material m = iron();
  EXPECT_NEAR(m.bulk_modulus(), 101.736e9, 1.0);
  EXPECT_NEAR(m.youngs_modulus(), 9.0 * 101.736e9 * 80.0 / (3.0 * 101.736 + 80.0), 1.0);
  EXPECT_NEAR(m.youngs_modulus(), 190.157e9, 0.0005e9);
  EXPECT_NEAR(m.poisson_ratio(), 0.18848, 5e-6);
}

// E = 2 mu (1 + nu) = 3 K (1 - 2 nu)

TEST(Material, ConstantsAgree)
{
  Material m = iron();
  for (double shear : {20.0e9, 80.0e9, 200.0e9}) {
    m.shear = shear;
    const double E = m.youngs_modulus(), nu = m.poisson_ratio();
    EXPECT_NEAR(2.0 * shear * (1.0 + nu) / E, 1.0, 1e-14);
    EXPECT_NEAR(3.0 * m.bulk_modulus() * (1.0 - 2.0 * nu) / E, 1.0, 1e-14);
  }
}

// c_L^2 = (K + 4/3 mu)/rho0: 5152.5 m/s, c = C

TEST(Material, WaveSpeeds)
{
  EXPECT_NEAR(iron().longitudinal_speed(), 5152.5, 0.05);
  EXPECT_DOUBLE_EQ(iron().bulk_sound_speed(), 3600.0);
}

TEST(Material, BulkModulusOfLinearForm)
{
  Material m = iron();
  m.eos = EOS::LINEAR;
  m.K = 3.25e6;
  m.shear = 7.15e5;
  EXPECT_EQ(m.bulk_modulus(), 3.25e6);
  // the rubber of Gray, Monaghan & Swift (2001): E = 2 MPa, nu = 0.3975 to 3 digits
  EXPECT_NEAR(m.youngs_modulus(), 2.0e6, 2.0e3);
  EXPECT_NEAR(m.poisson_ratio(), 0.3975, 5e-4);
}
