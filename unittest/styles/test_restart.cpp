/* ----------------------------------------------------------------------
   Stopping, restarting and writing data files: what continues bit for bit,
   and what a data file keeps.
------------------------------------------------------------------------- */

#include "session.h"

using namespace sphsolid_test;

namespace {

const std::string FIXES = "fix move all sph/solid\nfix step all sph/solid/dt 10 0.3\n"
                          "fix floor all sph/solid/wall ylo 0.0 contact\n";

// a rod that hits the wall in the first half of the run

std::string rod(const std::string &options = "")
{
  Block b;
  b.nx = 8;
  b.ny = 12;
  b.options = options;
  b.fixes = FIXES;
  return b.script();
}

State straight(int steps, const std::string &options = "")
{
  Session s;
  s(rod(options));
  s("run " + std::to_string(steps));
  return s.state();
}

/* ---------------------------------------------------------------------- */

TEST(Runs, InTwoPartsEqualOne)
{
  Session s;
  s(rod());
  s("run 100\nrun 100");
  expect_bitwise(straight(200), s.state());
}

TEST(Runs, InManyPartsEqualOne)
{
  Session s;
  s(rod());
  for (const char *n : {"1", "2", "37", "60"}) s(std::string("run ") + n);
  expect_bitwise(straight(100), s.state());
}

TEST(Runs, OfZeroStepsBeforeChangeNothing)
{
  Session s;
  s(rod());
  s("run 0\nrun 100");
  expect_bitwise(straight(100), s.state());
}

TEST(Runs, OfZeroStepsBetweenChangeNothing)
{
  Session s;
  s(rod());
  s("run 50\nrun 0\nrun 50");
  expect_bitwise(straight(100), s.state());
}

TEST(Runs, WithoutSetupEqualOne)
{
  Session s;
  s(rod());
  s("run 50 post no\nrun 50 pre no");
  expect_bitwise(straight(100), s.state());
}

TEST(Runs, OutputChangesNothing)
{
  Session s;
  s(rod());
  s("compute e all sph/solid/energy\ncompute a all sph/solid/atom e p vonmises\n"
    "thermo_style custom step c_e press\nthermo 1\n"
    "dump d all custom 1 " +
    file("dump") + " id c_a[*]\nrun 100");
  expect_bitwise(straight(100), s.state());
}

TEST(Runs, SortingOfAtomsChangesNothing)
{
  Session s;
  s(rod());
  s("atom_modify sort 7 0.002\nrun 100");
  expect_bitwise(straight(100), s.state());
}

TEST(Runs, NewVelocitiesBetweenThemCount)
{
  Session s;
  s(rod());
  s("run 50\nvelocity all set 0 500 0 units box\nrun 1");
  EXPECT_GT(s.particle(96).v[1], 400.0);
}

/* ----------------------------------------------------------------------
   restart files
------------------------------------------------------------------------- */

class Restart : public testing::TestWithParam<std::string> {};

TEST_P(Restart, WrittenAfterARunContinuesBitwise)
{
  const std::string path = file("after.restart");
  {
    Session s;
    s(rod(GetParam()));
    s("run 100\nwrite_restart " + path);
  }
  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + FIXES + "run 100");
  expect_bitwise(straight(200, GetParam()), s.state());
}

INSTANTIATE_TEST_SUITE_P(
    Options, Restart,
    testing::Values("", "viscosity none", "viscosity monaghan 1 2 gradient plain",
                    "viscosity correct heating printed weights shepard hbar 1.2 alpha 0.5 2",
                    "tensile artificial 0.3 4"),
    [](const auto &info) {
      const std::string words = info.param;
      const std::string only = words.find("plain") < words.size() ? "Plain"
          : words.find("tensile") < words.size()                  ? "Tensile"
                                                                  : "";
      return "set" + std::to_string(info.index) + only;
    });

TEST(Restart, WrittenWhileRunningContinuesBitwise)
{
  const std::string path = file("running.restart");
  {
    Session s;
    s(rod());
    s("restart 70 " + path + ".*\nrun 140");
  }
  Session s;
  s("read_restart " + path + ".70\n" + NEIGHBOR + FIXES + "run 70");
  expect_bitwise(straight(140), s.state());
}

TEST(Restart, OfARunWithSortedAtomsContinuesBitwise)
{
  const std::string path = file("sorted.restart");
  {
    Session s;
    s(rod());
    s("atom_modify sort 11 0.002\nrun 100\nwrite_restart " + path);
  }
  Session s;
  s("read_restart " + path + "\natom_modify sort 13 0.002\n" + NEIGHBOR + FIXES + "run 100");
  expect_bitwise(straight(200), s.state());
}

TEST(Restart, BeforeTheFirstStepContinuesBitwise)
{
  const std::string path = file("first.restart");
  {
    Session s;
    s(rod());
    s("write_restart " + path);
  }
  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + FIXES + "run 100");
  expect_bitwise(straight(100), s.state());
}

TEST(Restart, KeepsTimeAndTimeStep)
{
  const std::string path = file("time.restart");
  double time, dt;
  {
    Session s;
    s(rod());
    s("run 100\nwrite_restart " + path);
    time = s.value("time");
    dt = s.value("dt");
  }
  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + FIXES + "run 0");
  EXPECT_EQ(s.value("time"), time);
  EXPECT_EQ(s.value("dt"), dt);
}

// the energy book is a set of sums in another order: rounding only

TEST(Restart, KeepsTheEnergyBook)
{
  const std::string path = file("book.restart"), energy = "compute e all sph/solid/energy\n";
  double before[7];
  Session first;
  first(rod() + energy);
  first("run 100\nwrite_restart " + path + "\nrun 50");
  for (int k = 0; k < 7; k++) before[k] = first.value("c_e[" + std::to_string(k + 1) + "]");
  const double total = first.value("c_e");

  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + FIXES + energy + "run 50");
  for (int k = 0; k < 7; k++)
    EXPECT_NEAR(s.value("c_e[" + std::to_string(k + 1) + "]"), before[k], 1.0e-12 * total) << k;
}

TEST(Restart, GoesOnWithAnotherPairStyleCommand)
{
  const std::string path = file("other.restart");
  {
    Session s;
    s(rod());
    s("run 50\nwrite_restart " + path);
  }
  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + "pair_style sph/solid 1.3e-3 frame " +
    frame_under_test() + " viscosity monaghan 1 1\npair_coeff * * " + IRON + FIXES + "run 10");
  EXPECT_EQ(s.value("step"), 60.0);
}

// a fix that asks for energies while the run begins, before the wall has pushed

TEST(Restart, WithAnAverageBeforeTheWallContinuesBitwise)
{
  const std::string path = file("average.restart"), energy = "compute e all sph/solid/energy\n",
                    average = "fix average all ave/time 1 1 1 c_e\n", wall = "fix floor";
  std::string fixes = FIXES;
  fixes.insert(fixes.find(wall), energy + average);
  Session straight;
  straight(rod() + energy + "run 60\nwrite_restart " + path + "\nrun 20");
  Session s;
  s("read_restart " + path + "\n" + NEIGHBOR + fixes + "run 20");
  expect_bitwise(straight.state(), s.state());
}

// a wall of the same name at another place is another wall: nobody may be behind it

TEST(Restart, WithAWallElsewhereIsChecked)
{
  const std::string path = file("wall.restart");
  {
    Session s;
    s(rod());
    s("run 5\nwrite_restart " + path);
  }
  for (const char *wall : {"ylo 0.004", "yhi 0.004"}) {
    Session s;
    s("read_restart " + path + "\n" + NEIGHBOR + MOVE + "fix floor all sph/solid/wall " + wall);
    EXPECT_THAT(s.error("run 1"), HasSubstr("lies behind the wall at 0.004"));
  }
}

// the smoothing length is the first of the settings, behind the number of their layout and two sizes

TEST(Restart, OfAnotherVersionIsRefused)
{
  const std::string path = file("version.restart");
  {
    Session s;
    s(rod());
    s("run 1\nwrite_restart " + path);
  }
  std::string content = read_file(path);
  const double h = 1.3e-3;
  const auto at = content.find(std::string(reinterpret_cast<const char *>(&h), sizeof(h)));
  ASSERT_NE(at, std::string::npos);
  for (const int of : {12, 8, 4}) {
    content[at - of]++;
    Session s;
    EXPECT_THAT(s.error("read_restart " + write_file("other_version.restart", content)),
                HasSubstr("Pair style sph/solid: the settings in the restart file have layout 4"));
  }
}

/* ----------------------------------------------------------------------
   data files: everything but the stress and the plastic strain
------------------------------------------------------------------------- */

TEST(DataFile, KeepsWhatItsColumnsHold)
{
  const std::string path = file("data");
  State before;
  {
    Session s;
    s(rod());
    s("run 50\nwrite_data " + path);
    before = s.state();
  }
  Session s;
  s("units si\ndimension 2\nboundary f f p\natom_style sph/solid\nread_data " + path);
  const State after = s.state();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); i++) {
    const Particle &a = after[i], &b = before[i];
    for (int k = 0; k < 3; k++) {
      EXPECT_DOUBLE_EQ(a.x[k], b.x[k]);
      EXPECT_DOUBLE_EQ(a.v[k], b.v[k]);
    }
    EXPECT_DOUBLE_EQ(a.mass, b.mass);
    EXPECT_DOUBLE_EQ(a.rho, b.rho);
    EXPECT_DOUBLE_EQ(a.e, b.e);
  }
  for (int i = 0; i < s.lmp->atom->nlocal; i++) EXPECT_DOUBLE_EQ(s.lmp->atom->vfrac[i], 1.0e-6);
}

TEST(DataFile, ForgetsStressAndPlasticStrain)
{
  const std::string path = file("data");
  {
    Session s;
    s(rod());
    s("run 50\nwrite_data " + path);
  }
  Session s;
  s("units si\ndimension 2\nboundary f f p\natom_style sph/solid\nread_data " + path);
  for (const Particle &p : s.state()) {
    for (double component : p.stress) EXPECT_EQ(component, 0.0);
    EXPECT_EQ(p.epl, 0.0);
  }
}

TEST(DataFile, RunsOn)
{
  const std::string path = file("data");
  {
    Session s;
    s(rod());
    s("write_data " + path);
  }
  Session s;
  s("units si\ndimension 2\nboundary f f p\natom_style sph/solid\nread_data " + path +
    "\npair_style sph/solid 1.3e-3 frame " + frame_under_test() + "\npair_coeff * * " + IRON +
    NEIGHBOR + FIXES + "run 50");
  EXPECT_LT(largest_difference(straight(50), s.state()), 1.0e-12);
}

class DataFileRefuses : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(DataFileRefuses, NegativeValues)
{
  const std::string path = write_file("data",
                                      "bad\n\n1 atoms\n1 atom types\n\n0 1 xlo xhi\n0 1 ylo yhi\n"
                                      "-0.5 0.5 zlo zhi\n\nAtoms # sph/solid\n\n" +
                                          GetParam().first + "\n");
  Session s;
  s("units si\ndimension 2\nboundary f f p\natom_style sph/solid");
  EXPECT_THAT(s.error("read_data " + path), HasSubstr(GetParam().second));
}

INSTANTIATE_TEST_SUITE_P(
    Column, DataFileRefuses,
    testing::Values(std::make_pair("1 1 -2 1 1 0 0.5 0.5 0",
                                   "Atom 1 has volume -2 in data file: expected a value >= 0"),
                    std::make_pair("1 1 1 -2 1 0 0.5 0.5 0",
                                   "Atom 1 has mass -2 in data file: expected a value >= 0"),
                    std::make_pair("1 1 1 1 -2 0 0.5 0.5 0",
                                   "Atom 1 has density -2 in data file: expected a value >= 0")),
    [](const auto &info) {
      return "set" + std::to_string(info.index);
    });

}    // namespace
