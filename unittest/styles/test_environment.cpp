/* ----------------------------------------------------------------------
   Runs that make no sense are refused before they start, and runs that go
   wrong stop with a message that says where.
------------------------------------------------------------------------- */

#include "session.h"

using namespace sphsolid_test;

namespace {

Block small()
{
  Block b;
  b.nx = b.ny = 6;
  return b;
}

// message of a run of a block after some more lines

std::string refusal(const Block &b, const std::string &more = "")
{
  Session s;
  s(b.script());
  const std::string message = s.error(more + "run 5");
  return message;
}

/* ----------------------------------------------------------------------
   before the first step
------------------------------------------------------------------------- */

class ForeignUnits : public testing::TestWithParam<std::string> {};

TEST_P(ForeignUnits, AreRefused)
{
  Session s;
  s("units " + GetParam() +
    "\nboundary f f f\natom_style sph/solid\nregion box block 0 4 0 4 0 4\ncreate_box 1 box\n"
    "create_atoms 1 single 1 1 1\nset group all volume 1\npair_style sph/solid 1\n"
    "pair_coeff * * inline rho0 1 eos linear 1 shear 1 strength elastic\nfix 1 all sph/solid");
  EXPECT_THAT(s.error("run 0"),
              HasSubstr("Pair style sph/solid works in units si, cgs, micro, nano or lj, not in " +
                        GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Units, ForeignUnits, testing::Values("real", "metal", "electron"),
                         [](const auto &info) {
                           return info.param;
                         });

TEST(Refused, ParticleOffThePlaneInTwoDimensions)
{
  Session s;
  s(small().script());
  s.lmp->atom->x[s.lmp->atom->map(7)][2] = 1.0e-5;
  EXPECT_THAT(s.error("run 0"),
              HasSubstr("Pair style sph/solid, dimension 2: particle 7 has z = 1e-05: expected a "
                        "single layer of particles at z = 0"));
}

TEST(Refused, RunWithoutIntegrator)
{
  Block b = small();
  b.fixes = "";
  EXPECT_THAT(refusal(b),
              HasSubstr("Pair style sph/solid: no time integration: expected a command "
                        "like 'fix 1 all sph/solid'"));
}

TEST(Refused, SecondIntegratorOfAnotherStyle)
{
  EXPECT_THAT(refusal(small(),
                      "region low block INF INF INF 0.9 INF INF\ngroup low region low\n"
                      "fix other low nve\n"),
              HasSubstr("fix other of style nve moves 6 particles that a fix sph/solid moves too: "
                        "expected one of the two per particle"));
}

TEST(Refused, SecondIntegratorOfTheSameStyle)
{
  EXPECT_THAT(refusal(small(), "fix again all sph/solid\n"), HasSubstr("again"));
}

TEST(Refused, ParticleWithoutVolume)
{
  EXPECT_THAT(
      refusal(small(), "create_atoms 1 single 0.01 0.01 0 units box\n"),
      HasSubstr("sph/solid: particle 37 of type 1 has no volume: expected a command like 'set "
                "group all volume V' before the run"));
}

TEST(Refused, TypeWithoutMaterial)
{
  Session s;
  s("units si\ndimension 2\nboundary f f p\natom_style sph/solid\n"
    "region box block 0 1 0 1 -0.5 0.5\ncreate_box 2 box\ncreate_atoms 1 single 0.5 0.5 0\n"
    "set group all volume 1\npair_style sph/solid 1\nfix 1 all sph/solid\n"
    "pair_coeff 1 1 inline rho0 1 eos linear 1 shear 1 strength elastic\n");
  EXPECT_THAT(s.error("run 0"), HasSubstr("All pair coeffs are not set"));
}

TEST(Refused, AnotherAtomStyle)
{
  for (const char *styles : {"atom_style atomic\n", "atom_style sph/solid\natom_style atomic\n"}) {
    Session s;
    s(std::string("units si\ndimension 2\nboundary f f p\n") + styles +
      "region box block 0 1 0 1 -0.5 0.5\ncreate_box 1 box\ncreate_atoms 1 single 0.5 0.5 0\n"
      "mass * 1\npair_style sph/solid 1\n"
      "pair_coeff * * inline rho0 1 eos linear 1 shear 1 strength elastic\nfix 1 all sph/solid");
    EXPECT_THAT(s.error("run 0"),
                HasSubstr("Pair style sph/solid needs atom_style sph/solid (alone or in hybrid)"));
  }
}

TEST(Refused, ParticlesWithoutIds)
{
  Session s;
  s("units si\ndimension 2\nboundary f f p\natom_style sph/solid\natom_modify id no\n"
    "region box block 0 1 0 1 -0.5 0.5\ncreate_box 1 box\ncreate_atoms 1 single 0.5 0.5 0\n"
    "set group all volume 1\npair_style sph/solid 1\n"
    "pair_coeff * * inline rho0 1 eos linear 1 shear 1 strength elastic\nfix 1 all sph/solid");
  EXPECT_THAT(s.error("run 0"), HasSubstr("Pair style sph/solid needs atom IDs"));
}

TEST(Refused, WallAcrossAPeriodicBoundary)
{
  Block b = small();
  b.boundary = "f p";
  Session s;
  s(b.script());
  EXPECT_THAT(
      s.error("fix floor all sph/solid/wall ylo 0"),
      HasSubstr("Fix sph/solid/wall: the box is periodic across side ylo: expected a boundary "
                "f, s or m"));
}

TEST(Refused, WallAcrossABoundaryThatBecomesPeriodic)
{
  EXPECT_THAT(
      refusal(small(), "fix lid all sph/solid/wall yhi 0.01\nchange_box all boundary p p p\n"),
      HasSubstr("Fix sph/solid/wall: the box is periodic across side yhi: expected a boundary f, s "
                "or m"));
}

TEST(Refused, NegativeTimeStep)
{
  EXPECT_THAT(refusal(small(), "unfix step\ntimestep -1e-9\n"),
              HasSubstr("Pair style sph/solid: the time step is -1e-09: expected timestep with a "
                        "value > 0"));
}

TEST(Refused, ParticleBehindTheWall)
{
  EXPECT_THAT(
      refusal(small(), "fix floor all sph/solid/wall ylo 0.0005\n"),
      HasSubstr("Fix sph/solid/wall floor: particle 1 at 0 0 0 lies behind the wall at 0.0005"));
  EXPECT_THAT(refusal(small(), "fix roof all sph/solid/wall yhi 0.0045 symmetry\n"),
              HasSubstr("Fix sph/solid/wall roof: particle 31 at 0 0.005 0 lies behind the wall at "
                        "0.0045"));
}

TEST(Refused, ParallelSymmetryPlanesCloserThanTheKernel)
{
  EXPECT_THAT(refusal(small(),
                      "fix a all sph/solid/wall ylo -0.0005 symmetry\n"
                      "fix b all sph/solid/wall yhi 0.0045 symmetry\n"),
              HasSubstr("parallel symmetry planes at -0.0005 and 0.0045 are closer than twice the "
                        "kernel support 0.0026"));
}

TEST(Refused, RespaIntegration)
{
  EXPECT_THAT(refusal(small(), "run_style respa 2 2 pair 1\n"),
              HasSubstr("Fix sph/solid works with run_style verlet, not with respa"));
}

TEST(Refused, Minimization)
{
  Session s;
  s(small().script());
  EXPECT_THAT(s.error("minimize 1e-4 1e-4 10 10"),
              HasSubstr("Pair style sph/solid carries a history and cannot be minimized"));
}

TEST(Refused, TwoOfThePairStyle)
{
  Session s;
  s("units si\ndimension 2\nboundary f f p\natom_style sph/solid\n"
    "region box block 0 1 0 1 -0.5 0.5\ncreate_box 2 box\n"
    "create_atoms 1 single 0.5 0.5 0\ncreate_atoms 2 single 0.1 0.5 0\nset group all volume 1\n"
    "pair_style hybrid sph/solid 0.1 sph/solid 0.2\n"
    "pair_coeff 1 1 sph/solid 1 inline rho0 1 eos linear 1 shear 1 strength elastic\n"
    "pair_coeff 2 2 sph/solid 2 inline rho0 1 eos linear 1 shear 1 strength elastic\n"
    "pair_coeff 1 2 none\nfix 1 all sph/solid");
  EXPECT_THAT(s.error("run 0"), HasSubstr("needs pair style sph/solid, once (alone or in hybrid)"));
}

TEST(Refused, PerAtomVirial)
{
  EXPECT_THAT(
      refusal(small(),
              "compute s all stress/atom NULL\ndump d all custom 1 " + file("d") + " id c_s[1]\n"),
      HasSubstr("Pair style sph/solid has no per-atom virial: use compute sph/solid/atom sxx"));
}

/* ----------------------------------------------------------------------
   during the run
------------------------------------------------------------------------- */

TEST(Stops, WhenParticlesAreAdded)
{
  Session s;
  Block b = small();
  b.motion = "";
  s(b.script());
  s("region top block 0 5 20 30 -0.5 0.5\n"
    "fix rain all deposit 5 1 2 12345 region top near 0.001 units box");
  EXPECT_THAT(
      s.error("run 20"),
      HasSubstr("Particles cannot be added during a run (fix deposit): add them between runs "
                "and set their volume"));
}

TEST(Stops, WhenTheStateIsNotFinite)
{
  Session s;
  Block b = small();
  b.options = "viscosity none";
  b.fixes = "fix move all sph/solid\ntimestep 1e-6\nfix floor all sph/solid/wall ylo 0\n";
  b.motion = "velocity all set 0 -20000 0 units box\n";
  s(b.script());
  s("thermo_modify lost warn flush yes");
  const std::string message = s.error("run 100");
  EXPECT_THAT(message,
              testing::ContainsRegex("sph/solid: the state of particle [0-9]+ at [-0-9.e]+ "
                                     "[-0-9.e]+ 0 is not physical in step [0-9]+: density"));
  EXPECT_THAT(message,
              HasSubstr("expected finite values and a density > 0. The usual causes are a "
                        "time step that is too long (fix sph/solid/dt) and viscosity none"));
}

// 0.7 and 0.8 of the speed of sound, along the diagonal

TEST(Warns, OfAParticleThatLeavesItsBody)
{
  for (const char *speed : {"2500", "3000"}) {
    SCOPED_TRACE(speed);
    Session s;
    Block b = small();
    b.motion = "velocity all zero linear\n";
    s(b.script());
    s("group one id 36\nvariable v equal " + std::string(speed) +
      "\nvelocity one set $v $v 0 units box\nrun 200");
    const std::string log = s.log();
    EXPECT_THAT(log, HasSubstr("sph/solid: particle 36 at "));
    EXPECT_THAT(log, HasSubstr("has lost all its neighbors by step "));
  }
}

TEST(Warns, NotOfABodyInFreeFlight)
{
  Session s;
  s(small().script());
  s("run 100");
  EXPECT_THAT(s.log(), Not(HasSubstr("WARNING")));
}

// iron at e = 0: (1 - 0.9 eta) P_H(eta) of eqs 8 and 9 and its thermal part have a positive slope up to 1.8389 times
// the density at rest (found from these formulas by a program of its own)

TEST(Warns, OfMatterCompressedBeyondItsEquationOfState)
{
  for (const char *frame : {"eulerian", "lagrangian"})
    for (const auto &[times, ends] : {std::pair(1.82, false), std::pair(1.86, true)}) {
      SCOPED_TRACE(std::string(frame) + " " + std::to_string(times));
      Session s;
      Block b = small();
      b.frame = frame;
      s(b.script());
      s("group one id 15\nset group one sph/rho " + num(7850.0 * times) + "\nrun 0");
      const std::string warning =
          "sph/solid: particle 15 at 0.002 0.002 0 has 1.86 times its density at rest in step 0, "
          "where its equation of state ends";
      EXPECT_EQ(s.log().find(warning) != std::string::npos, ends);
    }
}

// How many are not corrected follows from det M and tr M of lattice sums (h = 1.5 spacings), added up by a program of
// its own: of two rows of whole cells none, of two of half cells the last two of each end and row

TEST(Logs, ParticlesWithoutGradientCorrection)
{
  const std::string NO_CORRECTION = "sph/solid: no gradient correction for ";
  Block b;
  b.frame = "eulerian";
  b.h = 1.5e-3;
  b.ny = 12;
  b.nx = 2;
  {
    Session s;
    s(b.script() + "run 0");
    EXPECT_THAT(s.log(), Not(HasSubstr(NO_CORRECTION)));
  }
  {
    Session s;
    const std::string halves =
        "region ends block INF INF INF 0.5 INF INF side in\n"
        "group lower region ends\nregion top block INF INF 10.5 INF INF INF\n"
        "group upper region top\ngroup ends union lower upper\n"
        "set group all volume 0.5e-6\nset group ends volume 0.25e-6\n";
    s(b.particles() + halves + "create_atoms 1 single 20 20 0\ngroup far id 25\n" +
      "set group far volume 1e-6\n" + b.interaction() + b.motion + b.fixes + "run 0\nrun 0");
    const std::string log = s.log(),
                      line = NO_CORRECTION +
        "8 particles, whose neighbors are few, or lie in one row or layer";
    EXPECT_THAT(log, HasSubstr(line));
    EXPECT_EQ(log.find(NO_CORRECTION), log.rfind(NO_CORRECTION));    // once
  }
  b.nx = 1;
  Session s;
  s(b.script() + "run 0");
  EXPECT_THAT(s.log(), HasSubstr(NO_CORRECTION + "12 particles"));
}

TEST(Refused, ArtificialStressWhereTheKernelEndsBeforeTheSpacing)
{
  Block b = small();
  b.frame = "eulerian";
  b.options = "tensile artificial 0.3 4";
  b.h = 0.5e-3;
  EXPECT_THAT(
      refusal(b),
      HasSubstr("Pair style sph/solid, tensile artificial: the smoothing length of type 1 is "
                "0.5 spacings, and its kernel is 0 at the spacing: expected more than 0.5"));
  b.h = 0.51e-3;
  EXPECT_EQ(refusal(b), "");
}

TEST(Environment, HybridScaledIsRefused)
{
  Session s;
  s(Block().particles() +
    "pair_style hybrid/scaled 0.5 sph/solid 1.3e-3\npair_coeff * * sph/solid " + IRON + NEIGHBOR +
    MOVE);
  EXPECT_THAT(s.error("run 0"),
              HasSubstr("Pair style sph/solid cannot be part of pair style hybrid/scaled"));
}

}    // namespace
