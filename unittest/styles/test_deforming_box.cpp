/* ----------------------------------------------------------------------
   A periodic box full of particles that fix deform changes: all of them are in the same state,
   that of the rate law.
------------------------------------------------------------------------- */

#include "session.h"

using namespace sphsolid_test;

namespace {

constexpr double LENGTH = 0.01, SPEED = 20.0, K = 100.0e9;

// 10 x 10 particles, elastic, for 2 us to a strain of 0.004.  The velocity belongs to that of the
// box.  LAMMPS moves particles in one step and the box at its end, so what lies across the boundary
// is one step behind: 4e-5 of a spacing

std::string full_box(const std::string &motion, const std::string &shape = "prism")
{
  return "units si\ndimension 2\nboundary p p p\natom_style sph/solid\natom_modify map array\n"
         "region box " +
      shape + " 0 0.01 0 0.01 -0.0005 0.0005" + (shape == "prism" ? " 0 0 0" : "") +
      "\ncreate_box 1 box\nlattice sq 0.001 origin 0.5 0.5 0\ncreate_atoms 1 box\n"
      "set group all volume 1e-6\npair_style sph/solid 1.3e-3 frame eulerian viscosity none\n"
      "pair_coeff * * inline rho0 7850 eos linear 100e9 shear 80e9 strength elastic\n" +
      NEIGHBOR + "fix move all sph/solid\ntimestep 2e-9\ncompute e all sph/solid/energy\n" +
      "thermo_style custom step c_e[2] c_e[3]\n" + motion;
}

const std::string SHEAR = "variable vx atom 20*y/0.01\nvelocity all set v_vx 0 0 units box\n"
                          "fix box all deform 1 xy vel 20 remap v units box\n",
                  PULL = "variable vx atom 20*(x/0.01-0.5)\nvelocity all set v_vx 0 0 units box\n"
                         "fix box all deform 1 x vel 20 remap v units box\n",
                  RUN = "run 1000";
constexpr double STRAIN = 1000 * 2.0e-9 * SPEED / LENGTH;

/* ----------------------------------------------------------------------
   simple shear g and the rate of Jaumann: the stress turns with half of it,
   sxy = mu sin(g), sxx = -syy = mu (1 - cos(g)), of second order
------------------------------------------------------------------------- */

TEST(DeformingBox, ShearsWithTheStressOfTheRateLaw)
{
  Session s;
  s(full_box(SHEAR) + RUN);
  const double shear = MU * std::sin(STRAIN), turned = MU * (1.0 - std::cos(STRAIN));
  for (const Particle &p : s.state()) {
    EXPECT_NEAR(p.stress[3], shear, 1.0e-6 * shear);
    EXPECT_NEAR(p.stress[0], turned, 1.0e-2 * turned);
    EXPECT_NEAR(p.stress[1], -turned, 1.0e-2 * turned);
    EXPECT_NEAR(p.rho, RHO0, 1.0e-7 * RHO0);
  }
}

// what the box does to the particles is there as elastic energy: mu g^2/2 per volume

TEST(DeformingBox, ShearsIntoElasticEnergy)
{
  Session s;
  s(full_box(SHEAR) + RUN);
  const double energy = 0.5 * MU * STRAIN * STRAIN * LENGTH * LENGTH;
  EXPECT_NEAR(s.value("c_e[2]"), energy, 1.0e-5 * energy);
  EXPECT_NEAR(s.value("c_e[3]"), s.value("c_e[2]"), 1.0e-4 * energy);
}

/* ----------------------------------------------------------------------
   nothing turns in uniaxial strain: the deviatoric stress is that of ln(length)
------------------------------------------------------------------------- */

TEST(DeformingBox, PullsWithTheStressOfTheRateLaw)
{
  Session s;
  s(full_box(PULL) + RUN);
  const double third = 2.0 / 3.0 * MU * std::log(1.0 + STRAIN);
  for (const Particle &p : s.state()) {
    EXPECT_NEAR(p.stress[0], 2.0 * third, 2.0e-4 * third);
    EXPECT_NEAR(p.stress[1], -third, 2.0e-4 * third);
    EXPECT_NEAR(p.stress[3], 0.0, 2.0e-4 * third);
    EXPECT_NEAR(p.rho, RHO0 / (1.0 + STRAIN), 1.0e-4 * STRAIN * RHO0);
  }
}

// the work of sxx - p, p = K (rho/rho0 - 1), on the volume that grows

TEST(DeformingBox, PullsIntoElasticEnergy)
{
  Session s;
  s(full_box(PULL) + RUN);
  const double stretch = 1.0 + STRAIN, e = std::log(stretch);
  const double energy =
      LENGTH * LENGTH * (K * (stretch - 1.0 - e) + 4.0 / 3.0 * MU * (stretch * (e - 1.0) + 1.0));
  EXPECT_NEAR(s.value("c_e[2]"), energy, 1.0e-4 * energy);
  // an estimate of second order in the strain
  EXPECT_NEAR(s.value("c_e[3]"), s.value("c_e[2]"), STRAIN * energy);
}

/* ---------------------------------------------------------------------- */

// but for forces: they would be zero if the box were not one step behind, which it is not when a run
// begins

TEST(DeformingBox, RunsInTwoPartsEqualOne)
{
  for (const std::string &motion : {SHEAR, PULL}) {
    Session one, two;
    one(full_box(motion) + RUN);
    two(full_box(motion) + "run 500\nrun 500");
    const State a = one.state(), b = two.state();
    double dx = 0.0, dv = 0.0, ds = 0.0, de = 0.0;
    for (std::size_t i = 0; i < a.size(); i++) {
      dx = std::max(dx, std::fabs(a[i].x[0] - b[i].x[0]));
      dv = std::max(dv, std::fabs(a[i].v[0] - b[i].v[0]));
      ds = std::max(ds, std::fabs(a[i].stress[0] - b[i].stress[0]));
      ds = std::max(ds, std::fabs(a[i].stress[3] - b[i].stress[3]));
      de = std::max(de, std::fabs(a[i].e - b[i].e));
    }
    EXPECT_LT(dx, 1.0e-6 * LENGTH);
    EXPECT_LT(dv, 1.0e-6 * SPEED);
    EXPECT_LT(ds, 1.0e-6 * MU * STRAIN);
    EXPECT_LT(de, 1.0e-6 * one.value("c_e[2]") / (RHO0 * LENGTH * LENGTH));
  }
}

// particles that are moved without a velocity feel no strain

class BoxWithoutVelocities : public testing::TestWithParam<std::string> {};

TEST_P(BoxWithoutVelocities, IsRefused)
{
  const std::string fix = GetParam();
  Session s;
  s(full_box("", fix.find("xy") < fix.size() ? "prism" : "block"));
  EXPECT_THAT(s.error("fix box all " + fix + "\nrun 1"),
              HasSubstr("expected fix deform ... remap v"));
}

INSTANTIATE_TEST_SUITE_P(Fixes, BoxWithoutVelocities,
                         testing::Values("deform 1 xy vel 20 remap x units box",
                                         "deform 1 xy vel 20 remap none units box",
                                         "deform 1 x vel 20 units box",
                                         "press/berendsen iso 0 0 1e-6 modulus 1e11"),
                         [](const auto &info) {
                           return "set" + std::to_string(info.index);
                         });

}    // namespace
