/* ----------------------------------------------------------------------
   fix_modify ID reference renew, and what files keep of a reference.
------------------------------------------------------------------------- */

#include "lagrangian_block.h"

using namespace sphsolid_test;

namespace {

TEST(RenewReference, OfAStressFreeBodyIsANewBody)
{
  Block b = body();
  const std::string motion = b.motion;
  b.motion = "";
  Session renewed;
  renewed(b.script());
  renewed("run 0\n" + SHEAR + "fix_modify move reference renew\n" + motion + "run 40");

  Session fresh;
  fresh(b.particles() + SHEAR + b.interaction() + motion + b.fixes + "run 40");
  expect_bitwise(fresh.state(), renewed.state());

  // without it the body remembers
  Session old;
  old(b.script());
  old("run 0\n" + SHEAR + motion + "run 40");
  EXPECT_GT(largest_difference(fresh.state(), old.state()), 1.0e-3);
}

TEST(RenewReference, OfAPartOfABodyIsRefused)
{
  Session s;
  Block b = body();
  b.fixes = "region low block INF INF INF 3.5 INF INF\ngroup low region low\n"
            "group high subtract all low\nfix low low sph/solid\nfix high high sph/solid\n"
            "fix step all sph/solid/dt 1 0.3\n";
  s(b.script());
  s("run 1");
  EXPECT_THAT(s.error("fix_modify low reference renew"),
              HasSubstr("Fix_modify reference renew: the group of the fix ends inside a body: "
                        "expected whole bodies"));
}

// two bodies out of reach of each other, under pressure: one is renewed, the other
// keeps its reference

TEST(RenewReference, OfOneOfTwoBodies)
{
  Block b = body();
  b.motion = "region far block 3.5 INF INF INF INF INF\ngroup right region far\n"
             "group left subtract all right\ndisplace_atoms right move 0.005 0 0 units box\n"
             "set group all sph/e 1000\n";
  b.fixes = "fix left left sph/solid\nfix right right sph/solid\ntimestep 1e-8\n";
  const std::string move = "variable dx atom 0.1*x\ndisplace_atoms all move v_dx 0 0 units box\n";
  const State old = run(b, "run 0\n" + move + "run 0"), fresh = run(b, move + "run 0");
  const State renewed = run(b, "run 0\n" + move + "fix_modify right reference renew\nrun 0");
  double difference = 0.0;
  for (int i = 0; i < 48; i++) {
    const bool left = renewed[i].x[0] < 0.005;
    EXPECT_EQ(renewed[i].f[0], (left ? old : fresh)[i].f[0]);
    EXPECT_EQ(renewed[i].f[1], (left ? old : fresh)[i].f[1]);
    difference = std::max(difference, std::fabs(old[i].f[0] - fresh[i].f[0]));
  }
  EXPECT_GT(difference, 1.0e-2 * GAMMA * RHO0 * 1000.0 * 1.0e-3);    // pressure on one particle
}

// two bodies held by a symmetry plane, each with a fix of its own: the state is the one that the last run
// left, and still none of the fixes may continue it

TEST(RenewReference, OfOneOfTwoBodiesOnAPlaneKeepsTheEnergy)
{
  Block b = body();
  b.motion = "region far block 3.5 INF INF INF INF INF\ngroup right region far\n"
             "group left subtract all right\ndisplace_atoms right move 0.005 0 0 units box\n"
             "variable vy atom -1e4*y\nvelocity all set NULL v_vy NULL units box\n";
  b.fixes = "fix left left sph/solid\nfix right right sph/solid\ntimestep 8e-8\n"
            "fix plane all sph/solid/wall ylo 0.0 symmetry\n"
            "compute e all sph/solid/energy\nthermo_style custom step c_e\n";
  for (const char *change : {"fix_modify left reference renew", "fix_modify right reference renew",
                             "fix left left sph/solid", "fix right right sph/solid"}) {
    SCOPED_TRACE(change);
    Session s;
    s(b.script() + "run 20\n");
    const double before = s.value("c_e");
    s(std::string(change) + "\nrun 20");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
  }
}

// a body that has been moved away from a plane and was on both sides of it

TEST(RenewReference, IsNeededForAPlaneThroughTheOldOne)
{
  const std::string away = "run 1\ndisplace_atoms all move 0.01 0 0 units box\n",
                    plane = "fix plane all sph/solid/wall xlo 0.0025 symmetry\n";
  Session s;
  s(body().script() + away + plane);
  EXPECT_THAT(s.error("run 1"),
              HasSubstr("the symmetry plane x = 0.0025 passes between partners "));
  s("fix_modify move reference renew\nrun 1");
  Session beside;
  beside(body().script() + away + "fix plane all sph/solid/wall xlo -0.0005 symmetry\nrun 1");
}

TEST(RenewReference, NeedsTheLagrangianFrame)
{
  Session s;
  Block b = body();
  b.frame = "eulerian";
  s(b.script());
  EXPECT_THAT(s.error("fix_modify move reference renew"),
              HasSubstr("Fix_modify reference: frame eulerian has no reference configuration"));
}

TEST(RenewReference, KnowsNoOtherWord)
{
  Session s;
  s(body().script());
  EXPECT_THAT(s.error("fix_modify move reference reset"),
              HasSubstr("Fix_modify reference of fix sph/solid: found 'reset', expected renew"));
  EXPECT_THAT(s.error("fix_modify move reference"),
              HasSubstr("Fix_modify reference of fix sph/solid: found 'nothing', expected renew"));
}

/* ----------------------------------------------------------------------
   files
------------------------------------------------------------------------- */

TEST(LagrangianFiles, RestartKeepsTheReference)
{
  const std::string path = file("lagrangian.restart");
  {
    Session s;
    s(body().script());
    s("run 40\nwrite_restart " + path);
  }
  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + MOVE + "run 40");
  expect_bitwise(run(body(), "run 80"), s.state());
}

// a body under pressure that is sheared and written

TEST(LagrangianFiles, DataStartANewReference)
{
  const std::string path = file("lagrangian.data");
  Block b = body();
  b.motion = "set group all sph/e 1000\n";
  State old;
  {
    Session s;
    s(b.script());
    s("run 0\n" + SHEAR + "run 0\nwrite_data " + path);
    old = s.state();
  }
  Session s;
  s("units si\ndimension 2\nboundary f f p\natom_style sph/solid\nread_data " + path + "\n" +
    b.interaction() + b.fixes + "run 0");
  EXPECT_LT(largest_difference(run(b, SHEAR + "run 0"), s.state()), 1.0e-12);
  EXPECT_GT(largest_difference(old, s.state()), 1.0e-2);
}

}    // namespace
