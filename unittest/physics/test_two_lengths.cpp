/* ----------------------------------------------------------------------
   Two smoothing lengths in one body (frame eulerian): the kernel of a pair has
   the mean of both.  Bodies with one length have sums of their own, which do not
   read it from every neighbor.
------------------------------------------------------------------------- */

#include "sums.h"

#include <gtest/gtest.h>

#include <tuple>

using namespace SPHSolid;

namespace {

using Choice = std::tuple<int, Viscosity, bool, bool>;    // dimension, .., corrected, tensile

class Lengths : public testing::TestWithParam<Choice> {
 protected:
  Cloud cloud() const
  {
    auto [dim, viscosity, corrected, tensile] = GetParam();
    Cloud c = random_cloud(dim);
    c.opt.viscosity = viscosity;
    c.opt.corrected = corrected;
    c.opt.tensile = tensile;
    c.opt.tensile_eps = 0.3;
    return c;
  }
};

TEST_P(Lengths, OneThatNobodyHasChangesNothing)
{
  Cloud c = cloud();
  ASSERT_EQ(c.evaluate(0.01), -1);
  const std::vector<Vector3d> f = forces(c), u = random_displacement(c, 3);
  const std::vector<double> heat = c.heat(u);

  Cloud more = cloud();
  more.other_h = 1.1;
  ASSERT_EQ(more.evaluate(0.01), -1);
  EXPECT_LT(largest_difference(f, forces(more)), 1e-13 * largest(f));
  std::vector<double> difference = more.heat(u);
  for (int i = 0; i < c.size(); i++) difference[i] -= heat[i];
  EXPECT_LT(largest(difference), 1e-13 * largest(heat));
}

// of particles that another pair style has, as in a hybrid: neither a smoothing length nor a spacing

TEST_P(Lengths, TypesWithoutMaterialChangeNothing)
{
  Cloud c = cloud(), beside = cloud();
  beside.strange_spacing = 3.0;
  ASSERT_EQ(c.evaluate(0.01), -1);
  ASSERT_EQ(beside.evaluate(0.01), -1);
  for (int i = 0; i < c.size(); i++) ASSERT_EQ(c.f(i), beside.f(i)) << i;
}

TEST_P(Lengths, MomentumAndEnergyAreConserved)
{
  Cloud c = cloud();
  c.other_h = 1.6;
  for (int i = 0; i < c.size(); i += 2) c.others.push_back(i);
  ASSERT_EQ(c.evaluate(0.01), -1);
  EXPECT_LT(net_force(c), 1e-14);
  EXPECT_LT(energy_error(c, random_displacement(c, 3)), 1e-14);
  EXPECT_LT(virial_error(c), 1e-14);
}

std::string name(const testing::TestParamInfo<Choice> &info)
{
  auto [dim, viscosity, corrected, tensile] = info.param;
  return name_of(viscosity) + (corrected ? "" : "Plain") + (tensile ? "Tensile" : "") +
      (dim == 2 ? "2D" : "3D");
}

INSTANTIATE_TEST_SUITE_P(Options, Lengths,
                         testing::Combine(testing::Values(2, 3), testing::ValuesIn(VISCOSITIES),
                                          testing::Bool(), testing::Bool()),
                         name);

}    // namespace

// standard viscosity of two particles by hand: h = 1 and 1.5, r = 1.25, closing at 0.2, so that
// the kernel's slope is that at q = 1, -(3/4) 10/(7 pi h^3), and mu = -0.2/(1 + 0.01)

TEST(TwoLengths, PairHasTheMean)
{
  Cloud c = closing_pair(1.25);
  c.opt.h = 1.0;
  c.other_h = 1.5;
  c.others = {1};
  c.opt.viscosity = Viscosity::MONAGHAN;
  c.evaluate();
  const double mu = -0.2 / 1.01, Pi = -mu + mu * mu, slope = -30.0 / (28.0 * M_PI) / 1.953125;
  EXPECT_NEAR(c.f(0)[0], Pi * slope, SINGLE * Pi * std::fabs(slope));
  EXPECT_NEAR(c.f(0)[0] + c.f(1)[0], 0.0, 1e-16);
}
