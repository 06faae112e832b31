/* ----------------------------------------------------------------------
   Commands between two runs: what partners in the Lagrangian frame rely on cannot change behind
   their back.
------------------------------------------------------------------------- */

#include "between_runs.h"

using namespace sphsolid_test;

namespace {

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
  Block b = body();
  b.types = 2;
  std::string script = b.script();
  const std::string pair = b.interaction();
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

// the same pair style made anew, as every pair_style hybrid does, or after another one

TEST(PairStyleAgain, InAHybridChangesNothing)
{
  const std::string hybrid = "pair_style hybrid sph/solid 1.3e-3 frame lagrangian\n"
                             "pair_coeff * * sph/solid " +
      std::string(IRON),
                    plain = interaction_with(1.3e-3),
                    energy = "compute e all sph/solid/energy\n"
                             "thermo_style custom step c_e[5]\n";
  auto state = [&](const std::string &again, double &plastic_work) {
    Session s;
    s(body().script());
    s(energy + hybrid + "run 20\n" + again + "run 20");
    plastic_work = s.value("c_e[5]");
    return s.state();
  };
  double expected, work;
  const State reference = state("", expected);
  EXPECT_GT(expected, 0.0);
  for (const std::string &again : {hybrid, plain, "pair_style zero 2e-3\npair_coeff * *\n" + hybrid,
                                   "pair_style none\n" + hybrid}) {
    expect_bitwise(reference, state(again, work));
    EXPECT_EQ(work, expected);
  }
}

// partners are all within 1.98 h = 2.574 mm, and a correction that reaches 3 mm would miss some

TEST(ChangedCorrection, ThatReachesBeyondThePartnersIsRefused)
{
  const std::string wide = "pair_style sph/solid 1.3e-3 frame lagrangian viscosity correct hbar 3\n"
                           "pair_coeff * * " +
      std::string(IRON),
                    message = "particles of type 1 reach their partners at 0.003 and those of the "
                              "reference lie within 0.002574",
                    path = file("reach.restart");
  {
    Session s;
    s(body().script());
    s("run 1\nwrite_restart " + path + "\n" + wide);
    EXPECT_THAT(s.error("run 1"), HasSubstr(message));
    s("fix_modify move reference renew\nrun 1");
  }
  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + MOVE + wide);
  EXPECT_THAT(s.error("run 1"), HasSubstr(message));
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

// it does not matter that the pair style is new, or has come with a restart file

TEST(ChangedSmoothingLength, IsTakenWithANewReferenceOfAnOlderPairStyle)
{
  const std::string renew = "fix_modify move reference renew\n", path = file("renewed.restart");
  {
    Session s;
    s(body().script());
    s("run 1\nwrite_restart " + path + "\npair_style none\n" + interaction_with(1.45e-3) + renew +
      "run 1");
  }
  Session s;
  s("read_restart " + path + "\n" + interaction_with(1.45e-3) + MOVE + renew + "run 1");
}

// particles that are new have the partners of their time

TEST(ChangedCorrection, OfATypeThatHasNoPartnersYet)
{
  std::string script = with_two_types();
  Session s;
  s(script +
    "run 1\nlattice sq 0.002\nregion other block 5 7.1 5 7.1 INF INF\n"
    "create_atoms 2 region other\nset type 2 volume 4e-6\nrun 1");
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

}    // namespace
