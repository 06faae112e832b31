/* ----------------------------------------------------------------------
   The Lagrangian frame in LAMMPS: defaults, partners for life, renewing the
   reference, particles that come and go, restarts, periodic boxes, and the
   messages where it ends.
------------------------------------------------------------------------- */

#include "session.h"

#include "domain.h"
#include "nbin.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "npair.h"

using namespace sphsolid_test;

namespace {

const std::string NEIGHBOR = "neighbor 0.0003 bin\nneigh_modify every 1 delay 0 check yes\n";
const std::string MOVE = "fix move all sph/solid\nfix step all sph/solid/dt 1 0.3\n";

Block body(const std::string &options = "")
{
  Block b;
  b.nx = 6;
  b.ny = 8;
  b.frame = "lagrangian";
  b.options = options;
  b.motion = "variable vy atom -2e4*y*(1+100*x)\nvelocity all set NULL v_vy NULL units box\n";
  return b;
}

State run(const Block &b, const std::string &steps = "run 40")
{
  Session s;
  s(b.script());
  s(steps);
  return s.state();
}

/* ----------------------------------------------------------------------
   defaults
------------------------------------------------------------------------- */

TEST(LagrangianDefaults, AreTheKeywordsWrittenOut)
{
  Session s;
  Block b = body();
  s(b.particles());
  s("pair_style sph/solid 1.3e-3\npair_coeff * * " + std::string(IRON) + NEIGHBOR + b.motion +
    b.fixes + "run 40");
  const State defaults = s.state();
  expect_bitwise(run(body("viscosity correct hbar 1.5 weights conservative alpha 1 1 heating "
                          "compatible gradient corrected tensile none hourglass 0.03 distortion "
                          "error")),
                 defaults);
  EXPECT_GT(largest_difference(run(body("hourglass 0.0")), defaults), 1.0e-12);
  Block eulerian = body();
  eulerian.frame = "eulerian";
  EXPECT_GT(largest_difference(run(eulerian), defaults), 1.0e-6);
}

TEST(LagrangianDefaults, SwitchOnAnAtomMap)
{
  std::string script = body().script();
  const std::string map = "atom_modify map array\n";
  script.erase(script.find(map), map.size());
  Session s;
  s(script);
  s("run 40");
  EXPECT_THAT(s.log(), HasSubstr("sph/solid: switched on an atom map"));
  expect_bitwise(run(body()), s.state());
}

/* ----------------------------------------------------------------------
   a bar is pulled to twice its length: its ends are held by the grips, all
   others start with the velocity of a uniform stretch.  It hardens quickly enough
   not to neck (Considere: H > Y + H ln 2)
------------------------------------------------------------------------- */

constexpr double LENGTH = 19.0e-3, PULL = 200.0;    // m, m/s

std::string pulled_bar()
{
  Block b;
  b.nx = 5;
  b.ny = 20;
  b.frame = "lagrangian";
  b.material = "inline rho0 7850 eos mie-gruneisen 3600 1.8 1.8 shear 80e9 strength linear 600e6 "
               "4e9\n";
  b.motion =
      "region low block INF INF INF 1.5 INF INF\nregion high block INF INF 17.5 INF INF INF\n"
      "group low region low\ngroup high region high\ngroup grips union low high\n"
      "group free subtract all grips\n"
      "variable vy atom " +
      num(PULL / LENGTH) +
      "*y\nvelocity all set 0 v_vy 0 units box\n"
      "velocity low set 0 0 0\nvelocity high set 0 200 0 units box\n";
  b.fixes = "fix move all sph/solid\nfix hold grips setforce 0 0 0\n"
            "fix step all sph/solid/dt 1 0.5\ncompute a all sph/solid/atom neigh syy epl\n"
            "compute area all reduce ave c_a[2]\n";
  return b.script();
}

std::string until_length(double factor)
{
  return "variable now equal time\nfix stop all halt 1 v_now >= " +
      num((factor - 1.0) * LENGTH / PULL) + " error continue message no\nrun 100000\nunfix stop\n";
}

TEST(LagrangianPartners, AreKeptUnderStretch)
{
  Session s;
  s(pulled_bar());
  s("run 0");
  const std::map<int, double> before = s.per_atom("a", 0);
  s(until_length(2.0));
  EXPECT_EQ(before, s.per_atom("a", 0));
  EXPECT_NEAR(s.particle(100).x[1] - s.particle(1).x[1], 2.0 * LENGTH, 0.05 * LENGTH);

  // no fracture and no neck: the middle is stretched by what the 17 gaps between the grips are
  // in the mean, and a little more as the grips hold their neighbors; the plastic strain is that
  // of an incompressible bar in plane strain, 2/sqrt(3) ln(stretch).  Over four rows, since
  // single gaps of the inner columns alternate about that (0.8 to 3.5 mm near the grips)
  const double mean = (2.0 * 19.0 - 2.0) / 17.0;
  const State state = s.state();
  for (int k = 0; k < 5; k++) {
    const double stretch = (state[5 * 11 + k].x[1] - state[5 * 7 + k].x[1]) / 4.0e-3;
    EXPECT_GT(stretch, mean);
    EXPECT_LT(stretch, 1.2 * mean);
    for (int row = 7; row <= 11; row++)
      EXPECT_NEAR(state[5 * row + k].epl, 2.0 / std::sqrt(3.0) * std::log(stretch), 0.08);
  }
}

// a list per run for its first partners; pairs do not need another

TEST(LagrangianPartners, NeedNoNeighborListDuringARun)
{
  Session s;
  s(body().script());
  s("run 0");
  const LAMMPS_NS::Neighbor *neighbor = s.lmp->neighbor;
  ASSERT_GT(neighbor->nlist, 0);
  for (int k = 0; k < neighbor->nlist; k++) EXPECT_EQ(neighbor->lists[k]->occasional, 1);
  // where none is ever built in the run the answer is the same
  const State often = run(body());
  Block b = body();
  Session rare;
  rare(b.script());
  rare("neighbor 0.01 bin\nneigh_modify every 1000 delay 1000 check no\nrun 40");
  expect_bitwise(often, rare.state());
}

/* ----------------------------------------------------------------------
   where the frame ends
------------------------------------------------------------------------- */

// soft, so that a jump of the positions between two runs does not blow up

Block torn(const std::string &options)
{
  Block b = body("viscosity none hourglass 0 " + options);
  b.material = "inline rho0 7850 eos mie-gruneisen 3600 1.8 1.8 shear 1e5 strength elastic\n";
  b.motion = "";
  b.fixes = "fix move all sph/solid\ntimestep 1e-9\n";
  return b;
}

// turned over between two runs: the whole body is mirrored in x

const std::string MIRROR = "variable dx atom -2*x\ndisplace_atoms all move v_dx 0 0 units box\n";

TEST(Distortion, StopsWithThePlaceAndAWayOut)
{
  Session s;
  s(torn("").script());
  s("run 5");
  const std::string message = s.error(MIRROR + "run 1");
  EXPECT_THAT(message,
              HasSubstr("the deformation is beyond what this frame can follow at particle "));
  EXPECT_THAT(message,
              HasSubstr(" in step 5: its deformation gradient has turned over, with "
                        "determinant -1"));
  EXPECT_THAT(message,
              HasSubstr("Use frame eulerian for fracture, splash and self-contact, or "
                        "pair_style keyword distortion warn to go on"));
}

TEST(Distortion, NamesTheLeastStretch)
{
  Session s;
  s(torn("").script());
  EXPECT_THAT(s.error("run 5\nvariable dx atom -0.995*x\ndisplace_atoms all move v_dx 0 0 units "
                      "box\nset group all sph/rho 7850\nrun 1"),
              HasSubstr("it is squeezed flat, with a least principal stretch of 0.005"));
}

TEST(Distortion, NamesAnOverlap)
{
  Session s;
  s(torn("").script());
  const std::string message =
      s.error("run 5\ngroup a id 21\ngroup b id 22\ndisplace_atoms a move 0.000498 0 0 units box\n"
              "displace_atoms b move -0.000498 0 0 units box\nrun 1");
  EXPECT_THAT(message, HasSubstr("at particle 21 at 0.002498 "));
  EXPECT_THAT(message,
              HasSubstr("it lies on a partner, their distance over that in the reference "
                        "is 0.004"));
}

TEST(Distortion, WarnsOnceAndGoesOn)
{
  Session s;
  s(torn("distortion warn").script());
  s("run 5\n" + MIRROR + "run 100");
  EXPECT_EQ(s.value("step"), 105.0);
  const std::string log = s.log(), text = "its deformation gradient has turned over";
  const std::size_t first = log.find(text);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(log.find(text, first + 1), std::string::npos);
  EXPECT_THAT(log, HasSubstr("WARNING: sph/solid, frame lagrangian"));
}

TEST(Distortion, IgnoredIsSilent)
{
  Session s;
  s(torn("distortion ignore").script());
  s("run 5\n" + MIRROR + "run 100");
  EXPECT_EQ(s.value("step"), 105.0);
  EXPECT_THAT(s.log(), Not(HasSubstr("deformation")));
}

/* ----------------------------------------------------------------------
   fix_modify ID reference renew
------------------------------------------------------------------------- */

const std::string SHEAR = "variable dx atom 0.25*y\nvariable dy atom 0.5*x\n"
                          "displace_atoms all move v_dx v_dy 0 units box\n";

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
   particles that come and go
------------------------------------------------------------------------- */

TEST(LagrangianParticles, GoOnWithoutDeletedOnes)
{
  Session s;
  s(body().script());
  s("compute n all sph/solid/atom neigh\nrun 20");
  const double before = s.per_atom("n")[37];
  const Particle last = s.particle(37);
  s("group gone id 43 44\ndelete_atoms group gone compress no\nrun 20");
  EXPECT_THAT(s.log(),
              HasSubstr("sph/solid: 2 particles are gone, their partners go on without "
                        "them"));
  EXPECT_EQ(s.per_atom("n")[37], before - 2.0);    // above it and on its diagonal
  EXPECT_EQ(s.value("atoms"), 46.0);
  EXPECT_LT(std::fabs(s.particle(37).v[1] - last.v[1]), 100.0);
  for (const Particle &p : s.state()) EXPECT_TRUE(std::isfinite(p.x[0] + p.v[1] + p.rho));
}

TEST(LagrangianParticles, CannotBeLostDuringARun)
{
  Session s;
  Block b = body();
  b.motion += "group last id 48\nvelocity last set 0 20000 0 units box\n";
  b.box = "-0.04 0.04 -0.04 0.0072";
  b.options = "distortion ignore";
  s(b.script());
  s("thermo_modify lost ignore");
  EXPECT_THAT(s.error("run 200"), HasSubstr("particle 48 has been lost by step "));
}

// a second block is created one spacing beside the first, or far away

State with_second_block(double distance)
{
  Block b = body();
  b.fixes = "fix move all sph/solid\ntimestep 3e-8\n";
  Session s;
  s(b.script());
  s("compute n all sph/solid/atom neigh\nrun 20\nregion beside block " + num(5.9 + distance) + " " +
    num(8.1 + distance) + " -0.1 7.1 -0.1 0.1\n" +
    "create_atoms 1 region beside\ngroup new id > 48\nset group new volume 1e-6\nrun 0");
  EXPECT_EQ(s.value("atoms"), 72.0);
  EXPECT_EQ(s.per_atom("n")[49], 7.0);    // a corner, h = 1.3 spacings
  s("run 20");
  return s.state();
}

TEST(LagrangianParticles, CreatedOnesAreANewBody)
{
  const State beside = with_second_block(0.0), far = with_second_block(20.0);
  ASSERT_EQ(beside.size(), 72u);
  EXPECT_LT(largest_difference(State(far.begin(), far.begin() + 48),
                               State(beside.begin(), beside.begin() + 48)),
            1.0e-13);
  for (int i = 48; i < 72; i++)
    for (int k = 0; k < 3; k++) {
      EXPECT_EQ(beside[i].f[k], 0.0);
      EXPECT_EQ(beside[i].v[k], 0.0);
    }
}

TEST(LagrangianParticles, AreReplicatedBeforeTheFirstRun)
{
  Session s;
  Block b = body();
  s(b.particles() + "replicate 2 1 1\n" + b.interaction() +
    "variable vy atom -2e4*y\nvelocity all set NULL v_vy NULL units box\n" + b.fixes + "run 40");
  ASSERT_EQ(s.value("atoms"), 96.0);
  const State both = s.state();
  for (int i = 0; i < 48; i++) {
    EXPECT_NEAR(both[i + 48].x[0] - both[i].x[0], 0.08, 1.0e-10);
    EXPECT_NEAR(both[i + 48].x[1], both[i].x[1], 1.0e-10);
  }
}

TEST(LagrangianParticles, CannotBeReplicatedAfterwards)
{
  Session s;
  s(body().script());
  s("run 1");
  EXPECT_THAT(s.error("replicate 2 1 1"), HasSubstr("Cannot replicate"));
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

/* ----------------------------------------------------------------------
   periodic boxes
------------------------------------------------------------------------- */

// a bar along x, 12 particles, periodic.  It is sheared across the boundary by
// moving every particle in y by a wave: as the box is continuous, forces are
// those of a bar shifted by half a box

std::string periodic_bar(double shift)
{
  Block b;
  b.boundary = "p f";
  b.box = "0 0.012 -0.04 0.04";
  b.nx = 12;
  b.ny = 5;
  b.frame = "lagrangian";
  b.motion = "variable phase equal 2*PI/0.012\nvariable vx atom 100*cos(v_phase*(x-" + num(shift) +
      "))\nvariable vy atom 50*sin(v_phase*(x-" + num(shift) +
      "))*(1+100*y)\nvelocity all set v_vx v_vy NULL units box\n";
  return b.script();
}

TEST(LagrangianPeriodic, BarDoesNotFeelTheBoundary)
{
  Session a, b;
  a(periodic_bar(0.0));
  a("run 100");
  b(periodic_bar(0.006));
  b("run 100");
  const State here = a.state(), there = b.state();
  double most = 0.0;
  for (int i = 0; i < 60; i++) {
    const int j = (i / 12) * 12 + (i % 12 + 6) % 12;    // half a box further
    most = std::max(most, std::fabs(here[i].stress[0]));
    EXPECT_NEAR(here[i].stress[0], there[j].stress[0], 1.0e-9 * Y0);
    EXPECT_NEAR(here[i].v[0], there[j].v[0], 1.0e-9 * 100.0);
    EXPECT_NEAR(here[i].v[1], there[j].v[1], 1.0e-9 * 100.0);
    EXPECT_NEAR(here[i].f[1], there[j].f[1], 1.0e-9 * 1.0e6);
  }
  EXPECT_GT(most, 1.0e7);
}

// stretched sideways the bar is the same everywhere along x

TEST(LagrangianPeriodic, UniformStretchIsUniformStress)
{
  Session s;
  Block b;
  b.boundary = "p f";
  b.box = "0 0.012 -0.04 0.04";
  b.nx = 12;
  b.ny = 5;
  b.frame = "lagrangian";
  b.motion = "variable vy atom 2e4*(y-0.002)\nvelocity all set 10 v_vy 0 units box\n";
  s(b.script());
  s("compute n all sph/solid/atom neigh\nrun 300");
  ASSERT_GT(s.value("time") * 10.0, 0.0001);    // and moves through the boundary
  const State state = s.state();
  for (int i = 0; i < 60; i++) {
    const int first = i / 12 * 12;
    for (int k = 0; k < 6; k++)
      EXPECT_NEAR(state[i].stress[k], state[first].stress[k], 1.0e-9 * Y0);
    EXPECT_NEAR(state[i].v[0], 10.0, 1.0e-9);
    EXPECT_EQ(s.per_atom("n")[i + 1], s.per_atom("n")[first + 1]);
  }
  EXPECT_GT(std::fabs(state[24].stress[1]), 1.0e6);
}

// partners move apart, the communication cutoff follows, and ghosts come from further away: the
// bins of the neighbor list have to reach as far.  They are set up at the start of a run and not
// in it, so one that grew out of them was written beyond the arrays.  Soft, so that the rows fly

void expect_a_bin_for_every_ghost(const LAMMPS_NS::LAMMPS *lmp)
{
  const LAMMPS_NS::Atom *atom = lmp->atom;
  ASSERT_EQ(lmp->neighbor->nlist, 1);
  const LAMMPS_NS::NBin *bin = lmp->neighbor->lists[0]->np->nb;
  ASSERT_NE(bin, nullptr);
  const int lo[2] = {bin->mbinxlo, bin->mbinylo}, n[2] = {bin->mbinx, bin->mbiny};
  const double inverse[2] = {bin->bininvx, bin->bininvy};
  ASSERT_GT(atom->nghost, 0);
  for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; i++)
    for (int a = 0; a < 2; a++) {
      const double at = (atom->x[i][a] - lmp->domain->boxlo[a]) * inverse[a] - lo[a];
      ASSERT_TRUE(at >= 0.0 && at <= n[a])
          << "a ghost at " << atom->x[i][a] << " is " << at << " bins from the first of " << n[a];
    }
}

TEST(LagrangianPeriodic, BinsFollowTheGhostCutoff)
{
  Block b = torn("");
  b.boundary = "p f";
  b.box = "0 0.012 -0.04 0.04";
  b.nx = 12;
  b.ny = 5;
  b.material = "inline rho0 7850 eos linear 1e5 shear 1e5 strength elastic\n";
  b.motion = "variable vy atom 1e4*(y-0.002)\nvelocity all set 0 v_vy 0 units box\n";
  b.fixes = "fix move all sph/solid\ntimestep 1e-6\n";
  Session s;
  s(b.script());
  s("run 0");
  const double before = s.lmp->comm->cutghost[0];
  expect_a_bin_for_every_ghost(s.lmp);
  s("run 200");
  EXPECT_THAT(s.log(), HasSubstr("ghost cutoff enlarged"));
  EXPECT_GT(s.lmp->comm->cutghost[0], 2.0 * before);    // more than a bin and the spare one
  expect_a_bin_for_every_ghost(s.lmp);
}

TEST(LagrangianPeriodic, TriclinicBoxIsRefused)
{
  Session s;
  s("units si\ndimension 2\nboundary p p p\natom_style sph/solid\natom_modify map array\n"
    "region box prism 0 0.012 0 0.012 -0.0005 0.0005 0.002 0 0\ncreate_box 1 box\n"
    "lattice sq 0.001\ncreate_atoms 1 box\nset group all volume 1e-6\n"
    "pair_style sph/solid 1.3e-3\npair_coeff * * " +
    std::string(IRON) + NEIGHBOR + MOVE);
  EXPECT_THAT(s.error("run 0"),
              HasSubstr("sph/solid, frame lagrangian: a triclinic box cannot be periodic"));
}

TEST(LagrangianPeriodic, ChangingBoxIsRefused)
{
  Session s;
  s(periodic_bar(0.0));
  EXPECT_THAT(s.error("fix pull all deform 1 x erate 1e3\nrun 1"),
              HasSubstr("sph/solid, frame lagrangian: a periodic box cannot change its size"));
}

TEST(LagrangianPeriodic, ShortBoxIsRefused)
{
  Session s;
  Block b;
  b.boundary = "p f";
  b.box = "0 0.004 -0.04 0.04";    // the particle 2 mm to the right is the one 2 mm to the left
  b.nx = 4;
  b.ny = 5;
  b.frame = "lagrangian";
  s(b.script());
  EXPECT_THAT(s.error("run 0"),
              HasSubstr("sees the same partner twice: the periodic box must be longer than two "
                        "ranges of the kernel"));
}

}    // namespace
