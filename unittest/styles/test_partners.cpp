/* ----------------------------------------------------------------------
   Partners for life in the Lagrangian frame: its defaults, partners under stretch, no
   neighbor lists during a run, and what becomes of particles that come and go.
------------------------------------------------------------------------- */

#include "lagrangian_block.h"

#include "neigh_list.h"
#include "neighbor.h"

using namespace sphsolid_test;

namespace {

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
                          "error energy yes")),
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

// its pages are given back then, and others may have made theirs from it, or ask for it later

TEST(LagrangianPartners, LeaveOthersTheirNeighborList)
{
  Session s;
  s(body().script());
  s("run 0");
  ASSERT_EQ(s.lmp->neighbor->nlist, 1);
  EXPECT_EQ(s.lmp->neighbor->lists[0]->inum, 0);
  Session other;
  other(body().script());
  other("compute count all coord/atom cutoff 0.0015\nthermo_style custom step pe\nrun 0");
  for (int run = 0; run < 2; run++) {
    const std::map<int, double> count = other.per_atom("count");
    EXPECT_EQ(count.at(1), 3.0);    // a corner of 6 x 8 particles
    EXPECT_EQ(count.at(2), 5.0);    // on an edge
    EXPECT_EQ(count.at(8), 8.0);    // inside
    other("fix_modify move reference renew\nrun 0");
  }
  expect_bitwise(run(body(), "run 0"), other.state());
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

}    // namespace
