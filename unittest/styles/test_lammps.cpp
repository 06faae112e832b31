/* ----------------------------------------------------------------------
   Life together with the rest of LAMMPS: other commands, fixes, computes,
   hybrid styles, several instances.
------------------------------------------------------------------------- */

#include "session.h"

using namespace sphsolid_test;

namespace {

Block body()
{
  Block b;
  b.nx = 8;
  b.ny = 10;
  b.fixes += "fix floor all sph/solid/wall ylo 0.0\n";
  return b;
}

State reference(const std::string &run = "run 60")
{
  Session s;
  s(body().script());
  s(run);
  return s.state();
}

/* ----------------------------------------------------------------------
   styles of atoms and pairs
------------------------------------------------------------------------- */

class HybridAtoms : public testing::TestWithParam<std::string> {};

TEST_P(HybridAtoms, ChangeNothing)
{
  Block b = body();
  b.style = "hybrid " + GetParam();
  if (GetParam().find("sphere") != std::string::npos)    // its particles are born with a mass
    b.motion += "set group all mass 0.00785\n";
  Session s;
  s(b.script());
  s("run 60");
  expect_bitwise(reference(), s.state());
}

INSTANTIATE_TEST_SUITE_P(Style, HybridAtoms,
                         testing::Values("sph/solid", "sph/solid charge", "charge sph/solid",
                                         "atomic sph/solid", "sph/solid sphere"),
                         [](const auto &info) {
                           return "set" + std::to_string(info.index);
                         });

TEST(HybridPair, AloneChangesNothing)
{
  Session s;
  s(body().particles());
  s("pair_style hybrid sph/solid 1.3e-3 frame " + frame_under_test() +
    "\npair_coeff * * sph/solid " + std::string(IRON) + "neighbor 0.0003 bin\n" + body().motion +
    body().fixes + "run 60");
  expect_bitwise(reference(), s.state());
}

class HybridOverlay : public testing::TestWithParam<std::string> {};

TEST_P(HybridOverlay, WithoutForceChangesNothing)
{
  Session s;
  s(body().particles());
  s("pair_style hybrid/overlay sph/solid 1.3e-3 frame " + frame_under_test() + " " + GetParam() +
    "\npair_coeff * * sph/solid " + IRON);
  s(GetParam().find("zero") == 0 ? "pair_coeff * * zero" : "pair_coeff * * lj/cut 0.0 1e-3");
  s("neighbor 0.0003 bin\n" + body().motion + body().fixes + "run 60");
  EXPECT_LT(largest_difference(reference(), s.state()), 1.0e-15);
}

INSTANTIATE_TEST_SUITE_P(Other, HybridOverlay, testing::Values("zero 3e-3", "lj/cut 2e-3"),
                         [](const auto &info) {
                           return "set" + std::to_string(info.index);
                         });

// a type of another pair style lies in the way: neither sees the other

TEST(HybridPair, LeavesParticlesOfOtherStylesAlone)
{
  Session s;
  s("units si\ndimension 2\nboundary f f p\natom_style sph/solid\natom_modify map array\n"
    "region box block -0.04 0.04 -0.04 0.04 -0.0005 0.0005\ncreate_box 2 box\nlattice sq 0.001\n"
    "region body block -0.1 7.1 -0.1 9.1 -0.1 0.1\ncreate_atoms 1 region body\n"
    "create_atoms 2 single 0.0095 0.005 0 units box\nset type 1 volume 1e-6\nset type 2 mass 1\n"
    "pair_style hybrid sph/solid 1.3e-3 frame " +
    frame_under_test() + " zero 3e-3\npair_coeff 1 1 sph/solid " + std::string(IRON) +
    "pair_coeff 1 2 zero\npair_coeff 2 2 zero\nneighbor 0.0003 bin\ngroup body type 1\n"
    "velocity body set 0 -200 0 units box\n"
    "fix move body sph/solid\nfix step body sph/solid/dt 1 0.3\nfix floor body sph/solid/wall ylo "
    "0.0\n"
    "run 60");
  State state = s.state();
  const Particle other = state.back();
  EXPECT_EQ(other.id, 81.0);
  for (int k = 0; k < 3; k++) EXPECT_EQ(other.f[k], 0.0);
  state.pop_back();
  expect_bitwise(reference(), state);
}

/* ----------------------------------------------------------------------
   instances
------------------------------------------------------------------------- */

TEST(Instances, SideBySideDoNotMeet)
{
  Session a, b;
  a(body().script());
  b(body().script());
  a("run 30");
  b("run 60");
  a("run 30");
  expect_bitwise(a.state(), b.state());
  expect_bitwise(a.state(), reference());
}

TEST(Instances, AfterClearStartAgain)
{
  Session s;
  for (int k = 0; k < 3; k++) {
    s("clear");
    s(body().script());
    s("run 60");
    expect_bitwise(reference(), s.state());
  }
}

TEST(Instances, WithASecondAtomStyleCommand)
{
  Session s;
  s("atom_style atomic\natom_style sph/solid");
  s(body().script());
  s("run 60");
  expect_bitwise(reference(), s.state());
}

/* ----------------------------------------------------------------------
   commands that change the set of particles
------------------------------------------------------------------------- */

TEST(Commands, ReplicateCopiesTheState)
{
  Session s;
  Block b = body();
  b.fixes = "";
  s(b.script());
  s("fix move all sph/solid\nfix step all sph/solid/dt 1 0.3\nrun 20\nreplicate 2 1 1");
  const State state = s.state();
  ASSERT_EQ(state.size(), 160u);
  for (int i = 0; i < 80; i++) {
    EXPECT_NEAR(state[i + 80].x[0] - state[i].x[0], 0.08, 1.0e-12);
    EXPECT_EQ(state[i + 80].mass, state[i].mass);
    EXPECT_EQ(state[i + 80].rho, state[i].rho);
  }
}

TEST(Commands, DeletedParticlesAreGone)
{
  Session s;
  s(body().script());
  s("run 20\nregion top block INF INF 6.5 INF INF INF\ndelete_atoms region top compress no\nrun "
    "20");
  EXPECT_EQ(s.value("atoms"), 56.0);
  for (const Particle &p : s.state()) EXPECT_TRUE(std::isfinite(p.x[0] + p.v[1] + p.rho));
}

TEST(Commands, CreatedParticlesTakePart)
{
  Session s;
  s(body().script());
  s("run 5\ncreate_atoms 1 single 0.003 0.02 0 units box\ngroup new id 81\nset group new volume "
    "1e-6\n"
    "velocity new set 0 -200 0 units box\nrun 5");
  EXPECT_DOUBLE_EQ(s.particle(81).mass, 7850.0e-6);
  EXPECT_EQ(s.particle(81).v[1], -200.0);
}

TEST(Commands, SetMassAndDensityWinOverTheCard)
{
  Session s;
  s(body().script());
  s("set atom 3 mass 0.01\nset atom 4 sph/rho 8000\nrun 0");
  EXPECT_EQ(s.particle(3).mass, 0.01);
  EXPECT_NEAR(s.particle(3).rho, 1.0e4, 1.0e-8);    // mass/volume: rest at another density
  EXPECT_EQ(s.particle(4).rho, 8000.0);
  EXPECT_DOUBLE_EQ(s.particle(4).mass, 7850.0e-6);
}

TEST(Commands, SetEnergyHeats)
{
  Session s;
  s(body().script());
  s("compute p all sph/solid/atom p\nset atom 3 sph/e 1000\nrun 0");
  EXPECT_NEAR(s.per_atom("p")[3], GAMMA * RHO0 * 1000.0, 1.0);
}

TEST(Commands, RegionsChooseParticles)
{
  Session s;
  s(body().script());
  s("region left block INF 3.5 INF INF INF INF\ngroup left region left\n"
    "set region left volume 0.5e-6\nrun 0");
  EXPECT_DOUBLE_EQ(s.particle(1).mass, 0.5 * 7850.0e-6);
  EXPECT_DOUBLE_EQ(s.particle(8).mass, 7850.0e-6);
}

/* ----------------------------------------------------------------------
   fixes
------------------------------------------------------------------------- */

TEST(Fixes, GroupWithoutIntegratorIsClamped)
{
  Block b = body();
  b.fixes = "region low block INF INF INF 1.5 INF INF\ngroup low region low\n"
            "group free subtract all low\nvelocity low set 0 0 0\nfix move free sph/solid\n"
            "fix step all sph/solid/dt 1 0.3\ncompute e all sph/solid/energy\n";
  Session s;
  s(b.script());
  s("run 0");
  const double before = s.value("c_e");
  s("run 100");
  const State state = s.state();
  for (int i = 0; i < 16; i++) EXPECT_EQ(state[i].x[1], (i < 8) ? 0.0 : 0.001);
  EXPECT_GT(std::fabs(state[3].stress[0]), 1.0e7);    // yet it carries stress
  EXPECT_NEAR(s.value("c_e"), before, 1.0e-10 * before);
}

TEST(Fixes, TwoIntegratorsOfTwoGroupsEqualOne)
{
  Block b = body();
  b.fixes = "region low block INF INF INF 3.5 INF INF\ngroup low region low\n"
            "group high subtract all low\nfix a high sph/solid\nfix b low sph/solid\n"
            "fix step all sph/solid/dt 1 0.3\nfix floor all sph/solid/wall ylo 0.0\n";
  Session s;
  s(b.script());
  s("run 60");
  expect_bitwise(reference(), s.state());
}

TEST(Fixes, SetforceHoldsAVelocity)
{
  Session s;
  s(body().script());
  s("region top block INF INF 8.5 INF INF INF\ngroup top region top\n"
    "fix hold top setforce 0 0 0\nrun 60");
  for (int id = 73; id <= 80; id++) {
    EXPECT_EQ(s.particle(id).v[0], 0.0);
    EXPECT_EQ(s.particle(id).v[1], -200.0);
  }
}

TEST(Fixes, AddforceAccelerates)
{
  Session s;
  Block b = body();
  b.motion = "";
  b.fixes = "fix move all sph/solid\ntimestep 1e-8\nfix push all addforce 0.785 0 0\n";
  s(b.script());
  s("run 100");
  // a = F/m = 100 m/s^2 for 1 us
  EXPECT_NEAR(s.particle(40).v[0], 1.0e-4, 1.0e-12);
}

TEST(Fixes, MomentumIsRemoved)
{
  Session s;
  Block b = body();
  b.fixes = "fix move all sph/solid\nfix step all sph/solid/dt 1 0.3\nfix stop all momentum 1 "
            "linear 1 1 1\n";
  s(b.script());
  s("run 5");
  EXPECT_NEAR(s.value("vcm(all,y)"), 0.0, 1.0e-10);
}

// at rest: h/(c_L + 0.6 a1 c/2) of iron with viscosity correct, times the Courant number
// that the documentation of the fix gives for each frame

// of the Lagrangian frame, as the log has it; test_courant_number.cpp says whether it is right

double auto_courant_number(const Session &s)
{
  const std::string log = s.log(), before = "dt auto takes ";
  const auto at = log.find(before);
  return at == std::string::npos ? NAN : std::stod(log.substr(at + before.size()));
}

TEST(Fixes, AutoTimeStep)
{
  Session s;
  Block b = body();
  b.motion = "";
  b.options = "viscosity correct";
  b.fixes = "fix move all sph/solid\nfix step all sph/solid/dt 1 auto\n";
  s(b.script());
  s("run 0");
  const double c = 3600.0, c_l = std::sqrt(c * c + 4.0 * 80.0e9 / (3.0 * 7850.0));
  const double courant = b.frame == "lagrangian" ? auto_courant_number(s) : 0.5;
  EXPECT_NEAR(s.value("dt"), courant * b.h / (c_l + 0.3 * c), 1.0e-12 * b.h / c);
}

/* ----------------------------------------------------------------------
   without an energy equation
------------------------------------------------------------------------- */

const char COLD_IRON[] = "inline rho0 7850 shear 80e9 eos mie-gruneisen 3600 1.8 0 strength "
                         "perfect 600e6\n";

State cold(const std::string &energy)
{
  Block b = body();
  b.options = "viscosity correct energy " + energy;
  b.material = COLD_IRON;
  Session s;
  s(b.script());
  s("run 60");
  return s.state();
}

// with Gamma = 0 nothing depends on the internal energy, which stays what it was

TEST(NoEnergy, MovesTheSame)
{
  State with = cold("yes");
  const State without = cold("no");
  EXPECT_GT(with[3].e, 0.0);
  for (auto &particle : with) particle.e = 0.0;
  expect_bitwise(with, without);
}

TEST(NoEnergy, RefusesMaterialsThatNeedIt)
{
  Block b = body();
  b.options = "energy no";
  Session s;
  s(b.script());
  EXPECT_THAT(
      s.error("run 0"),
      HasSubstr("Pair style sph/solid: the pressure of type 1 depends on its internal "
                "energy, Gamma = 1.8: expected energy yes, or eos mie-gruneisen with Gamma 0"));
}

TEST(NoEnergy, RefusesOutputOfEnergies)
{
  Block b = body();
  b.options = "energy no";
  b.material = COLD_IRON;
  for (const std::string compute : {"energy", "atom rho e"}) {
    Session s;
    s(b.script());
    s("compute one all sph/solid/" + compute);
    EXPECT_THAT(s.error("run 0"),
                HasSubstr("needs an energy equation: expected pair_style "
                          "sph/solid ... energy yes"));
  }
}

TEST(Fixes, HaltStopsAtATime)
{
  Session s;
  s(body().script());
  s("variable t equal time\nfix stop all halt 1 v_t >= 1e-6 error continue message no\nrun 1000");
  EXPECT_GE(s.value("time"), 1.0e-6);
  EXPECT_LT(s.value("time"), 1.0e-6 + 2.0 * s.value("dt"));
}

TEST(Fixes, AverageOverAtomsAndTime)
{
  Session s;
  s(body().script());
  s("compute a all sph/solid/atom rho vonmises\ncompute e all sph/solid/energy\n"
    "fix atoms all ave/atom 2 5 10 c_a[1] c_a[2]\nfix time all ave/time 2 5 10 c_e c_e[1]\n"
    "run 20");
  s("variable rho atom f_atoms[1]\ncompute least all reduce min v_rho\nrun 0");
  EXPECT_GT(s.value("c_least"), 7000.0);
  EXPECT_GT(s.value("f_time[1]"), s.value("f_time[2]"));
}

TEST(Fixes, BoxThatFollowsTheBodyKeepsIt)
{
  Session s;
  Block b = body();
  b.boundary = "m m";
  s(b.script());
  s("run 60");
  EXPECT_EQ(s.value("atoms"), 80.0);
}

/* ----------------------------------------------------------------------
   output
------------------------------------------------------------------------- */

TEST(Output, PropertyAtomKnowsOurNames)
{
  Session s;
  s(body().script());
  s("compute q all property/atom rho esph epl sdev_xx sdev_yy sdev_zz sdev_xy sdev_xz sdev_yz\n"
    "compute t all reduce sum c_q[*]\nthermo_style custom step c_t[*]\nrun 40");
  for (const Particle &p : s.state()) {
    const int id = static_cast<int>(p.id);
    EXPECT_EQ(s.per_atom("q", 0)[id], p.rho);
    EXPECT_EQ(s.per_atom("q", 1)[id], p.e);
    EXPECT_EQ(s.per_atom("q", 2)[id], p.epl);
    for (int k = 0; k < 6; k++) EXPECT_EQ(s.per_atom("q", 3 + k)[id], p.stress[k]);
  }
}

TEST(Output, PropertyAtomRefusesOtherNames)
{
  Session s;
  s(body().script());
  EXPECT_THAT(s.error("compute q all property/atom sigma"), HasSubstr("sigma"));
}

TEST(Output, DumpCustomWritesColumns)
{
  Session s;
  s(body().script());
  const std::string path = file("columns.dump");
  s("compute a all sph/solid/atom h neigh\ndump d all custom 10 " + path +
    " id x y vx vy mass c_a[1] c_a[2]\ndump_modify d sort id\nrun 10");
  const std::string text = read_file(path);
  EXPECT_THAT(text, HasSubstr("ITEM: ATOMS id x y vx vy mass c_a[1] c_a[2]"));
  // first particle at the start: corner of a square lattice, h = 1.3 spacings, 8 within 2.6
  EXPECT_THAT(text, HasSubstr("\n1 0 0 0 -200 0.00785 0.0013 7"));
}

}    // namespace
