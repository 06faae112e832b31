/* ----------------------------------------------------------------------
   Bodies that are periodic in the Lagrangian frame: they do not feel the boundary.
------------------------------------------------------------------------- */

#include "lagrangian_block.h"

#include "domain.h"
#include "nbin.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "npair.h"

using namespace sphsolid_test;

namespace {

// a bar along x, 12 particles, periodic

Block bar()
{
  Block b;
  b.boundary = "p f";
  b.box = "0 0.012 -0.04 0.04";
  b.nx = 12;
  b.ny = 5;
  b.frame = "lagrangian";
  return b;
}

// it is sheared across the boundary by
// moving every particle in y by a wave: as the box is continuous, forces are
// those of a bar shifted by half a box

std::string sheared_bar(double shift)
{
  Block b = bar();
  b.motion = "variable phase equal 2*PI/0.012\nvariable vx atom 100*cos(v_phase*(x-" + num(shift) +
      "))\nvariable vy atom 50*sin(v_phase*(x-" + num(shift) +
      "))*(1+100*y)\nvelocity all set v_vx v_vy NULL units box\n";
  return b.script();
}

TEST(LagrangianPeriodic, BarDoesNotFeelTheBoundary)
{
  Session a, b;
  a(sheared_bar(0.0));
  a("run 100");
  b(sheared_bar(0.006));
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
  Block b = bar();
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

// a body that spins, shears and flies round the box three times in x and twice in y is the same as
// one that has room.  It lies across the boundary in the reference, too

TEST(LagrangianPeriodic, BodyFliesRoundTheBox)
{
  Block b = body();
  b.fixes = "fix move all sph/solid\ntimestep 5e-8\n";
  b.motion = "variable vx atom 6e3+5e3*y\nvariable vy atom -6e3-2e4*x*(1+100*y)\n"
             "velocity all set v_vx v_vy NULL units box\n"
             "displace_atoms all move 0.006 0.008 0 units box\n";
  b.boundary = "f f";
  b.box = "-0.1 0.1 -0.1 0.1";
  const State free = run(b, "run 120");
  b.boundary = "p p";
  b.box = "-0.002 0.010 -0.003 0.012";
  const State round = run(b, "run 120");
  double most = 0.0;
  for (std::size_t i = 0; i < free.size(); i++) {
    for (int k = 0; k < 4; k++) {
      most = std::max(most, std::fabs(free[i].stress[k]));
      EXPECT_NEAR(round[i].stress[k], free[i].stress[k], 1.0e-8 * Y0);
    }
    for (int k = 0; k < 2; k++) EXPECT_NEAR(round[i].v[k], free[i].v[k], 1.0e-8 * 6.0e3);
  }
  EXPECT_GT(most, 0.3 * Y0);
}

// the bar, soft, so that its rows fly apart

Block flying_rows(const std::string &modulus)
{
  Block b = bar();
  b.options = "viscosity none hourglass 0";
  b.material =
      "inline rho0 7850 eos linear " + modulus + " shear " + modulus + " strength elastic\n";
  b.motion = "variable vy atom 1e4*(y-0.002)\nvelocity all set 0 v_vy 0 units box\n";
  b.fixes = "fix move all sph/solid\ntimestep 1e-6\n";
  return b;
}

// partners move apart, the communication cutoff follows, and ghosts come from further away: the
// bins of the neighbor list have to reach as far.  They are set up at the start of a run and not
// in it, so one that grew out of them was written beyond the arrays

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
  Session s;
  s(flying_rows("1e5").script());
  s("run 0");
  const double before = s.lmp->comm->cutghost[0];
  expect_a_bin_for_every_ghost(s.lmp);
  s("run 200");
  EXPECT_THAT(s.log(), HasSubstr("ghost cutoff enlarged"));
  EXPECT_GT(s.lmp->comm->cutghost[0], 2.0 * before);    // more than a bin and the spare one
  expect_a_bin_for_every_ghost(s.lmp);
}

// its rows fly apart until another image of a partner is nearly as close as the partner

TEST(LagrangianPeriodic, PartnersHalfABoxApartAreAnError)
{
  Block b = flying_rows("1e2");
  b.boundary = "p p";
  b.box = "0 0.012 -0.01 0.014";
  Session s;
  s(b.script());
  s("run 400");    // rows that were 2 mm apart are 10 mm apart now, half the box are 12
  EXPECT_THAT(s.error("run 100"),
              HasSubstr("nearly half the periodic box: expected one longer than"));
}

// where they fly at once, no ghost cutoff follows them: it would be that of as many images of the box

TEST(LagrangianPeriodic, PartnersThatExplodeAreAnError)
{
  for (const char *step : {"1e-3", "1e-5"}) {
    Block b = body();
    b.boundary = "p p";
    b.box = "-0.02 0.04 -0.02 0.04";
    b.fixes = std::string("fix move all sph/solid\ntimestep ") + step + "\n";
    Session s;
    s(b.script());
    EXPECT_THAT(
        s.error("run 100"),
        testing::ContainsRegex("particle [0-9]+ at .* and its partner [0-9]+ are .* apart in "
                               "step [0-9]+, nearly half the periodic box"))
        << step;
    EXPECT_LT(s.lmp->comm->cutghost[0], 0.06) << step;
  }
}

// fix balance wraps particles round the box before partners are looked at

TEST(LagrangianPeriodic, BalanceDoesNotTearPartnersApart)
{
  Block b = body();
  b.boundary = "p p";
  b.box = "-0.002 0.010 -0.003 0.012";
  b.motion = "velocity all set 6e3 -6e3 0 units box\n";
  b.fixes = "fix even all balance 10 1.0 shift xy 5 1.0\nfix move all sph/solid\ntimestep 5e-8\n";
  Session s;
  s(b.script());
  s("run 120");
  EXPECT_THAT(s.log(), Not(HasSubstr("ghost cutoff enlarged")));
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

// partners would lie exactly where they end, at 1.98h, and distances across the boundary are rounded in
// one way from one side and in another from the other

TEST(LagrangianPeriodic, PartnersAtTheEndOfTheKernelAreMutual)
{
  for (const double h : {1.0e-3 / 0.99, 2.0e-3 / 1.98}) {
    Block b;
    b.boundary = "p p";
    b.box = "0 0.02 0 0.02";
    b.nx = b.ny = 20;
    b.h = h;
    b.options = "viscosity none";
    b.frame = "lagrangian";
    b.motion = "variable vx atom 10+2*sin(2*PI*x/lx)+sin(2*PI*y/ly)\n"
               "variable vy atom 5+2*sin(2*PI*y/ly)\nvelocity all set v_vx v_vy 0 units box\n";
    Session s;
    s(b.script());
    s("compute n all sph/solid/atom neigh\ncompute few all reduce min c_n\n"
      "compute many all reduce max c_n\nthermo_style custom step c_few c_many\n"
      "variable px equal vcm(all,x)\nvariable py equal vcm(all,y)\nrun 0");
    EXPECT_EQ(s.value("c_few"), 8.0);
    EXPECT_EQ(s.value("c_many"), 8.0);
    const double px = s.value("v_px"), py = s.value("v_py");
    s("run 500");
    EXPECT_NEAR(s.value("v_px"), px, 1.0e-12 * px);
    EXPECT_NEAR(s.value("v_py"), py, 1.0e-12 * px);
  }
}

TEST(LagrangianPeriodic, ChangingBoxIsRefused)
{
  Session s;
  s(sheared_bar(0.0));
  EXPECT_THAT(s.error("fix pull all deform 1 x erate 1e3\nrun 1"),
              HasSubstr("sph/solid, frame lagrangian: a periodic box cannot change its size"));
}

TEST(LagrangianPeriodic, ShortBoxIsRefused)
{
  Session s;
  Block b = bar();
  b.box = "0 0.004 -0.04 0.04";    // the particle 2 mm to the right is the one 2 mm to the left
  b.nx = 4;
  s(b.script());
  EXPECT_THAT(s.error("run 0"),
              HasSubstr("sees the same partner twice: the periodic box must be longer than two "
                        "ranges of the kernel"));
}

}    // namespace
