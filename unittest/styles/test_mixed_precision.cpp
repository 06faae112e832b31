/* ----------------------------------------------------------------------
   pair_style ... precision mixed: runs beside those in double precision, what it conserves, and what it
   refuses.
------------------------------------------------------------------------- */

#include "lagrangian_block.h"

using namespace sphsolid_test;

namespace {

Block mixed(const std::string &frame)
{
  Block b;
  b.frame = frame;
  b.options = "precision mixed";
  return b;
}

/* ----------------------------------------------------------------------
   what it gives
------------------------------------------------------------------------- */

class MixedPrecision : public testing::TestWithParam<const char *> {};

INSTANTIATE_TEST_SUITE_P(Frames, MixedPrecision, testing::Values("eulerian", "lagrangian"),
                         [](const auto &info) {
                           return std::string(info.param);
                         });

// a rod that hits a wall, spreads and bounces

TEST_P(MixedPrecision, MovesARodAsDoubleDoes)
{
  Block b = mixed(GetParam());
  b.fixes += "fix floor all sph/solid/wall ylo -0.0005\n";
  const State of_mixed = run(b, "run 300");
  b.options = "precision double";
  const State of_double = run(b, "run 300");
  EXPECT_LT(largest_difference(of_mixed, of_double), 2.0e-5);
  EXPECT_GT(largest_difference(of_mixed, of_double), 0.0);
}

// energy: kinetic, internal and what the wall has taken; the sum of roundings, none of which is more than
// 10^-7 of what a step moves

TEST_P(MixedPrecision, KeepsTheEnergy)
{
  Session s;
  Block b = mixed(GetParam());
  b.fixes += "fix floor all sph/solid/wall ylo -0.0005\ncompute e all sph/solid/energy\n"
             "thermo_style custom step c_e\n";
  s(b.script() + "run 0\n");
  const double before = s.value("c_e");
  s("run 500");
  EXPECT_NEAR(s.value("c_e"), before, 1.0e-6 * before);
}

// of a free body that spins and shears

TEST_P(MixedPrecision, KeepsTheMomentum)
{
  Session s;
  Block b = body("precision mixed");
  b.frame = GetParam();
  b.fixes += "variable px equal mass(all)*vcm(all,x)\nvariable py equal mass(all)*vcm(all,y)\n"
             "variable scale equal sqrt(2*ke(all)*mass(all))\n"
             "thermo_style custom step v_px v_py v_scale\n";
  s(b.script() + "run 0\n");
  const double px = s.value("v_px"), py = s.value("v_py"), scale = s.value("v_scale");
  s("run 500");
  EXPECT_NEAR(s.value("v_px"), px, 1.0e-7 * scale);
  EXPECT_NEAR(s.value("v_py"), py, 1.0e-7 * scale);
}

// the step of "cfl auto" follows from the highest frequency, found with sums in single precision

TEST_P(MixedPrecision, FindsTheSameTimeStep)
{
  auto step = [](const std::string &options) {
    Session s;
    Block b;
    b.frame = GetParam();
    b.options = options;
    b.fixes = "fix move all sph/solid\nfix step all sph/solid/dt 1 auto\n";
    s(b.script() + "thermo_style custom step dt\nrun 1\n");
    return s.value("dt");
  };
  const double exact = step("precision double");
  EXPECT_NEAR(step("precision mixed"), exact, 1.0e-4 * exact);
}

// another precision between two runs is another pair style command, and no continuation

TEST_P(MixedPrecision, TakesOverAndGivesBack)
{
  Block b;
  b.frame = GetParam();
  b.options = "precision double";
  Session s;
  s(b.script() + "run 50\n");
  const std::string rest = "pair_coeff * * " + b.material + "run 50\n";
  s("pair_style sph/solid 1.3e-3 frame " + b.frame + " precision mixed\n" + rest);
  s("pair_style sph/solid 1.3e-3 frame " + b.frame + " precision double\n" + rest);
  EXPECT_LT(largest_difference(run(b, "run 150"), s.state()), 0.05);
}

/* ----------------------------------------------------------------------
   what it refuses
------------------------------------------------------------------------- */

struct Refused {
  const char *name;
  std::function<void(Block &)> change;
  const char *message;
};

class MixedPrecisionRefuses : public testing::TestWithParam<Refused> {};

TEST_P(MixedPrecisionRefuses, WithMessage)
{
  Block b = mixed("eulerian");
  GetParam().change(b);
  Session s;
  EXPECT_THAT(s.error(b.script() + "run 0\n"), HasSubstr(GetParam().message));
  b.options += " precision double";
  Session of_double;
  of_double(b.script() + "run 0\n");
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, MixedPrecisionRefuses,
    testing::Values(
        Refused{"a_box_far_away",
                [](Block &b) {
                  b.box = "-0.04 2e5 -0.04 0.04";
                  b.first = "atom_modify sort 0 0\n";
                  b.motion = "neighbor 0.0003 nsq\n";
                },
                "precision mixed: the box reaches to 2e+05 along x in step 0: expected less than "
                "1.3e+05"},
        Refused{"a_wide_skin",
                [](Block &b) {
                  b.motion = "neighbor 0.4 nsq\n";
                },
                "precision mixed: neighbor lists reach 0.4026, with the skin 0.4: expected at most "
                "256 of the least smoothing length, 0.3328"},
        Refused{"unlike_lengths",
                [](Block &b) {
                  b.types = 2;
                  b.motion = "neighbor 0.0003 nsq\npair_coeff 2 2 inline rho0 7850 eos linear 1e11 "
                             "shear 80e9 strength "
                             "elastic h 0.1\n"
                             "region second block 0.0095 1 INF INF INF INF units box\n"
                             "set region second type 2\n";
                },
                "precision mixed: smoothing lengths of types are from 0.0013 to 0.1: expected a "
                "factor of at most 64"},
        Refused{"units_too_large",
                [](Block &b) {
                  b.material = "inline rho0 1e22 eos linear 1e29 shear 80e27 strength elastic\n";
                },
                "precision mixed: in units si the smoothing length 0.0013, mass 1e+16 or modulus"}),
    [](const auto &info) {
      return std::string(info.param.name);
    });

// with "distortion ignore", too: a partner is dragged away

TEST(MixedPrecisionStops, WherePartnersAreTooFarApart)
{
  Block b = body("distortion ignore viscosity none hourglass 0 precision mixed");
  b.box = "-1.0 0.04 -0.04 0.04";
  b.material = "inline rho0 7850 eos linear 1e5 shear 1e4 strength elastic\n";
  b.motion = "group one id 1\nvelocity one set -1e5 0 0 units box\n";
  b.fixes = "fix move all sph/solid\ntimestep 1e-9\n";
  Session s;
  EXPECT_THAT(s.error(b.script() + "run 5000\n"),
              HasSubstr("further than this precision can tell: expected less than 256 smoothing "
                        "lengths, or precision double"));
}

}    // namespace
