/* ----------------------------------------------------------------------
   Nothing depends on how the work is ordered or shared out.
------------------------------------------------------------------------- */

#include "cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace SPHSolid;

namespace {

class OrderOfWork : public testing::TestWithParam<Viscosity> {};

std::string viscosity_name(const testing::TestParamInfo<Viscosity> &info)
{
  return name_of(info.param);
}

}    // namespace

// every particle sums its own row: threads cannot change a bit

TEST_P(OrderOfWork, ThreadsAreBitwiseEqual)
{
  for (int dim : {2, 3}) {
    Cloud one = random_cloud(dim), two = random_cloud(dim);
    one.opt.viscosity = two.opt.viscosity = GetParam();
    two.nthreads = 2;
    one.evaluate(0.1);
    two.evaluate(0.1);
    for (int i = 0; i < one.size(); i++) ASSERT_EQ(one.f(i), two.f(i));
    EXPECT_EQ(one.rho, two.rho);
    EXPECT_EQ(one.S, two.S);
    EXPECT_EQ(one.heat(one.v), two.heat(two.v));
  }
}

// nor does that of neighbors matter: sums are in the order of IDs

TEST_P(OrderOfWork, NeighborsInAnyOrder)
{
  for (int dim : {2, 3}) {
    Cloud one = random_cloud(dim), two = random_cloud(dim);
    one.opt.viscosity = two.opt.viscosity = GetParam();
    two.shuffle = 7;
    one.evaluate(0.1);
    two.evaluate(0.1);
    for (int i = 0; i < one.size(); i++) ASSERT_EQ(one.f(i), two.f(i));
    EXPECT_EQ(one.rho, two.rho);
  }
}

// many particles whose numbers say nothing of where they are: columns are in the order of positions, and
// where these have no order either most slots are gathered

TEST_P(OrderOfWork, NumbersWithoutOrder)
{
  for (int dim : {2, 3})
    for (double jitter : {0.2, 0.7}) {
      Cloud one(dim), two(dim);
      one.opt.viscosity = two.opt.viscosity = GetParam();
      one.add_lattice(dim == 2 ? 34 : 11, dim == 2 ? 34 : 11, 11);
      Noise noise(3);
      one.stir(noise, jitter);
      std::vector<int> number(one.size());
      std::iota(number.begin(), number.end(), 0);
      std::shuffle(number.begin(), number.end(), std::mt19937(5));
      for (int i : number) {
        two.add(one.x[i], one.v[i]);
        two.rho.back() = one.rho[i];
        two.e.back() = one.e[i];
        two.S.back() = one.S[i];
      }
      ASSERT_EQ(one.evaluate(1e-3), -1);
      ASSERT_EQ(two.evaluate(1e-3), -1);
      const std::vector<double> heat = one.heat(one.v), other = two.heat(two.v);
      double most = 0.0, warmest = 0.0;
      for (int i = 0; i < one.size(); i++) {
        most = std::max(most, one.f(i).norm());
        warmest = std::max(warmest, std::abs(heat[i]));
      }
      for (int k = 0; k < two.size(); k++) {
        EXPECT_LT((two.f(k) - one.f(number[k])).norm(), 1e-12 * most);
        EXPECT_LT(std::abs(other[k] - heat[number[k]]), 1e-12 * warmest);
        EXPECT_EQ(two.sweeps->neighbor_count(k), one.sweeps->neighbor_count(number[k]));
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Viscosities, OrderOfWork, testing::ValuesIn(VISCOSITIES), viscosity_name);
