/* ----------------------------------------------------------------------
   The contact wall brings particles to rest on it over one time step: whichever command says how
   long that is, and whenever it changes.
------------------------------------------------------------------------- */

#include "session.h"

using namespace sphsolid_test;

namespace {

const std::vector<std::string> FRAMES = {"eulerian", "lagrangian"};
const std::string WALL = "fix floor all sph/solid/wall ylo 0\n",
                  ENERGY = "compute e all sph/solid/energy\nthermo_style custom step dt c_e\n";

Block body(const std::string &frame, const std::string &fixes)
{
  Block b;
  b.nx = 6;
  b.ny = 8;
  b.frame = frame;
  b.fixes = "fix move all sph/solid\n" + fixes + ENERGY;
  return b;
}

/* ----------------------------------------------------------------------
   the block lies on the wall from the first step on, and fix sph/solid/dt has the last word on the
   length of this step, whatever 'timestep' says
------------------------------------------------------------------------- */

TEST(ContactWall, MayBeDefinedBeforeTheTimeStep)
{
  for (const std::string &frame : FRAMES)
    for (const char *step :
         {"fix step all sph/solid/dt 10 auto\n", "fix step all sph/solid/dt 1 0.3\n"})
      for (const char *first : {"", "timestep 1e-9\n", "timestep 1e-6\n"}) {
        SCOPED_TRACE(frame + " " + step + first);
        Session before, behind;
        before(body(frame, first + WALL + step).script());
        behind(body(frame, first + std::string(step) + WALL).script());
        before("run 1");
        behind("run 1");
        // the lowest row has been brought to rest
        for (int id = 1; id <= 6; id++) EXPECT_NEAR(before.particle(id).x[1], 0.0, 1.0e-12);
        before("run 40");
        behind("run 40");
        expect_bitwise(before.state(), behind.state());
        EXPECT_EQ(before.value("c_e"), behind.value("c_e"));
        EXPECT_EQ(before.value("f_floor"), behind.value("f_floor"));
      }
}

/* ----------------------------------------------------------------------
   another time step between two runs.  The block flies 0.01 mm, 1e-8 s times 5, before its lowest
   row lands: the change comes while it flies, in the step in which it lands, and later
------------------------------------------------------------------------- */

struct Impact {
  double loss, fastest;    // change of energy over energy; velocity away from the wall
};

Impact impact(const std::string &frame, const std::string &first, int steps,
              const std::string &second)
{
  Block b = body(frame, WALL + "timestep " + first + "\n");
  b.motion += "displace_atoms all move 0 1e-5 0 units box\n";
  Session s;
  s(b.script());
  s("run 0");
  const double before = s.value("c_e");
  s("run " + std::to_string(steps) + "\ntimestep " + second);
  Impact result = {0.0, 0.0};
  for (int k = 0; k < 10; k++) {
    s("run 1");
    result.loss = std::max(result.loss, std::fabs(s.value("c_e") / before - 1.0));
    for (const Particle &p : s.state()) result.fastest = std::max(result.fastest, p.v[1]);
  }
  return result;
}

class ChangedTimeStep : public testing::TestWithParam<int> {};

TEST_P(ChangedTimeStep, KeepsTheEnergyOfAnImpact)
{
  for (const std::string &frame : FRAMES)
    for (const char *second : {"1e-7", "1e-9", "2e-8", "1.5e-8", "5e-9"}) {
      SCOPED_TRACE(frame + " " + second);
      const Impact is = impact(frame, "1e-8", GetParam(), second);
      EXPECT_LT(is.loss, 1.0e-3);
      EXPECT_LT(is.fastest, 200.0);    // no particle leaves faster than it came
    }
}

INSTANTIATE_TEST_SUITE_P(Steps, ChangedTimeStep, testing::Values(1, 4, 5, 6, 10),
                         [](const auto &info) {
                           return "after" + std::to_string(info.param);
                         });

/* ----------------------------------------------------------------------
   nobody is left whom a time step could be too long for
------------------------------------------------------------------------- */

TEST(TimeStepOfNoParticles, StaysAsItIs)
{
  for (const std::string &frame : FRAMES) {
    Session s;
    s(body(frame, "fix step all sph/solid/dt 1 0.3\n").script());
    s("run 5");
    const double dt = s.value("dt");
    s("delete_atoms group all\nrun 5");
    EXPECT_EQ(s.value("dt"), dt);
  }
}

TEST(TimeStepOfNoParticles, IsTheLargestOne)
{
  for (const std::string &frame : FRAMES) {
    Session s;
    s(body(frame, "fix step all sph/solid/dt 1 0.3 max 1e-6\n").script());
    s("run 5");
    EXPECT_LT(s.value("dt"), 0.9e-6);
    s("delete_atoms group all\nrun 5");
    EXPECT_EQ(s.value("dt"), 1.0e-6);
  }
}

// the same step once more is no change

TEST(SameTimeStep, BetweenRunsChangesNothing)
{
  for (const std::string &frame : FRAMES) {
    Session one, two;
    one(body(frame, WALL + "timestep 1e-8\n").script());
    one("run 40");
    two(body(frame, WALL + "timestep 1e-8\n").script());
    two("run 20\ntimestep 1e-8\nrun 20");
    expect_bitwise(one.state(), two.state());
  }
}

// where a particle lands while the time step changes is not quite on the wall

TEST(ContactWall, ToleratesAThousandthOfHBehindIt)
{
  auto problem = [](double behind, const std::string &kind) {
    Block b;
    b.nx = b.ny = 4;
    b.fixes = "fix move all sph/solid\ntimestep 1e-8\nfix floor all sph/solid/wall ylo " +
        num(behind * b.h) + " " + kind + "\n";
    Session s;
    s(b.script());
    return s.error("run 1");
  };
  EXPECT_EQ(problem(0.9e-3, "contact"), "");
  EXPECT_THAT(problem(1.1e-3, "contact"), HasSubstr("lies behind the wall"));
  EXPECT_EQ(problem(0.9e-6, "symmetry"), "");
  EXPECT_THAT(problem(1.1e-6, "symmetry"), HasSubstr("lies behind the wall"));
}

}    // namespace
