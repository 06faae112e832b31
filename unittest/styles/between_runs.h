/* ----------------------------------------------------------------------
   What tests of commands between two runs share: momentum of a state, and a body in a periodic box.
------------------------------------------------------------------------- */

#ifndef SPHSOLID_TEST_BETWEEN_RUNS_H
#define SPHSOLID_TEST_BETWEEN_RUNS_H

#include "answers.h"
#include "lagrangian_block.h"

namespace sphsolid_test {

struct Momentum {
  double x, y, size;    // the two components, and what they would be without signs
};

inline Momentum momentum(const State &state, int first = 1, int last = 1 << 30)
{
  Momentum sum = {0.0, 0.0, 0.0};
  for (const Particle &p : state) {
    if (p.id < first || p.id > last) continue;
    sum.x += p.mass * p.v[0];
    sum.y += p.mass * p.v[1];
    sum.size += p.mass * std::hypot(p.v[0], p.v[1]);
  }
  return sum;
}

inline void expect_same(const Momentum &a, const Momentum &b)
{
  EXPECT_GT(a.size, 0.0);
  EXPECT_NEAR(a.x, b.x, 1.0e-12 * a.size);
  EXPECT_NEAR(a.y, b.y, 1.0e-12 * a.size);
}

inline Block bar()
{
  Block b = body();
  b.boundary = "p f";
  b.box = "0 0.012 -0.04 0.04";
  b.nx = 12;
  b.ny = 5;
  b.motion = "variable vy atom 2e4*(y-0.002)\nvelocity all set 10 v_vy 0 units box\n";
  return b;
}

}    // namespace sphsolid_test

#endif
