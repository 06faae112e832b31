/* ----------------------------------------------------------------------
   Commands between two runs: what partners in the Lagrangian frame rely on cannot change behind
   their back, and a run that does not continue the last one loses no energy and no momentum.
------------------------------------------------------------------------- */

#include "answers.h"
#include "lagrangian_block.h"

using namespace sphsolid_test;

namespace {

struct Momentum {
  double x, y, size;    // the two components, and what they would be without signs
};

Momentum momentum(const State &state, int first = 1, int last = 1 << 30)
{
  Momentum sum = {0.0, 0.0, 0.0};
  for (const Particle &p : state) {
    if (p.id < first || p.id > last) continue;
    sum.x += p.mass * p.v[0];
    sum.y += p.mass * p.v[1];
    sum.size += p.mass * std::hypot(p.v[0], p.v[1]);
  }
  return sum;
}

void expect_same(const Momentum &a, const Momentum &b)
{
  EXPECT_GT(a.size, 0.0);
  EXPECT_NEAR(a.x, b.x, 1.0e-12 * a.size);
  EXPECT_NEAR(a.y, b.y, 1.0e-12 * a.size);
}

/* ----------------------------------------------------------------------
   IDs
------------------------------------------------------------------------- */

// the default of delete_atoms gives the IDs anew

TEST(ChangedIds, OfDeleteAtomsAreRefused)
{
  Session s;
  s(body().script());
  s("run 20\ngroup gone id 15\ndelete_atoms group gone");
  EXPECT_THAT(s.error("run 1"),
              AllOf(HasSubstr("expected IDs that stay"), HasSubstr("compress no")));
}

// in the first session the partners forbid it, after a restart they are not there yet

TEST(ChangedIds, OfResetAtomsAfterARestartAreRefused)
{
  const std::string path = file("gap.restart");
  {
    Session s;
    s(body().script());
    s("run 20\ngroup gone id 15\ndelete_atoms group gone compress no\nwrite_restart " + path);
  }
  Session s;
  s("read_restart " + path + "\nreset_atoms id\n" + NEIGHBOR + MOVE);
  EXPECT_THAT(s.error("run 1"), HasSubstr("expected IDs that stay"));
}

// one inside, one on a corner, and the one with the highest ID

class DeletedParticle : public testing::TestWithParam<int> {};

TEST_P(DeletedParticle, LeavesTheMomentumOfTheOthers)
{
  Session s;
  s(body().script());
  s("compute n all sph/solid/atom neigh\nrun 20\ngroup gone id " + std::to_string(GetParam()) +
    "\ndelete_atoms group gone compress no");
  const Momentum before = momentum(s.state());
  s("run 60");
  EXPECT_THAT(s.log(), HasSubstr("sph/solid: 1 particles are gone"));
  const State after = s.state();
  ASSERT_EQ(after.size(), 47u);
  expect_same(before, momentum(after));
  double forces = 0.0;
  for (const Particle &p : after) forces = std::max(forces, std::fabs(p.f[1]));
  EXPECT_GT(forces, 1.0e4);    // of particles that still hold together: 10 MPa x 1 mm
}

INSTANTIATE_TEST_SUITE_P(Ids, DeletedParticle, testing::Values(15, 1, 48), [](const auto &info) {
  return "id" + std::to_string(info.param);
});

// the last row is deleted, and a new one gets its IDs and its place

State after_deleting_the_last_row(const std::string &more,
                                  std::map<int, double> *neighbors = nullptr)
{
  Block b = body();
  b.fixes = "fix move all sph/solid\ntimestep 3e-8\n";
  Session s;
  s(b.script());
  s("compute n all sph/solid/atom neigh\nrun 20\ngroup gone id 43:48\n"
    "delete_atoms group gone compress no\n" +
    more + "run 0");
  if (neighbors) *neighbors = s.per_atom("n");
  s("run 40");
  return s.state();
}

const std::string NEW_ROW =
    "region row block -0.1 5.1 6.9 7.1 -0.1 0.1\ncreate_atoms 1 region row\n"
    "group row id 43:48\nset group row volume 1e-6\n"
    "velocity row set 50 -50 0 units box\n";

TEST(ReusedIds, AreOfANewBody)
{
  std::map<int, double> neighbors;
  const State with = after_deleting_the_last_row(NEW_ROW, &neighbors);
  const State without = after_deleting_the_last_row("");
  ASSERT_EQ(with.size(), 48u);
  ASSERT_EQ(without.size(), 42u);

  // h = 1.3 spacings: a row of six sees two to each side, and nothing of the body below
  const int in_a_row[6] = {2, 3, 4, 4, 3, 2};
  for (int k = 0; k < 6; k++) EXPECT_EQ(neighbors[43 + k], in_a_row[k]);

  // nothing of the row acts on the body, and nothing of the body on the row
  EXPECT_LT(largest_difference(State(with.begin(), with.begin() + 42), without), 1.0e-13);
  const double each = RHO0 * 1.0e-6 * 50.0;
  expect_same(momentum(with, 43, 48), {6.0 * each, -6.0 * each, 6.0 * std::sqrt(2.0) * each});
}

// the row of particles whose IDs have been those of others begins without the heat of those

TEST(ReusedIds, AreBornCold)
{
  const State state = after_deleting_the_last_row(NEW_ROW);
  for (int i = 42; i < 48; i++) {
    EXPECT_EQ(state[i].e, 0.0);
    EXPECT_EQ(state[i].v[0], 50.0);
    EXPECT_EQ(state[i].v[1], -50.0);
  }
}

/* ----------------------------------------------------------------------
   smoothing length
------------------------------------------------------------------------- */

std::string interaction_with(double h)
{
  Block b = body();
  b.h = h;
  return b.interaction();
}

const char OTHER_H[] = "the smoothing length of type 1 is 0.00145 and was 0.0013 in the reference";

TEST(ChangedSmoothingLength, IsRefused)
{
  Session s;
  s(body().script());
  s("run 20\n" + interaction_with(1.45e-3));
  EXPECT_THAT(s.error("run 1"), HasSubstr(OTHER_H));
}

TEST(ChangedSmoothingLength, IsRefusedAfterARestart)
{
  const std::string path = file("h.restart");
  {
    Session s;
    s(body().script());
    s("run 20\nwrite_restart " + path);
  }
  Session s;
  s("read_restart " + path + "\n" + interaction_with(1.45e-3) + MOVE);
  EXPECT_THAT(s.error("run 1"), HasSubstr(OTHER_H));
}

// of particles that get another type

const std::string TWO_TYPES = "pair_style sph/solid 1.3e-3 frame lagrangian\n"
                              "pair_coeff 1 1 " +
    std::string(IRON) + "pair_coeff 2 2 inline h " + "1.45e-3 " + std::string(IRON).substr(7);

std::string with_two_types()
{
  std::string script = body().script();
  const std::string box = "create_box 1 box", pair = body().interaction();
  script.replace(script.find(box), box.size(), "create_box 2 box");
  script.replace(script.find(pair), pair.size(), TWO_TYPES + NEIGHBOR);
  return script;
}

const char H_OF_TYPE_2[] = "the smoothing length of type 2 is 0.00145 and was 0.0013 in the "
                           "reference of its particle 20";

TEST(ChangedType, OfAnotherSmoothingLengthIsRefused)
{
  Session s;
  s(with_two_types());
  s("run 20\nset atom 20 type 2");
  EXPECT_THAT(s.error("run 1"), HasSubstr(H_OF_TYPE_2));
  s("set atom 20 type 1\nrun 1\nset atom 20 type 2\nfix_modify move reference renew\nrun 1");
}

TEST(ChangedType, OfAnotherSmoothingLengthIsRefusedAfterARestart)
{
  const std::string path = file("type.restart");
  {
    Session s;
    s(with_two_types());
    s("run 20\nset atom 20 type 2\nwrite_restart " + path);
  }
  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + MOVE);
  EXPECT_THAT(s.error("run 1"), HasSubstr(H_OF_TYPE_2));
}

TEST(ChangedType, OfTheSameSmoothingLengthRuns)
{
  Session s;
  s(with_two_types());
  s("run 20\nset atom 20 type 2\npair_coeff 2 2 " + std::string(IRON) + "run 20");
  EXPECT_EQ(s.value("step"), 40.0);
}

TEST(ChangedSmoothingLength, IsTakenWithANewReference)
{
  for (const bool renew_first : {false, true}) {
    const std::string h = interaction_with(1.45e-3), renew = "fix_modify move reference renew\n";
    Session s;
    s(body().script());
    s("compute n all sph/solid/atom neigh\nrun 1");
    EXPECT_EQ(s.per_atom("n")[1], 7.0);    // a corner: others of 3 x 3, without the far corner
    s((renew_first ? renew + h : h + renew) + "run 1");
    EXPECT_EQ(s.per_atom("n")[1], 8.0);    // with it: 2.83 spacings away, the kernel ends at 2.9
    s("run 20");
  }
}

// a reference that is renewed in the step in which it has been made: its partners are found by a
// neighbor list of that step, in bins of another size

class NewReferenceInTheSameStep : public testing::TestWithParam<Case> {};

TEST_P(NewReferenceInTheSameStep, FindsAllPartners)
{
  Session s;
  s(body().script());
  s("compute n all sph/solid/atom neigh\nrun 0");
  const std::map<int, double> before = s.per_atom("n");
  s("fix_modify move reference renew\n" + GetParam().input + "\nrun 0");
  EXPECT_EQ(before, s.per_atom("n"));
}

INSTANTIATE_TEST_SUITE_P(
    After, NewReferenceInTheSameStep,
    testing::Values(Case{"Nothing", "", ""}, Case{"AnotherSkin", "neighbor 0.002 bin", ""},
                    Case{"ASmallSkin", "neighbor 0.00001 bin", ""},
                    Case{"AnotherBox", "change_box all x final -0.0401 0.0489 units box", ""},
                    Case{"ALittleMoreH", interaction_with(1.35e-3), ""}),
    name_of);

TEST(NewReference, BeforeTheFirstRunChangesNothing)
{
  expect_bitwise(run(body(), "run 40"), run(body(), "fix_modify move reference renew\nrun 40"));
}

TEST(NewReference, AfterARestartIsThatOfTheSamePlaces)
{
  const std::string path = file("renew.restart");
  State straight;
  {
    Session s;
    s(body().script());
    s("run 20\nwrite_restart " + path + "\nrun 0\nfix_modify move reference renew\nrun 0");
    straight = s.state();
  }
  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + MOVE + "fix_modify move reference renew\nrun 0");
  const State after = s.state();
  ASSERT_EQ(after.size(), straight.size());
  for (std::size_t i = 0; i < after.size(); i++)
    for (int k = 0; k < 3; k++) {
      EXPECT_EQ(after[i].x[k], straight[i].x[k]);
      EXPECT_EQ(after[i].v[k], straight[i].v[k]);
    }
}

TEST(SamePairStyleCommand, BetweenRunsChangesNothing)
{
  Session s;
  s(body().script());
  s("run 20\n" + body().interaction() + "run 20");
  expect_bitwise(run(body(), "run 40"), s.state());
}

TEST(SamePairStyleCommand, AfterARestartChangesNothing)
{
  const std::string path = file("same.restart");
  {
    Session s;
    s(body().script());
    s("run 20\nwrite_restart " + path);
  }
  Session s;
  s("read_restart " + path + "\n" + body().interaction() + MOVE + "run 20");
  expect_bitwise(run(body(), "run 40"), s.state());
}

/* ----------------------------------------------------------------------
   the pair style goes away, or what it keeps
------------------------------------------------------------------------- */

const char ZERO[] = "pair_style zero 0.003\npair_coeff * *\n";
const std::string ENERGIES = "compute e all sph/solid/energy\ncompute p all sph/solid/atom p e\n"
                             "compute sum all reduce sum c_p[1]\n";

TEST(PairStyleThatIsGone, LeavesTimestepAlone)
{
  Block b = body();
  b.fixes += "fix floor all sph/solid/wall ylo 0\n";
  for (const std::string &next : {std::string(ZERO), ZERO + b.interaction()}) {
    Session s;
    s(b.script());
    s("run 20\n" + next + "timestep 1e-9");
    EXPECT_EQ(s.value("dt"), 1.0e-9);
  }
}

TEST(PairStyleThatIsGone, HasNoEnergies)
{
  for (const std::string &next : {std::string(ZERO), ZERO + body().interaction()}) {
    Session s;
    s(body().script());
    s(ENERGIES + "run 20\n" + next);
    EXPECT_THAT(s.error("print $(c_e)"),
                HasSubstr("Compute sph/solid/energy needs pair style sph/solid as a run has set it "
                          "up"));
    EXPECT_THAT(s.error("print $(c_sum)"),
                HasSubstr("Compute sph/solid/atom needs pair style sph/solid as a run has set it "
                          "up"));
  }
}

TEST(PairStyleThatIsGone, AndComesBackHasEnergies)
{
  Session s;
  s(body().script());
  s(ENERGIES + "run 20");
  const double before = s.value("c_sum");
  s(ZERO + body().interaction() + "run 0");
  EXPECT_NEAR(s.value("c_sum"), before, 1.0e-6 * std::fabs(before));
}

const char GONE[] = "fix SPHSOLID_PARTNERS has been deleted: expected it to stay";

TEST(DeletedPartners, StopTheNextRun)
{
  for (const std::string command :
       {"run 1", "run 1 pre no", "fix_modify move reference renew", "write_restart no.restart"}) {
    Session s;
    s(body().script());
    s("run 20\nunfix SPHSOLID_PARTNERS");
    EXPECT_THAT(s.error(command), HasSubstr(GONE)) << command;
  }
}

TEST(DeletedPartners, StopTheComputes)
{
  Session s;
  s(body().script());
  s(ENERGIES + "run 20\nunfix SPHSOLID_PARTNERS");
  EXPECT_THAT(s.error("print $(c_e)"), HasSubstr(GONE));
}

TEST(DeletedPartners, AreNotMissedInTheOtherFrame)
{
  Block other = body();
  other.frame = "eulerian";
  Session s;
  s(body().script());
  s("run 20\nunfix SPHSOLID_PARTNERS\n" + other.interaction() + "run 1\n" + body().interaction() +
    "run 1");
  EXPECT_EQ(s.value("step"), 22.0);
}

/* ----------------------------------------------------------------------
   box
------------------------------------------------------------------------- */

Block bar()
{
  Block b = body();
  b.boundary = "p f";
  b.box = "0 0.012 -0.04 0.04";
  b.nx = 12;
  b.ny = 5;
  b.motion = "variable vy atom 2e4*(y-0.002)\nvelocity all set 10 v_vy 0 units box\n";
  return b;
}

class ChangedBox : public testing::TestWithParam<Case> {};

TEST_P(ChangedBox, IsRefused)
{
  Session s;
  s(bar().script());
  s("run 20\n" + GetParam().input);
  EXPECT_THAT(s.error("run 1"), HasSubstr(GetParam().message));
}

// LAMMPS itself refuses to change the box before the file has been used up

TEST_P(ChangedBox, IsRefusedAfterARestart)
{
  const std::string path = file("box.restart");
  {
    Session s;
    s(bar().script());
    s("run 20\nwrite_restart " + path);
  }
  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + MOVE + "run 0\n" + GetParam().input);
  EXPECT_THAT(s.error("run 1"), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Commands, ChangedBox,
    testing::Values(Case{"Longer", "change_box all x final 0 0.0125 units box",
                         "the length of the box along x (0: not periodic) is 0.0125 and was 0.012"},
                    Case{"Remapped", "change_box all x scale 0.99 remap",
                         "the length of the box along x (0: not periodic) is 0.01188 and was "},
                    Case{"NotPeriodicAnyMore", "change_box all boundary f f p",
                         "the length of the box along x (0: not periodic) is 0 and was 0.012"}),
    name_of);

TEST(ChangedBoxAcrossFreeFaces, ChangesNothing)
{
  Session s;
  s(bar().script());
  s("run 20\nchange_box all y final -0.05 0.06 units box\nrun 20");
  expect_bitwise(run(bar(), "run 40"), s.state());
}

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
