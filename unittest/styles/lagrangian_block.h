/* ----------------------------------------------------------------------
   The block that the tests of the Lagrangian frame run: it spins, and shears.
------------------------------------------------------------------------- */

#ifndef SPHSOLID_TEST_LAGRANGIAN_BLOCK_H
#define SPHSOLID_TEST_LAGRANGIAN_BLOCK_H

#include "session.h"

namespace sphsolid_test {

inline Block body(const std::string &options = "")
{
  Block b;
  b.nx = 6;
  b.ny = 8;
  b.frame = "lagrangian";
  b.options = options;
  b.motion = "variable vy atom -2e4*y*(1+100*x)\nvelocity all set NULL v_vy NULL units box\n";
  return b;
}

inline State run(const Block &b, const std::string &steps = "run 40")
{
  Session s;
  s(b.script());
  s(steps);
  return s.state();
}

// a change of shape between two runs

inline const std::string SHEAR = "variable dx atom 0.25*y\nvariable dy atom 0.5*x\n"
                                 "displace_atoms all move v_dx v_dy 0 units box\n";

}    // namespace sphsolid_test

#endif
