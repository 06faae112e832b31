/* ----------------------------------------------------------------------
   Nothing depends on how the work is ordered or shared out.
------------------------------------------------------------------------- */

#include "cloud.h"

#include <gtest/gtest.h>

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

INSTANTIATE_TEST_SUITE_P(Viscosities, OrderOfWork, testing::ValuesIn(VISCOSITIES), viscosity_name);
