/* ----------------------------------------------------------------------
   A run that does not continue the last one loses no energy and no momentum.
------------------------------------------------------------------------- */

#include "between_runs.h"

using namespace sphsolid_test;

namespace {

/* ----------------------------------------------------------------------
   a run that does not continue the last one.  During a run the stored internal energy is half a
   step behind; that half step must not get lost.  In this body it is 0.4 % of all energy, which is far more
   than what is allowed here.  One particle is at rest far away
------------------------------------------------------------------------- */

const std::string MOVE_AND_SUM = "fix move all sph/solid\ntimestep 8e-8\n"
                                 "compute e all sph/solid/energy\n"
                                 "thermo_style custom step pe c_e c_e[2]\n";

// that is at rest far away

const std::string FAR = "create_atoms 1 single 0.03 0.03 0 units box\ngroup far id 49\n"
                        "set group far volume 1e-6\nvelocity far set 0 0 0 units box\n";

Block summed(const std::string &frame)
{
  Block b = body();
  b.frame = frame;
  b.fixes = MOVE_AND_SUM;
  return b;
}

// kinetic energy and what atom->esph has

double stored_energy(const Session &s)
{
  double sum = 0.0;
  for (const Particle &p : s.state())
    sum += p.mass * (p.e + 0.5 * (p.v[0] * p.v[0] + p.v[1] * p.v[1]));
  return sum;
}

class NotContinued : public testing::TestWithParam<Case> {
 protected:
  static std::string script(const std::string &frame)
  {
    Block b = summed(frame);
    b.motion += FAR;
    return b.script();
  }
  static std::vector<std::string> frames() { return {"lagrangian", "eulerian"}; }

  // after each of these inputs that of a run of 20 steps before them
  static void expect_constant_energy(const std::vector<std::string> &inputs)
  {
    for (const std::string &frame : frames()) {
      SCOPED_TRACE(frame);
      Session s;
      s(script(frame));
      s("run 20");
      const double before = s.value("c_e");
      for (const std::string &input : inputs) {
        s(input);
        EXPECT_NEAR(s.value("c_e"), before, 1.0e-8 * before);
      }
    }
  }
};

TEST_P(NotContinued, KeepsTheEnergy)
{
  expect_constant_energy({GetParam().input + "\nrun 0", "run 20"});
}

TEST_P(NotContinued, KeepsTheEnergyInTheFirstStepsToo)
{
  expect_constant_energy({GetParam().input + "\nrun 20"});
}

// the pair energy is that of the last step, and the energy of the compute has the half step in addition

TEST_P(NotContinued, HasNoHeatToCome)
{
  for (const std::string &frame : frames()) {
    SCOPED_TRACE(frame);
    Session s;
    s(script(frame));
    s("run 20");
    EXPECT_GT(std::fabs(s.value("c_e[2]") - s.value("pe")), 1.0e-4 * s.value("pe"));
    s(GetParam().input + "\nrun 0");
    EXPECT_NEAR(s.value("c_e[2]"), s.value("pe"), 1.0e-12 * s.value("pe"));
  }
}

TEST_P(NotContinued, KeepsTheMomentum)
{
  for (const std::string &frame : frames()) {
    SCOPED_TRACE(frame);
    Session s;
    s(script(frame));
    s("run 20\n" + GetParam().input);
    const Momentum before = momentum(s.state());
    s("run 20");
    expect_same(before, momentum(s.state()));
  }
}

INSTANTIATE_TEST_SUITE_P(
    After, NotContinued,
    testing::Values(
        Case{"AVelocity", "group one id 20\nvelocity one set 1e-6 0 0 sum yes units box", ""},
        Case{"AnotherFix", "unfix move\nfix move all sph/solid", ""},
        Case{"ADeletedParticle", "delete_atoms group far compress no", ""},
        Case{"ADeletedParticleAndARestartFile",
             "write_restart " + file("not_continued.restart") +
                 "\ndelete_atoms group far compress no",
             ""},
        Case{"AnotherFixAndADataFile",
             "write_data " + file("not_continued.data") + "\nunfix move\nfix move all sph/solid",
             ""},
        Case{"ADisplacement", "displace_atoms all move 0.001 0 0 units box", ""},
        Case{"AnotherMaterial",
             "pair_coeff * * inline rho0 7850 eos mie-gruneisen 5000 1.8 1.8 shear 80e9 strength "
             "perfect 600e6",
             ""},
        Case{"ADensity", "set group far sph/rho 7850.001", ""},
        Case{"ASymmetryPlane", "fix mirror all sph/solid/wall ylo -0.005 symmetry", ""}),
    name_of);

/* ----------------------------------------------------------------------
   a run that continues with other forces: the heat of the half kick before belongs to the old ones.  A block is
   pressed against a wall, or pushed
------------------------------------------------------------------------- */

class OtherForces : public testing::TestWithParam<Case> {};

TEST_P(OtherForces, KeepTheEnergy)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    SCOPED_TRACE(frame);
    Block b;
    b.nx = 8;
    b.ny = 10;
    b.frame = frame;
    b.fixes = MOVE_AND_SUM + "variable sum equal c_e[1]+c_e[2]\n" + GetParam().message;
    Session s;
    s(b.script());
    s("run 60");
    const double before = s.value("c_e[1]+c_e[2]");
    s(GetParam().input + "\nrun 0");
    EXPECT_NEAR(s.value("c_e[1]+c_e[2]"), before, 1.0e-12 * before);
    s("run 10");
    EXPECT_NEAR(s.value("c_e[1]+c_e[2]"), before, 1.0e-12 * before);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, OtherForces,
    testing::Values(Case{"AWallThatGoes", "unfix wall", "fix wall all sph/solid/wall ylo 0.0\n"},
                    Case{"APushThatEnds", "unfix push", "fix push all addforce 0 1e4 0\n"}),
    name_of);

TEST(OtherForcesOfTheSameKind, ContinueBitwise)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    Block b;
    b.frame = frame;
    b.fixes = MOVE_AND_SUM + "fix wall all sph/solid/wall ylo 0.0\n";
    const std::string again = "unfix wall\nfix wall all sph/solid/wall ylo 0.0\n";
    expect_bitwise(run(b, "run 100"), run(b, "run 60\n" + again + "run 40"));
  }
}

// another integrator kicks alike, and heats in another way

TEST(OtherIntegrator, KeepsTheEnergy)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    SCOPED_TRACE(frame);
    Session s;
    s(summed(frame).script());
    s("run 20");
    const double before = s.value("c_e");
    s("group some id < 20\ngroup others subtract all some\nunfix move\nfix move some sph/solid\n"
      "fix nve others nve\nrun 0");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
    s("run 20");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
    s("unfix nve\nfix rest others sph/solid\nrun 0");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
  }
}

// of two fixes sph/solid the first one goes after other forces have been found; its place is taken

TEST(OtherLeader, KeepsTheEnergy)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    SCOPED_TRACE(frame);
    Block b = summed(frame);
    b.material = "inline rho0 7850 eos linear 170e9 shear 80e9 strength perfect 600e6\n";
    b.fixes = "group low id < 20\ngroup high subtract all low\nfix a low sph/solid\n"
              "fix b high sph/solid\n" +
        MOVE_AND_SUM.substr(MOVE_AND_SUM.find("timestep")) + "fix push all addforce 0 1e4 0\n";
    Session s;
    s(b.script());
    s("run 20");
    const double before = s.value("c_e");
    s("unfix push\nrun 0\nunfix a\nfix a low sph/solid\nrun 0");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
  }
}

// a wall just below the block, which flies on to it: nobody passes

TEST(OtherForcesOfANewWall, StopParticlesInTheFirstStep)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    SCOPED_TRACE(frame);
    Block b;
    b.nx = b.ny = 6;
    b.frame = frame;
    b.fixes = MOVE_AND_SUM;
    Session s;
    s(b.script());
    s("run 10");
    const double foot = s.particle(1).x[1], wall = foot - 1.0e-7;    // a step is 1.6e-5
    const double before = s.value("c_e");
    s("fix wall all sph/solid/wall ylo " + num(wall) + "\nrun 1");
    EXPECT_NEAR(s.particle(1).x[1], wall, 1.0e-15);
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);    // with what the wall has taken
    s("run 20");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
  }
}

TEST(RunOfNoStepsWithoutSetup, ChangesNothing)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    Block b = body();
    b.frame = frame;
    expect_bitwise(run(b, "run 40"), run(b, "run 20\nrun 0 pre no\nrun 20"));
    expect_bitwise(run(b, "run 40"), run(b, "run 20\nrun 0 pre no\nrun 20 pre no"));
  }
}

// what a run without setup would undo or forget

TEST(RunWithoutSetup, IsRefusedAfterAChange)
{
  for (const char *change : {"fix_modify move reference renew", "set group all sph/e 1",
                             "velocity all set 1 NULL NULL sum yes units box"}) {
    Session s;
    s(body().script());
    s("run 10\nrun 10 pre no\n" + std::string(change));
    EXPECT_THAT(
        s.error("run 10 pre no"),
        HasSubstr("A run with 'pre no' goes on from the last one, and the state of sph/solid, its "
                  "reference or what moves it has changed since"))
        << change;
  }
}

TEST(RunWithoutSetup, IsRefusedWithOtherFixes)
{
  for (const char *frame : {"lagrangian", "eulerian"})
    for (const char *change :
         {"unfix step", "fix push all addforce 1e5 0 0", "fix stop all momentum 10 linear 1 1 1"}) {
      Block b = body();
      b.frame = frame;
      Session s;
      s(b.script());
      s("run 10\n" + std::string(change));
      EXPECT_THAT(s.error("run 10 pre no"),
                  testing::ContainsRegex("A run with 'pre no' .* fixes have come or gone since"))
          << frame << change;
    }
}

TEST(RunWithoutSetup, IsRefusedWithATimeStepThatIsNone)
{
  Session s;
  Block b = body();
  b.fixes = "fix move all sph/solid\ntimestep 1e-8\n";
  s(b.script());
  s("run 10\ntimestep -1e-8");
  EXPECT_THAT(s.error("run 10 pre no"),
              HasSubstr("the time step is -1e-08: expected timestep with a value > 0"));
}

// a step to the side in a periodic box does not go unnoticed, as a wrapped particle does

TEST(NotContinuedRun, AfterAStepInAPeriodicBoxHasNoHeatToCome)
{
  for (const char *command : {"displace_atoms all move 0.0005 0 0 units box", ""}) {
    Block b = bar();
    b.frame = "eulerian";
    b.fixes = MOVE_AND_SUM;
    Session s;
    s(b.script());
    s("run 20");
    const double before = s.value("c_e");
    s(std::string(command) + "\nrun 0");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
    const double to_come = std::fabs(s.value("c_e[2]") - s.value("pe")) / s.value("pe");
    if (*command)
      EXPECT_LT(to_come, 1.0e-12);
    else
      EXPECT_GT(to_come, 1.0e-6);
  }
}

// what a clamp held is let go: the last half kick was not one of its particles

TEST(NotContinuedRun, WithMoreParticlesThatMoveKeepsTheEnergy)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    SCOPED_TRACE(frame);
    Block b = body();
    b.frame = frame;
    b.fixes = "group top id 43:48\ngroup free subtract all top\nvelocity top set 0 0 0\n"
              "fix move free sph/solid\ntimestep 8e-8\ncompute e all sph/solid/energy\n"
              "thermo_style custom step c_e\n";
    Session s;
    s(b.script());
    s("run 20");
    const double before = s.value("c_e");
    s("fix let_go top sph/solid\nrun 20");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
  }
}

// by default delete_atoms gives IDs anew, which the Eulerian frame does not mind

TEST(NotContinuedRun, WithNewIdsKeepsTheEnergy)
{
  for (const std::string command : {"delete_atoms group far", "reset_atoms id sort yes"}) {
    SCOPED_TRACE(command);
    Session s;
    Block b = summed("eulerian");
    b.motion += FAR;
    s(b.script());
    s("run 20");
    const double before = s.value("c_e");
    s(command + "\nrun 20");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
  }
}

// between runs the stored energy is that of positions and velocities, whoever reads it

TEST(EnergyBetweenRuns, HasCaughtUp)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    SCOPED_TRACE(frame);
    Session s;
    s(summed(frame).script());
    const double initial = [&] {
      s("run 0");
      return s.value("c_e");
    }();
    s("run 20");
    EXPECT_NEAR(stored_energy(s), initial, 1.0e-12 * initial);
    // such a command throws the forces away
    s("write_data " + file("caught_up.data"));
    EXPECT_NEAR(s.value("c_e"), initial, 1.0e-12 * initial);
    s("run 20");
    EXPECT_NEAR(stored_energy(s), initial, 1.0e-12 * initial);
  }
}

// a restart file that is written during a run has it, too

TEST(EnergyOfARestartFile, HasCaughtUp)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    SCOPED_TRACE(frame);
    const std::string path = file("during");
    double before = 0.0;
    {
      Session s;
      s(summed(frame).script());
      s("restart 20 " + path + ".*\nrun 30");
      before = s.value("c_e");
    }
    Session s;
    s("read_restart " + path + ".20\n" + NEIGHBOR + MOVE +
      "compute e all sph/solid/energy\nthermo_style custom step c_e\n"
      "velocity all set 0 0 0 sum yes units box\ngroup one id 20\nset group one sph/rho 7850");
    EXPECT_NEAR(stored_energy(s), before, 1.0e-12 * before);
    s("run 0");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before);
  }
}

// "pre no" goes on with what such commands have thrown away

TEST(RunWithoutSetup, AfterAWrittenFileIsRefused)
{
  for (const char *frame : {"lagrangian", "eulerian"}) {
    SCOPED_TRACE(frame);
    Block b = body();
    b.frame = frame;
    Session s;
    s(b.script());
    s("run 20\nwrite_restart " + file("pre_no.restart"));
    EXPECT_THAT(s.error("run 20 pre no"), HasSubstr("A run with 'pre no' needs the forces"));
  }
}

// no heat is left for the end of a fix, whose pair style may be another one by then

TEST(EndOfAFix, AfterAnotherPairStyleIsQuiet)
{
  Session s;
  s(body().script());
  s("run 20\npair_style zero 1.0e-3\nunfix move\npair_style none");
}

// another mass is another energy, which stays what it is from then on

TEST(NotContinuedRun, AfterAnotherMassKeepsTheEnergy)
{
  Session s;
  s(summed("lagrangian").script());
  s("run 20\nset atom 20 mass 0.006\nrun 0");
  const double before = s.value("c_e");
  s("run 20");
  EXPECT_NEAR(s.value("c_e"), before, 1.0e-8 * before);
}

}    // namespace
