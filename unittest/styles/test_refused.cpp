/* ----------------------------------------------------------------------
   What is designed but not there yet says so.
------------------------------------------------------------------------- */

#include "session.h"

using namespace sphsolid_test;

namespace {

TEST(NotAvailableYet, StrengthJohnsonCook)
{
  Session s;
  s(Block().particles());
  s("pair_style sph/solid 1.3e-3");
  EXPECT_THAT(
      s.error("pair_coeff * * inline rho0 1 strength johnson-cook 1 1 1"),
      HasSubstr("strength johnson-cook is not available yet: use elastic, perfect or linear"));
}

TEST(NotAvailableYet, ColumnsDamageAndTemp)
{
  Session s;
  s(Block().script());
  for (const std::string name : {"damage", "temp"})
    EXPECT_THAT(s.error("compute c all sph/solid/atom " + name),
                HasSubstr("Compute sph/solid/atom: " + name + " is not available"));
}

}    // namespace
