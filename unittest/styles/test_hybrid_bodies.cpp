/* ----------------------------------------------------------------------
   Bodies in pair style hybrid are those of the pair style alone: in three dimensions, where messages
   to ghosts are longest, and at symmetry planes.
------------------------------------------------------------------------- */

#include "session.h"

using namespace sphsolid_test;

namespace {

const std::vector<std::string> FRAMES = {"eulerian", "lagrangian"};

void replace(std::string &text, const std::string &what, const std::string &by)
{
  const auto at = text.find(what);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, what.size(), by);
}

// the same input with a hybrid, alone or with a second style that does nothing

std::string in_hybrid(const Block &b, const std::string &second = "")
{
  std::string text = b.script(), after;
  const std::string line = "pair_style sph/solid ";
  const auto end = text.find('\n', text.find(line));
  if (!second.empty()) text.insert(end, " " + second + " 2e-3");
  replace(text, line,
          (second.empty() ? "pair_style hybrid " : "pair_style hybrid/overlay ") +
              std::string("sph/solid "));
  replace(text, "pair_coeff * * ",
          (second.empty() ? "" : "pair_coeff * * " + second + "\n") +
              std::string("pair_coeff * * sph/solid "));
  return text;
}

const std::string ENERGY = "compute e all sph/solid/energy\nthermo_style custom step c_e\n";

struct Result {
  State state;
  double energy;
};

Result result(const std::string &script, const std::string &steps)
{
  Session s;
  s(script);
  s(ENERGY + steps);
  return {s.state(), s.value("c_e")};
}

void expect_equal(const Result &a, const Result &b)
{
  EXPECT_LT(largest_difference(a.state, b.state), 1.0e-12);
  EXPECT_NEAR(a.energy, b.energy, 1.0e-12 * a.energy);
}

/* ----------------------------------------------------------------------
   a block that is periodic in x and y, so that most particles have ghosts
------------------------------------------------------------------------- */

Block deep(const std::string &frame, const std::string &options)
{
  Block b;
  b.boundary = "p p";
  b.box = "0 0.012 0 0.012";
  b.nx = b.ny = 12;
  b.nz = 5;
  b.frame = frame;
  b.options = options;
  b.motion = "variable vx atom 50*sin(2*PI*y/0.012)\nvariable vz atom 2e4*(z-0.002)\n"
             "velocity all set v_vx 20 v_vz units box\n";
  return b;
}

TEST(HybridBody, MovesInThreeDimensionsAsWithout)
{
  for (const std::string &frame : FRAMES)
    for (const char *options : {"", "viscosity limited 1 1", "viscosity front"}) {
      SCOPED_TRACE(frame + " " + options);
      const Block b = deep(frame, options);
      const Result plain = result(b.script(), "run 5");
      double force = 0.0;
      for (const Particle &p : plain.state) force = std::max(force, std::fabs(p.f[2]));
      EXPECT_GT(force, 1.0);    // 1 MPa x 1 mm^2
      expect_equal(plain, result(in_hybrid(b), "run 5"));
    }
}

TEST(HybridBody, MovesInThreeDimensionsAsWithoutBesideAnotherStyle)
{
  for (const std::string &frame : FRAMES) {
    SCOPED_TRACE(frame);
    const Block b = deep(frame, "tensile artificial 0.3 4");
    const Block l = deep(frame, "");
    const Block &one = frame == "eulerian" ? b : l;    // the Lagrangian frame needs no such stress
    expect_equal(result(one.script(), "run 5"), result(in_hybrid(one, "zero"), "run 5"));
  }
}

/* ----------------------------------------------------------------------
   types of one body: what one command gives to both acts between them as well, beside whatever else does
------------------------------------------------------------------------- */

std::string of_two_types(const std::string &frame, const std::string &pair_coeffs)
{
  Block b;
  b.nx = b.ny = 8;
  b.types = 2;
  b.frame = frame;
  b.motion = "region left block INF 3.5 INF INF INF INF\ngroup left region left\n"
             "velocity left set 0 -50 0 units box\n";
  std::string text = b.script();
  replace(text, "set group all volume",
          "region low block INF INF INF 3.5 INF INF\ngroup low region low\nset group low type 2\n"
          "set group all volume");
  const auto begin = text.find("pair_style"), end = text.find('\n', text.find("pair_coeff"));
  return text.substr(0, begin) + "pair_style hybrid/overlay sph/solid 1.3e-3 frame " + frame +
      " zero 2e-3\n" + pair_coeffs + text.substr(end);
}

TEST(HybridBody, OfTwoTypesIsOneBody)
{
  const std::string iron = std::string(IRON), both = "pair_coeff * * sph/solid " + iron;
  for (const std::string &frame : FRAMES) {
    SCOPED_TRACE(frame);
    const Result alone = result(of_two_types(frame, both + "pair_coeff 1 1 zero"), "run 60"),
                 with = result(of_two_types(frame, both + "pair_coeff * * zero"), "run 60");
    expect_equal(alone, with);
    Session s;
    s(of_two_types(frame,
                   "pair_coeff 1 1 sph/solid " + iron + "pair_coeff 2 2 sph/solid " + iron +
                       "pair_coeff 1 2 zero") +
      ENERGY + "run 60");
    EXPECT_GT(largest_difference(alone.state, s.state()), 1.0e-3);
    EXPECT_THAT(s.log(),
                HasSubstr("particles of types 1 and 2 do not act on each other by this style"));
  }
}

/* ----------------------------------------------------------------------
   a block flies into a symmetry plane half a spacing below it
------------------------------------------------------------------------- */

Block mirrored(const std::string &frame)
{
  Block b;
  b.nx = 8;
  b.ny = 10;
  b.frame = frame;
  b.fixes = MOVE + "fix floor all sph/solid/wall ylo -0.0005 symmetry\n";
  return b;
}

TEST(HybridBody, SeesSymmetryPlanesAsWithout)
{
  for (const std::string &frame : FRAMES) {
    SCOPED_TRACE(frame);
    const Block b = mirrored(frame);
    const Result plain = result(b.script(), "run 60");
    EXPECT_GT(plain.state[3].v[1], -100.0);    // the plane has stopped the lowest row
    expect_equal(plain, result(in_hybrid(b), "run 60"));
    expect_equal(plain, result(in_hybrid(b, "zero"), "run 60"));
  }
}

// images are neighbors: a body on the plane has no face there

TEST(HybridBody, CountsImagesAsNeighbors)
{
  for (const std::string &frame : FRAMES) {
    Session s;
    s(in_hybrid(mirrored(frame)));
    s("compute n all sph/solid/atom neigh\nrun 0");
    // inside 20 within 2.6 spacings: all of 5 x 5 without the corners; below are 3 rows of images,
    // of which the third is 3 spacings away
    EXPECT_EQ(s.per_atom("n")[4], 20.0) << frame;
  }
}

/* ----------------------------------------------------------------------
   particles of another style
------------------------------------------------------------------------- */

std::string with_stranger(const std::string &fixes)
{
  return "units si\ndimension 2\nboundary f f p\natom_style sph/solid\natom_modify map array\n"
         "region box block -0.04 0.04 -0.04 0.04 -0.0005 0.0005\ncreate_box 2 box\n"
         "lattice sq 0.001\nregion body block -0.1 3.1 -0.1 3.1 -0.1 0.1\n"
         "create_atoms 1 region body\ncreate_atoms 2 single 0.02 0.02 0 units box\n"
         "set type 1 volume 1e-6\n"
         "pair_style hybrid sph/solid 1.3e-3 frame " +
      frame_under_test() + " zero 3e-3\npair_coeff 1 1 sph/solid " + IRON +
      "pair_coeff 1*2 2 zero\n" + NEIGHBOR + "timestep 1e-8\n" + fixes;
}

TEST(HybridBody, RefusesToMoveParticlesWithoutMass)
{
  Session s;
  s(with_stranger("fix move all sph/solid\n"));
  EXPECT_THAT(s.error("run 1"),
              HasSubstr("Fix sph/solid move: particle 17 of type 2 has mass 0: expected one > 0"));
}

TEST(HybridBody, NeedsNoMassOfParticlesThatStay)
{
  Session s;
  s(with_stranger("group body type 1\nfix move body sph/solid\n"));
  s("run 5");
  EXPECT_EQ(s.particle(17).x[0], 0.02);
}

TEST(HybridBody, MovesParticlesOfAnotherStyleWithAMass)
{
  Session s;
  s(with_stranger("set type 2 mass 0.1\ngroup other type 2\n"
                  "velocity other set 10 0 0 units box\nfix move all sph/solid\n"));
  s("run 5");
  EXPECT_NEAR(s.particle(17).x[0], 0.02 + 5 * 1.0e-8 * 10.0, 1.0e-15);
}

// beside a symmetry plane and with ghosts; then it gets a material

TEST(HybridBody, LeavesOtherParticlesTheirDensity)
{
  for (const std::string &frame : FRAMES) {
    SCOPED_TRACE(frame);
    std::string script = with_stranger("set type 2 mass 1e-3\nset type 2 sph/rho 1234.5\n"
                                       "set atom 17 y -0.0002\nfix move all sph/solid\n"
                                       "fix plane all sph/solid/wall ylo -0.0005 symmetry\n");
    replace(script, "boundary f f p", "boundary p f p");
    replace(script, "single 0.02 0.02 0", "single 0.0399 0.02 0");
    replace(script, "frame " + frame_under_test(), "frame " + frame);
    Session s;
    s(script + "run 5\n");
    const LAMMPS_NS::Atom *atom = s.lmp->atom;
    int ghosts = 0;
    for (int i = 0; i < atom->nlocal + atom->nghost; i++) {
      if (atom->type[i] != 2) continue;
      EXPECT_EQ(atom->rho[i], 1234.5);
      if (i >= atom->nlocal) ghosts++;
    }
    EXPECT_GT(ghosts, 0);
    s("set type 2 type 1\nset atom 17 volume 1e-6\nset atom 17 mass 7.85e-3\n"
      "set atom 17 sph/rho 7850\nrun 5");
    EXPECT_EQ(s.particle(17).rho, 7850.0);    // it is alone
  }
}

// the smoothing length of the command is that of no particle where every material has one of its own

TEST(HybridBody, HasNoLengthOfTypesWithoutMaterial)
{
  auto run = [](const std::string &h) {
    std::string text = with_stranger("group body type 1\nvelocity body ramp vx -5 5 x 0 0.003 "
                                     "units box\nfix move body sph/solid\n");
    replace(text, "sph/solid 1.3e-3", "sph/solid " + h);
    replace(text, "perfect 600e6\n", "perfect 600e6 h 1.3e-3\n");
    Session s;
    s(text + "run 20");
    return s.state();
  };
  expect_bitwise(run("1.3e-3"), run("1e8"));
}

/* ----------------------------------------------------------------------
   neighbor lists that LAMMPS shares: it has one for the group, and that of the pair style is a copy of
   it, whose arrays are not to be given back when partners are known
------------------------------------------------------------------------- */

Block stretched(const std::string &frame)
{
  Block b;
  b.nx = b.ny = 10;
  b.frame = frame;
  b.motion = "velocity all ramp vx -50 50 x 0.0 0.009 units box\n";
  return b;
}

const std::string THREE_RUNS = "run 0\nrun 100\nrun 100";

TEST(SharedNeighborList, OfADynamicGroupChangesNothing)
{
  for (const std::string &frame : FRAMES) {
    SCOPED_TRACE(frame);
    Block b = stretched(frame);
    const Result plain = result(b.script(), THREE_RUNS);
    b.motion += "group near dynamic all within 2.0e-3 every 1\n";
    expect_equal(plain, result(b.script(), THREE_RUNS));
  }
}

TEST(SharedNeighborList, OfAnotherPairStyleChangesNothing)
{
  for (const std::string &frame : FRAMES) {
    SCOPED_TRACE(frame);
    const Block b = stretched(frame);
    std::string other = in_hybrid(b, "zero");
    replace(other, "zero 2e-3", "zero 2.574e-3 full");
    expect_equal(result(b.script(), THREE_RUNS), result(other, THREE_RUNS));
  }
}

/* ----------------------------------------------------------------------
   energies
------------------------------------------------------------------------- */

TEST(EnergyPerAtom, SumsUpToThePairEnergy)
{
  for (const std::string &frame : FRAMES)
    for (const bool hybrid : {false, true}) {
      SCOPED_TRACE(frame + (hybrid ? " in a hybrid" : ""));
      Block b;
      b.nx = 8;
      b.ny = 10;
      b.frame = frame;
      b.fixes += "fix floor all sph/solid/wall ylo 0\n";
      Session s;
      s(hybrid ? in_hybrid(b) : b.script());
      s("compute one all pe/atom\ncompute sum all reduce sum c_one\n"
        "thermo_style custom step pe c_sum\nrun 40\n"
        // a run that does not continue: nothing is half a step behind
        "velocity all set 1e-6 0 0 sum yes units box\nrun 0");
      const double energy = s.value("pe");
      EXPECT_GT(energy, 1.0);    // of 12.5 kJ per unit width of moving iron
      EXPECT_NEAR(s.value("c_sum"), energy, 1.0e-12 * energy);
      double sum = 0.0;
      const std::map<int, double> one = s.per_atom("one");
      for (const Particle &p : s.state()) {
        EXPECT_DOUBLE_EQ(one.at(static_cast<int>(p.id)), p.mass * p.e);
        sum += p.mass * p.e;
      }
      EXPECT_NEAR(sum, energy, 1.0e-12 * energy);
    }
}

}    // namespace
