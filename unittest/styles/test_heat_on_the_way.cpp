/* ----------------------------------------------------------------------
   The Lagrangian frame heats particles in the sweeps of the next force evaluation, unless
   another fix may have changed velocities in between: then a sweep of its own does it.  Both
   are the work of the pair forces on the kick, so both give the same.
------------------------------------------------------------------------- */

#include "lagrangian_block.h"
#include "neighbor.h"

using namespace sphsolid_test;

namespace {

// a fix that does nothing here and could change velocities: the box has no wall in reach
const std::string BYSTANDER = "fix far all wall/reflect xlo EDGE\n";

Block heated(const std::string &options)
{
  Block b = body(options);
  b.fixes += "neighbor 0.0001 bin\nneigh_modify every 1 delay 0 check yes\n";
  b.fixes += "compute energy all sph/solid/energy\n";
  return b;
}

struct Outcome {
  State state;
  double total, viscous, returned, hourglass;
};

Outcome outcome(const Block &b, const std::string &bystander)
{
  Session s;
  s(b.script());
  s(bystander);
  s("fix step all sph/solid/dt 5 0.5\nrun 60");
  EXPECT_GT(s.lmp->neighbor->ncalls, 2);    // new neighbors in between
  auto energy = [&](int k) {
    return s.value("c_energy[" + std::to_string(k) + "]");
  };
  return {s.state(), s.value("c_energy"), energy(5), energy(6), energy(8)};
}

class HeatOnTheWay : public testing::TestWithParam<const char *> {};

}    // namespace

TEST_P(HeatOnTheWay, IsThatOfASweepOfItsOwn)
{
  const Block b = heated(GetParam());
  const Outcome way = outcome(b, ""), sweep = outcome(b, BYSTANDER);
  EXPECT_LT(largest_difference(way.state, sweep.state), 1.0e-11);
  EXPECT_NEAR(way.total, sweep.total, 1.0e-13 * std::fabs(sweep.total));
  const double scale = std::fabs(sweep.viscous) + std::fabs(sweep.returned) + sweep.hourglass;
  EXPECT_GT(scale, 0.0);
  EXPECT_NEAR(way.viscous, sweep.viscous, 1.0e-10 * scale);
  EXPECT_NEAR(way.returned, sweep.returned, 1.0e-10 * scale);
  EXPECT_NEAR(way.hourglass, sweep.hourglass, 1.0e-10 * scale);
}

// particles of different masses in three dimensions, where a row has the mass beside the velocity;
// in units in which it is as large as all else

TEST_P(HeatOnTheWay, DoesNotSeeMasses)
{
  const std::string script =
      std::string("units lj\ndimension 3\nboundary f f f\natom_style sph/solid\n"
                  "atom_modify map array\nregion box block -9 13 -9 13 -9 13\ncreate_box 1 box\n"
                  "lattice sc 1.0\nregion body block -0.1 3.1 -0.1 4.1 -0.1 4.1\n"
                  "create_atoms 1 region body\nvariable part atom \"1.0+0.2*(id%4)\"\n"
                  "set group all volume v_part\npair_style sph/solid 1.2 ") +
      GetParam() +
      "\npair_coeff * * inline rho0 1 eos linear 1.0 shear 0.4 strength elastic\n"
      "neighbor 0.1 bin\nneigh_modify every 1 delay 0 check yes\n"
      "variable vx atom -0.05*x*(1+y)\nvariable vz atom 0.04*y*y\n"
      "velocity all set v_vx 0.02 v_vz units box\nfix move all sph/solid\ntimestep 0.1\n"
      "compute energy all sph/solid/energy\nthermo_style custom step c_energy\n";
  double total[2], viscous[2], hourglass[2];
  for (int k = 0; k < 2; k++) {
    Session s;
    s(script);
    if (k) s(BYSTANDER);
    s("run 40");
    total[k] = s.value("c_energy");
    viscous[k] = s.value("c_energy[5]");
    hourglass[k] = s.value("c_energy[8]");
  }
  EXPECT_NEAR(total[0], total[1], 1.0e-12 * total[1]);
  EXPECT_NEAR(viscous[0], viscous[1], 1.0e-10 * total[1]);
  EXPECT_NEAR(hourglass[0], hourglass[1], 1.0e-10 * total[1]);
  EXPECT_GT(viscous[1] + hourglass[1], 1.0e-4 * total[1]);
}

// weights shepard and safe and the printed heating have a sweep of their own anyway (can_keep_heat() in
// unittest/physics/test_lagrangian_conservation.cpp): two runs of them would be the same one
INSTANTIATE_TEST_SUITE_P(Viscosities, HeatOnTheWay,
                         testing::Values("viscosity none", "viscosity monaghan 1 1",
                                         "viscosity correct", "viscosity limited 1 1",
                                         "viscosity front", "viscosity correct hourglass 0",
                                         "viscosity correct hbar 0.9"));

class HeatOfASweep : public testing::TestWithParam<const char *> {};

// nothing depends on the bystander
TEST_P(HeatOfASweep, IsTheSameBesideAnotherFix)
{
  const Block b = heated(GetParam());
  const Outcome alone = outcome(b, ""), beside = outcome(b, BYSTANDER);
  EXPECT_EQ(largest_difference(alone.state, beside.state), 0.0);
  EXPECT_EQ(alone.total, beside.total);
}

INSTANTIATE_TEST_SUITE_P(Weights, HeatOfASweep,
                         testing::Values("viscosity correct weights shepard",
                                         "viscosity correct weights safe",
                                         "viscosity correct heating printed"));
