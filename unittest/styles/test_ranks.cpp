/* ----------------------------------------------------------------------
   The number of ranks, newton on or off, load balancing and threads do not
   change a bit: sums run in the order of atom IDs.

   Started by mpiexec; the reference is a run of the first rank alone.
------------------------------------------------------------------------- */

#include "ranks.h"

using namespace sphsolid_test;

namespace {

// the box follows the body from the start, so that rank boundaries go through it.
// create_atoms numbers the atoms rank by rank: the IDs are made anew, by position

Block rod()
{
  Block b;
  b.boundary = "s s";
  b.box = "-0.001 0.012 -0.001 0.02";
  b.options = "viscosity correct gradient corrected";
  b.motion = "reset_atoms id sort yes\n" + b.motion;
  b.fixes += "fix floor all sph/solid/wall ylo 0.0\n";
  return b;
}

Block block3d()
{
  Block b = rod();
  b.nx = 6;
  b.ny = 7;
  b.nz = 5;
  b.box = "-0.001 0.006 -0.001 0.007";
  b.first = "processors * * 1\n";    // the box is high, the body is not
  return b;
}

// a rank that waits keeps its core busy: short runs where there are more
// ranks than cores.  What differs at all differs in the first steps

std::string run()
{
  return ranks() > 2 ? "run 20\n" : "run 60\n";
}

std::string newton(Block b, const std::string &flag)
{
  b.first += "newton " + flag + "\n";
  return b.script();
}

/* ---------------------------------------------------------------------- */

class Ranks : public testing::TestWithParam<std::string> {};

TEST_P(Ranks, DoNotChangeARod)
{
  expect_bitwise(alone(newton(rod(), "off") + run()), together(newton(rod(), GetParam()) + run()));
}

// long enough for the foot to spread and particles to change their rank

TEST(Ranks, DoNotChangeALongRun)
{
  const std::string longer = (run() == "run 60\n") ? "run 200\n" : run();
  expect_bitwise(alone(rod().script() + longer), together(rod().script() + longer));
}

TEST_P(Ranks, DoNotChangeABlockIn3d)
{
  expect_bitwise(alone(newton(block3d(), "off") + run()),
                 together(newton(block3d(), GetParam()) + run()));
}

TEST_P(Ranks, DoNotChangeMonaghansViscosity)
{
  Block b = rod();
  b.options = "viscosity monaghan 1 1";
  if (b.frame == "eulerian") b.options += " gradient plain tensile artificial 0.3 4";
  expect_bitwise(alone(newton(b, "off") + run()), together(newton(b, GetParam()) + run()));
}

TEST_P(Ranks, DoNotChangeAQuarterModel)
{
  Block b = rod();
  b.fixes = MOVE +
      "fix left all sph/solid/wall xlo -0.0005 symmetry\n"
      "fix floor all sph/solid/wall ylo -0.0005 symmetry\n";
  expect_bitwise(alone(newton(b, "off") + run()), together(newton(b, GetParam()) + run()));
}

INSTANTIATE_TEST_SUITE_P(Newton, Ranks, testing::Values("on", "off"), [](const auto &info) {
  return info.param;
});

/* ---------------------------------------------------------------------- */

TEST(Ranks, InOneColumnGiveTheSame)
{
  Block b = rod();
  const std::string reference = b.script() + run();
  b.first = "processors 1 * 1\n";
  expect_bitwise(alone(reference), together(b.script() + run()));
}

// this balancer converts positions to fractions of the box and back

TEST(Ranks, BalancedDuringTheRunGiveTheSameToRounding)
{
  const std::string balance = "fix balance all balance 10 1.0 shift xy 10 1.0\n";
  EXPECT_LT(
      largest_difference(alone(rod().script() + run()), together(rod().script() + balance + run())),
      1.0e-12);
}

TEST(Ranks, InTilesGiveTheSame)
{
  const std::string tiles = "comm_style tiled\nfix balance all balance 10 1.0 rcb\n";
  expect_bitwise(alone(rod().script() + run()), together(rod().script() + tiles + run()));
}

TEST(Ranks, RareNeighborListsGiveTheSame)
{
  const std::string rare = "neighbor 0.001 bin\nneigh_modify every 10 delay 0 check yes\n";
  expect_bitwise(alone(rod().script() + run()), together(rod().script() + rare + run()));
}

TEST(Ranks, WithThreadsGiveTheSame)
{
  const State reference = alone(rod().script() + run());
  Session s;
  s(rod().script());
  s.lmp->comm->nthreads = 2;
  s(run());
  expect_bitwise(reference, s.state());
}

TEST(Ranks, AgreeOnTheEnergies)
{
  const std::string script = rod().script() + "compute e all sph/solid/energy\n" + run();
  double reference[8] = {};
  auto read = [](Session &s, double *out) {
    for (int k = 0; k < 7; k++) out[k] = s.value("c_e[" + std::to_string(k + 1) + "]");
    out[7] = s.value("c_e");
  };
  if (first_rank()) {
    Session s(MPI_COMM_SELF);
    s(script);
    read(s, reference);
  }
  share(reference, sizeof(reference));
  Session s;
  s(script);
  double here[8];
  read(s, here);
  for (int k = 0; k < 8; k++) EXPECT_NEAR(here[k], reference[k], 1.0e-12 * reference[7]) << k;
}

// between runs particles go to other ranks, and the heat of the last half kick with them

TEST(Ranks, LoseNoEnergyBetweenRuns)
{
  Session s;
  s(rod().script() + "compute e all sph/solid/energy\n" + run());
  const double before = s.value("c_e");
  for (const char *command : {"balance 1.0 shift xy 10 1.0", "set group all image 0 0 NULL",
                              "displace_atoms all move 0.002 0 0 units box"}) {
    s(std::string(command) + "\nrun 0");
    EXPECT_NEAR(s.value("c_e"), before, 1.0e-12 * before) << command;
  }
}

// a file written by one rank continues on all of them

TEST(Ranks, ContinueARestartFileOfOneRank)
{
  const std::string path = shared_file("restart.one");
  const State reference = alone(rod().script() + "run 30\nwrite_restart " + path + "\n" + run());
  expect_bitwise(reference,
                 together("read_restart " + path + "\n" + NEIGHBOR + rod().fixes + run()));
}

TEST(Ranks, WriteARestartFileThatOneRankContinues)
{
  const std::string path = shared_file("restart.all");
  together(rod().script() + "run 30\nwrite_restart " + path + "\n");
  expect_bitwise(alone(rod().script() + "run 30\n" + run()),
                 alone("read_restart " + path + "\n" + NEIGHBOR + rod().fixes + run()));
}

/* ----------------------------------------------------------------------
   what only the Lagrangian frame does: partners that are stretched beyond the
   ghost cutoff, and partners across a periodic boundary
------------------------------------------------------------------------- */

// the first rank tells what it found

std::string log_of(const Session &s)
{
  return first_rank() ? s.log() : "";
}

// a ribbon is pulled to twice its length.  A skin of a tenth of a spacing: ghosts
// reach little further than the kernel did in the reference

std::string ribbon()
{
  Block b;
  b.nx = 14;
  b.ny = 4;
  b.frame = "lagrangian";
  b.boundary = "s s";
  b.box = "-0.001 0.014 -0.001 0.004";
  b.first = "processors * 1 1\n";
  b.material = "inline rho0 7850 eos mie-gruneisen 3600 1.8 1.8 shear 80e9 strength linear 600e6 "
               "4e9\n";
  b.motion = "reset_atoms id sort yes\nneighbor 0.0001 bin\nvariable vx atom 1e5*(x-0.0065)\n"
             "velocity all set v_vx 0 0 units box\n";
  b.fixes = "fix move all sph/solid\nfix hold all setforce 0 NULL NULL\n"
            "fix step all sph/solid/dt 1 0.5\nvariable now equal time\n"
            "fix stop all halt 1 v_now >= 1e-5 error continue message no\n";
  return b.script();
}

TEST(RanksOfTheLagrangianFrame, FollowStretchedPartners)
{
  const State reference = alone(ribbon() + "run 5000\n");
  EXPECT_GT(reference.back().x[0] - reference.front().x[0], 2.0 * 13.0e-3);
  Session s;
  s(ribbon() + "run 5000\n");
  expect_bitwise(reference, s.state());
  if (first_rank()) {
    if (ranks() > 1)
      EXPECT_THAT(log_of(s), HasSubstr("sph/solid: ghost cutoff enlarged to "));
    else
      EXPECT_THAT(log_of(s), Not(HasSubstr("ghost cutoff")));
  }
}

// a restart file of one rank, which needs no ghosts, or a command has brought partners apart

TEST(RanksOfTheLagrangianFrame, ReachPartnersThatAreApartFromTheStart)
{
  const std::string path = shared_file("stretched.restart");
  const State reference =
      alone(ribbon() + "run 5000\nunfix stop\nwrite_restart " + path + "\nrun 5\n");
  const std::string fixes = "fix move all sph/solid\nfix hold all setforce 0 NULL NULL\n"
                            "fix step all sph/solid/dt 1 0.5\n";
  Session s;
  s("read_restart " + path + "\nneighbor 0.0001 bin\n" + fixes + "run 5\n");
  expect_bitwise(reference, s.state());
  if (first_rank() && ranks() > 1) {
    EXPECT_THAT(log_of(s), HasSubstr("sph/solid: ghost cutoff enlarged to "));
  }
}

TEST(RanksOfTheLagrangianFrame, ReachPartnersThatACommandHasMoved)
{
  const std::string script = ribbon() + "run 5\nvariable dx atom 1.5*(x-0.0065)\n" +
      "displace_atoms all move v_dx 0 0 units box\nrun 5\n";
  expect_bitwise(alone(script), together(script));
}

// stretched sideways and moving through the boundary

TEST(RanksOfTheLagrangianFrame, AgreeOnAPeriodicBar)
{
  Block b;
  b.nx = 12;
  b.ny = 5;
  b.frame = "lagrangian";
  b.boundary = "p f";
  b.box = "0 0.012 -0.04 0.04";
  b.first = "processors * 1 1\n";
  b.motion = "reset_atoms id sort yes\nvariable vy atom 2e4*(y-0.002)*(1+0.3*cos(2*PI*x/0.012))\n"
             "velocity all set 200 v_vy 0 units box\n";
  const State reference = alone(b.script() + "run 100\n"),
              here = together(b.script() + "run 100\n");
  EXPECT_LT(largest_difference(reference, here), 1.0e-12);
  EXPECT_GT(std::fabs(here[20].stress[0]), 1.0e7);
}

// bodies go across ranks, and across a periodic boundary; a fragment of one particle is no news

TEST(RanksOfTheLagrangianFrame, CountBodies)
{
  const std::string three_columns = "region gone block 4.5e-3 7.5e-3 INF INF INF INF units box\n",
                    three_rows = "region gone block INF INF 1.5e-3 3.5e-3 INF INF units box\n",
                    right = "region gone block 4.5e-3 INF INF INF INF INF units box\n",
                    fragment = "create_atoms 1 single 0.01 0.003 0 units box\ngroup last id 31\n"
                               "set group last volume 1e-6\n";
  struct {
    std::string gap, more, boundary, message;
  } const cases[] = {
      {three_columns, "", "s s", "the reference has 2 bodies, the largest of 36 and 30 particles"},
      {three_columns, "", "p s", ""},
      {three_rows, "", "s s", "the reference has 2 bodies, the largest of 28 and 28 particles"},
      {right, fragment, "s s", ""},
  };
  for (const auto &one : cases) {
    SCOPED_TRACE(one.gap + one.more + one.boundary);
    Block b;
    b.nx = 14;
    b.ny = 6;
    b.h = 0.9e-3;
    b.frame = "lagrangian";
    b.boundary = one.boundary;
    b.box = "-0.0005 0.0135 -0.001 0.006";
    b.first = "processors * 1 1\n";
    b.motion = one.gap + "delete_atoms region gone\nreset_atoms id sort yes\n" + one.more;
    Session s;
    s(b.script());
    s("run 0");
    if (!first_rank()) continue;
    if (one.message.empty())
      EXPECT_THAT(s.log(), Not(HasSubstr("the reference has")));
    else
      EXPECT_THAT(s.log(), HasSubstr(one.message));
  }
}

// two materials: that they are unlike is known to ranks that have one of them only

TEST(RanksOfTheLagrangianFrame, AgreeOnTwoMaterials)
{
  for (const char *options :
       {"viscosity correct hourglass 0.3", "viscosity monaghan 1 1 hourglass 0"}) {
    Block b;
    b.nx = 14;
    b.ny = 6;
    b.frame = "lagrangian";
    b.boundary = "s s";
    b.box = "-0.001 0.014 -0.001 0.006";
    b.first = "processors * 1 1\n";
    b.options = options;
    b.motion = "reset_atoms id sort yes\nregion right block 0.0095 INF INF INF INF INF units box\n"
               "set region right type 2\n"
               "pair_coeff 2 2 inline rho0 200 eos linear 1e9 shear 0.5e9 strength elastic\n"
               "variable vx atom -2e4*(x-0.0065)\nvelocity all set v_vx 0 0 units box\n";
    b.types = 2;
    const std::string script = b.script();
    expect_bitwise(alone(script + "run 60\n"), together(script + "run 60\n"));
  }
}

}    // namespace
