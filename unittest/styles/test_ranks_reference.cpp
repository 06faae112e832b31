/* ----------------------------------------------------------------------
   The reference of the Lagrangian frame on several ranks: what commands between runs and
   a ghost cutoff that grows do to it.  Started by mpiexec; the reference is a run of the first rank alone.
------------------------------------------------------------------------- */

#include "ranks.h"

using namespace sphsolid_test;

namespace {

// rank boundaries go through the body

Block body()
{
  Block b;
  b.nx = 8;
  b.ny = 10;
  b.frame = "lagrangian";
  b.box = "-0.001 0.008 -0.001 0.01";
  b.motion = "reset_atoms id sort yes\nvariable vy atom 1e4*(y-0.0045)\n"
             "velocity all set 0 v_vy 0 units box\n";
  b.fixes = "fix move all sph/solid\ntimestep 1e-8\n";
  return b;
}

/* ----------------------------------------------------------------------
   groups that are new after the last run: ghosts do not know of them
------------------------------------------------------------------------- */

TEST(RenewedOnRanks, ByAGroupThatIsNew)
{
  const std::string script = body().script() +
      "run 5\nunfix move\ngroup body type 1\nfix move body sph/solid\n"
      "fix_modify move reference renew\nrun 5\n";
  expect_bitwise(alone(script), together(script));
}

TEST(RenewedOnRanks, InPartIsRefused)
{
  Session s;
  s(body().script());
  s("run 5\nunfix move\nregion low block INF INF INF 5.5 INF INF\ngroup low region low\n"
    "group high subtract all low\nfix low low sph/solid\nfix high high sph/solid");
  EXPECT_THAT(s.error("fix_modify low reference renew"),
              HasSubstr("the group of the fix ends inside a body: expected whole bodies"));
}

TEST(RenewedOnRanks, InPartIsRefusedWithoutGhosts)
{
  Session s;
  s(body().script());
  s("run 5\nunfix move\nregion low block INF INF INF 5.5 INF INF\ngroup low region low\n"
    "group high subtract all low\nfix low low sph/solid\nfix high high sph/solid\n"
    "group first id 1\ndelete_atoms group first compress no");
  EXPECT_EQ(s.lmp->atom->nghost, 0);
  EXPECT_THAT(s.error("fix_modify low reference renew"),
              HasSubstr("the group of the fix ends inside a body: expected whole bodies"));
}

/* ----------------------------------------------------------------------
   a body torn apart in the middle, in a periodic box: its partners' distance grows, the ghost cutoff
   with it, and messages go to more ranks than before.  The fix that makes it grow comes before fix sph/solid
------------------------------------------------------------------------- */

std::string torn()
{
  Block b;
  b.nx = 8;
  b.ny = 10;
  b.h = 2.35e-3;
  b.frame = "lagrangian";
  b.options = "distortion ignore";
  b.boundary = "p p";
  b.box = "-0.001 0.0112 -0.003 0.0132";
  b.first = std::string("processors ") + (ranks() > 1 ? "2" : "1") + " * 1\n";
  b.motion = "reset_atoms id sort yes\nregion right block 3.5 INF INF INF INF INF\n"
             "group right region right\nvelocity right set 1800 0 0 units box\n";
  b.fixes = "fix early all sph/solid\nrun 0\nunfix early\nfix move all sph/solid\ntimestep 1e-8\n"
            "compute e all sph/solid/energy\nthermo_style custom step c_e\n";
  return b.script();
}

TEST(GhostCutoffThatGrows, LeavesNoHeatBehind)
{
  Session s;
  s(torn() + "run 1\n");
  const double before = s.value("c_e");
  s("run 50");
  if (first_rank()) {
    EXPECT_THAT(s.log(), HasSubstr("ghost cutoff enlarged to 0.0063"));    // half a box is 0.0061
  }
  EXPECT_NEAR(s.value("c_e"), before, (mixed_under_test() ? 1.0e-6 : 1.0e-12) * before);
}

// it has grown after the last step, and the next run has no setup

TEST(GhostCutoffThatGrows, IsThatOfARunWithoutSetup)
{
  const std::string rare = "neigh_modify every 1 delay 30 check yes\n",
                    script = torn() + rare + "run 29\nrun 5 pre no\nrun 20 pre no\n";
  Session s;
  s(script);
  EXPECT_EQ(s.value("step"), 54.0);
}

/* ----------------------------------------------------------------------
   particles are deleted on one rank only: all ranks stop
------------------------------------------------------------------------- */

TEST(DeletedOnOneRank, StopsARunWithoutSetup)
{
  Session s;
  s(body().script());
  s("run 5\ngroup first id 1\ndelete_atoms group first compress no");
  EXPECT_THAT(s.error("run 5 pre no"), HasSubstr("expected a 'run 0' before"));
}

}    // namespace
