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

INSTANTIATE_TEST_SUITE_P(
    Viscosities, HeatOnTheWay,
    testing::Values("viscosity none", "viscosity monaghan 1 1", "viscosity correct",
                    "viscosity correct weights shepard", "viscosity correct weights safe",
                    "viscosity correct heating printed", "viscosity limited 1 1", "viscosity front",
                    "viscosity correct hourglass 0", "viscosity correct hbar 0.9"));
