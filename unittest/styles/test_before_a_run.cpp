/* ----------------------------------------------------------------------
   What a user may have overlooked: a run warns of it or refuses to start, and says what to do.
------------------------------------------------------------------------- */

#include "lagrangian_block.h"

using namespace sphsolid_test;

namespace {

const std::vector<std::string> FRAMES = {"eulerian", "lagrangian"};

Block small(const std::string &frame)
{
  Block b = body();
  b.frame = frame;
  return b;
}

std::string log_of(const std::string &script)
{
  Session s;
  s(script);
  s("run 1");
  return s.log();
}

/* ----------------------------------------------------------------------
   warnings
------------------------------------------------------------------------- */

const char IDLE[] = "have a velocity and no fix moves them";

std::string clamped(const std::string &frame, const std::string &more)
{
  Block b = small(frame);
  b.motion += "region low block INF INF INF 1.5 INF INF\ngroup low region low\n"
              "group free subtract all low\n" +
      more;
  b.fixes = "fix move free sph/solid\nfix step all sph/solid/dt 1 0.3\n";
  return b.script();
}

TEST(WarnsBeforeARun, OfClampedParticlesWithAVelocity)
{
  for (const std::string &frame : FRAMES) {
    const std::string log = log_of(clamped(frame, "velocity low set 0 -200 0 units box\n"));
    EXPECT_THAT(log, HasSubstr(std::string("WARNING: sph/solid: 12 particles ") + IDLE)) << frame;
  }
}

TEST(WarnsBeforeARun, NotOfAClampAtRest)
{
  for (const std::string &frame : FRAMES)
    EXPECT_THAT(log_of(clamped(frame, "velocity low set 0 0 0\n")), Not(HasSubstr("WARNING")));
}

TEST(WarnsBeforeARun, NotOfVelocitiesThatAnotherFixActsOn)
{
  for (const std::string &frame : FRAMES) {
    Session s;
    s(clamped(frame, "velocity low set 0 -200 0 units box\n"));
    s("unfix step\ntimestep 1e-8\nfix grip low move linear 0 -200 0 units box\nrun 1");
    EXPECT_THAT(s.log(), Not(HasSubstr("WARNING"))) << frame;
  }
}

const char MASSES[] = "is less than half or more than twice their volume times the density";

TEST(WarnsBeforeARun, OfMassesOfAnotherAtomStyle)
{
  Block b = body();
  b.style = "hybrid sph/solid sphere";    // its particles are born with a mass
  EXPECT_THAT(log_of(b.script()),
              HasSubstr(std::string("WARNING: sph/solid: the mass of 48 particles ") + MASSES));
  b.motion += "set group all mass 0.00785\n";
  EXPECT_THAT(log_of(b.script()), Not(HasSubstr(MASSES)));
}

TEST(WarnsBeforeARun, OfVolumesThatChangeAfterTheMasses)
{
  Session s;
  s(body().script());
  s("run 0");
  EXPECT_THAT(s.log(), Not(HasSubstr("WARNING")));
  s("set atom 1 volume 2.2e-6\nset atom 2 volume 1.8e-6\nrun 0");
  EXPECT_THAT(s.log(),
              HasSubstr(std::string("WARNING: sph/solid: the mass of 1 particles ") + MASSES));
}

const char PRESSED[] = "begin under pressure: their density is not mass over volume";

TEST(WarnsBeforeARun, OfDensitiesOfAnotherMass)
{
  for (const std::string &frame : FRAMES) {
    Session s;
    s(small(frame).script());
    s("run 0\nset atom 7 mass 0.0088\nrun 0");
    EXPECT_THAT(s.log(),
                HasSubstr(std::string("WARNING: sph/solid: 1 particles ") + PRESSED +
                          ", at particle 7 it is 7850 and not 8800. Densities stay what they are "
                          "when a mass or volume is set after the first run; 'set ... sph/rho 0' "
                          "takes them anew"))
        << frame;
    Session t;
    t(small(frame).script());
    t("run 0\nset atom 7 mass 0.0088\nset atom 7 sph/rho 0\nrun 0");
    EXPECT_THAT(t.log(), Not(HasSubstr("WARNING"))) << frame;
    EXPECT_NEAR(t.particle(7).rho, 8800.0, 1.0e-9);
  }
}

// a start under pressure, and what a run has done

TEST(WarnsBeforeARun, NotOfDensitiesThatBelong)
{
  Session s;
  s(body().script());
  s("set group all sph/rho 8200\nrun 0");
  EXPECT_THAT(s.log(), Not(HasSubstr(PRESSED)));
  s("run 20\nset group all sph/rho 9000\nrun 0");
  EXPECT_THAT(s.log(), Not(HasSubstr(PRESSED)));
}

TEST(WarnsBeforeARun, OfACourantNumberThatNoBodyBears)
{
  const std::string says = "WARNING: Fix sph/solid/dt: cfl is 3, more than elastic bodies bear: "
                           "expected auto or a number up to 1.5";
  for (const char *cfl : {"3.0", "1.5", "auto"}) {
    Block b = body();
    b.fixes = "fix move all sph/solid\nfix step all sph/solid/dt 1 " + std::string(cfl) + "\n";
    Session s;
    s(b.script());
    s("run 0\nrun 0");
    const std::string log = s.log();
    const auto first = log.find(says);
    EXPECT_EQ(first != std::string::npos, std::string(cfl) == "3.0") << cfl;
    EXPECT_EQ(log.rfind(says), first);    // once
  }
}

// the kernel ends at 2h

TEST(WarnsBeforeARun, OfAKernelThatEndsBeforeTheNextParticle)
{
  for (const std::string &frame : FRAMES) {
    Block b = small(frame);
    b.motion = "";
    for (const double h : {0.45e-3, 0.8e-3}) {
      b.h = h;
      const auto warned = HasSubstr("WARNING: sph/solid type 1: h is 0.45 spacings");
      if (h < 0.5e-3)
        EXPECT_THAT(log_of(b.script()), warned) << frame;
      else
        EXPECT_THAT(log_of(b.script()), Not(HasSubstr("WARNING"))) << frame;
    }
  }
}

/* ----------------------------------------------------------------------
   errors
------------------------------------------------------------------------- */

// or nearly so, as a command does that finds a place by arithmetic

TEST(RefusedBeforeARun, TwoParticlesAtTheSamePlace)
{
  for (const std::string &frame : FRAMES)
    for (const std::string y : {"0.003", "0.0030000000001"}) {
      Block b = small(frame);
      b.motion += "create_atoms 1 single 0.003 " + y + " 0 units box\nset atom 49 volume 1e-6\n";
      Session s;
      s(b.script());
      EXPECT_THAT(
          s.error("run 0"),
          testing::ContainsRegex("sph/solid.*: particles (22 and 49|49 and 22) lie at the same "
                                 "place"))
          << frame << y;
    }
}

TEST(RefusedBeforeARun, NoForces)
{
  for (const std::string &frame : FRAMES) {
    Session s;
    s(small(frame).script());
    s("pair_modify compute no");
    EXPECT_THAT(s.error("run 1"),
                HasSubstr("'pair_modify compute no' leaves particles without "
                          "stress: expected compute yes"));
    s("pair_modify compute yes\nrun 1");
  }
}

// the heat of a half kick is found one step later from velocities that are others then

TEST(RefusedBeforeARun, FixesThatChangeVelocitiesAtTheEndOfAStep)
{
  for (const std::string &frame : FRAMES)
    for (const char *fix :
         {"temp/rescale 10 1e23 1e23 1e10 0.9", "temp/berendsen 1e23 1e23 1e-6", "heat 1 -1.0"}) {
      Session s;
      s(small(frame).script());
      s(std::string("fix cool all ") + fix);
      EXPECT_THAT(s.error("run 10"),
                  HasSubstr("fix cool of style " + std::string(fix, std::strcspn(fix, " ")) +
                            " changes velocities at the end of a step"))
          << frame;
    }
}

// masses follow from volumes in the first run: commands that divide by them are too early before

TEST(RefusedBeforeARun, VelocitiesThatAreNotNumbers)
{
  for (const std::string &frame : FRAMES) {
    Block b = small(frame);
    b.motion = "velocity all create 1e20 1234\n";
    Session s;
    s(b.script());
    EXPECT_THAT(s.error("run 1"), HasSubstr("'run 0'")) << frame;
  }
}

TEST(RefusedBeforeARun, NotVelocitiesCreatedAfterAFirstRun)
{
  for (const std::string &frame : FRAMES) {
    Block b = small(frame);
    b.motion = "";
    Session s;
    s(b.script());
    // 48 particles in two dimensions without their common motion: m v^2/2 is kB T per particle
    s("run 0\nvelocity all create 1e20 1234\nrun 0");
    EXPECT_NEAR(s.value("ke"), 47.0 * 1.3806504e-23 * 1.0e20, 1.0e-6) << frame;
    s("run 1");
  }
}

/* ----------------------------------------------------------------------
   a fix that asks once whether there is an atom map, as it is defined
------------------------------------------------------------------------- */

const std::string BALANCE = "fix even all balance 10 1.0 shift xy 5 1.0\n";

std::string without_map(const std::string &frame, bool balance_first)
{
  const Block b = small(frame);
  std::string script = b.particles() + (balance_first ? BALANCE : "") + b.interaction() +
      (balance_first ? "" : BALANCE) + b.motion + b.fixes;
  const std::string map = "atom_modify map array\n";
  return script.erase(script.find(map), map.size());
}

TEST(FixBalance, BeforeThePairStyleNeedsAnAtomMap)
{
  Session s;
  EXPECT_THAT(s.error(without_map("lagrangian", true) + "run 1"), HasSubstr("atom_modify map yes"));
}

TEST(FixBalance, BehindThePairStyleRuns)
{
  Session s;
  s(without_map("lagrangian", false));
  s("run 40");
  EXPECT_THAT(s.log(), HasSubstr("sph/solid: switched on an atom map"));
  EXPECT_LT(largest_difference(run(body()), s.state()), 1.0e-12);
}

TEST(FixBalance, NeedsNoMapInTheEulerianFrame)
{
  Session s;
  s(without_map("eulerian", true));
  s("run 20");
  EXPECT_LT(largest_difference(run(small("eulerian"), "run 20"), s.state()), 1.0e-12);
}

/* ----------------------------------------------------------------------
   a body that is one spacing away from a symmetry plane is a body and its image: what it lands on
   is a partner
------------------------------------------------------------------------- */

TEST(SymmetryPlane, LandingOnAnImageEndsARun)
{
  Block b = body();
  b.motion = "displace_atoms all move 0 0.001 0 units box\nvelocity all set 0 -200 0 units box\n";
  b.fixes = "fix move all sph/solid\nfix step all sph/solid/dt 10 auto\n"
            "fix floor all sph/solid/wall ylo 0 symmetry\ncompute e all sph/solid/energy\n"
            "compute low all reduce min y\nthermo_style custom step c_e c_low\nthermo 1\n";
  Session s;
  s(b.script());
  EXPECT_THAT(s.error("run 3000"), HasSubstr("it lies on a partner"));
  EXPECT_THAT(s.log(), Not(testing::ContainsRegex("[^a-z]-?nan[^a-z]")));
}

/* ----------------------------------------------------------------------
   half of a body that a program has put so far from its symmetry plane, as files with few digits do: it
   lands, and is what it would have been on the plane but for the momentum of its lowest row
------------------------------------------------------------------------- */

double energy_of_half(const std::string &frame, const std::string &off)
{
  Block b = small(frame);
  b.h = 1.3e-3;
  b.motion = "region low block INF INF INF 1e-4 INF INF units box\ngroup low region low\n"
             "set group low volume 0.5e-6\nvelocity all set 0 -20 0 units box\n"
             "displace_atoms all move 0 " +
      off + " 0 units box\n";
  b.fixes = "fix move all sph/solid\ntimestep 2e-8\n"
            "fix floor all sph/solid/wall ylo 0 symmetry\n";
  Session s;
  s(b.script());
  s("run 40");
  return s.value("ke");
}

TEST(SymmetryPlane, MayBeMissedByALittle)
{
  for (const std::string &frame : FRAMES) {
    const double on_it = energy_of_half(frame, "0");
    for (const char *off : {"0.9e-9", "1.7e-9", "4e-9", "1e-8", "1e-7"})
      EXPECT_NEAR(energy_of_half(frame, off) / on_it, 1.0, 2.0e-3) << frame << " " << off;
  }
}

}    // namespace
