/* ----------------------------------------------------------------------
   fix sph/solid moves particles that lie side by side in vectors where all of them are in its group,
   and one by one where some are not: to the same bits.
------------------------------------------------------------------------- */

#include "lagrangian_block.h"

using namespace sphsolid_test;

namespace {

// 48 particles in two dimensions, 144 in three

Block spinning(const std::string &frame, int nz)
{
  Block b = body();
  b.nz = nz;
  b.frame = frame;
  b.motion = "variable vx atom 2e4*y*(1+50*x)\nvariable vy atom -2e4*x\n"
             "velocity all set v_vx v_vy NULL units box\n";
  return b;
}

State moved_by(Block b, const std::string &fixes)
{
  b.fixes = fixes;
  return run(b, "run 20");
}

TEST(IntegratedGroups, EverySecondParticleByAFixOfItsOwn)
{
  for (const std::string frame : {"eulerian", "lagrangian"})
    for (const int nz : {0, 3}) {
      SCOPED_TRACE(frame + " " + std::to_string(nz));
      const Block b = spinning(frame, nz);
      expect_bitwise(moved_by(b, "fix move all sph/solid\n"),
                     moved_by(b,
                              "group odd id 1:999:2\ngroup even subtract all odd\n"
                              "fix a odd sph/solid\nfix b even sph/solid\n"));
    }
}

// a quarter is held: it stays where it is, to the last bit, and the rest moves as it does when another
// fix moves every second particle of it

TEST(IntegratedGroups, WhoIsInNoneStaysWhereItIs)
{
  Block b = spinning("lagrangian", 0);
  b.motion +=
      "group held id 20:31\nvelocity held set 0 0 0 units box\ngroup free subtract all held\n";
  Session before;
  before(b.script());
  const State rest = before.state();
  const State one = moved_by(b, "fix move free sph/solid\n");
  for (int k = 19; k < 31; k++)
    for (int a = 0; a < 3; a++) {
      EXPECT_EQ(one[k].x[a], rest[k].x[a]);
      EXPECT_EQ(one[k].v[a], 0.0);
    }
  EXPECT_NE(one[10].x[0], rest[10].x[0]);
  expect_bitwise(one,
                 moved_by(b,
                          "group some id 1:999:2\ngroup odd intersect free some\n"
                          "group even subtract free odd\n"
                          "fix a odd sph/solid\nfix b even sph/solid\n"));
}

// fix nve kicks as ours does, with a time step that changes, too; the velocities are large

TEST(IntegratedGroups, OfFixNveBesideOursKeepTheEnergy)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    SCOPED_TRACE(frame);
    Block b;
    b.nx = b.ny = 8;
    b.frame = frame;
    b.motion = "variable v atom 100*sin(1e4*x*id)\nvelocity all set v_v v_v NULL units box\n";
    b.fixes = "group some id < 20\ngroup others subtract all some\nfix move some sph/solid\n"
              "fix nve others nve\nfix step all sph/solid/dt 3 0.3\n"
              "compute e all sph/solid/energy\nthermo_style custom step c_e\n";
    Session s;
    s(b.script());
    s("run 0");
    const double before = s.value("c_e"), step = s.value("dt");
    s("run 60");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
    EXPECT_GT(std::fabs(s.value("dt") / step - 1.0), 0.003);
  }
}

TEST(IntegratedGroups, OfFixNveBeforeOursAreRefused)
{
  Block b;
  b.nx = b.ny = 4;
  b.fixes = "group some id < 5\ngroup others subtract all some\nfix nve others nve\n"
            "fix move some sph/solid\ntimestep 1e-8\n";
  Session s;
  s(b.script());
  EXPECT_THAT(
      s.error("run 1"),
      HasSubstr("Pair style sph/solid: fix nve of style nve moves 12 particles before the first "
                "fix sph/solid has found their heat: expected it behind that fix"));
}

}    // namespace
