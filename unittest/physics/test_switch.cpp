/* ----------------------------------------------------------------------
   What tells a shock from a smooth flow: the limiter and the switches by hand, and that
   they take viscosity off linear fields, turns and shear.
------------------------------------------------------------------------- */

#include "sums.h"

#include "sph_solid_switch.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

namespace {

// v = G x; in the Lagrangian frame of a body in its reference

void flow(Cloud &c, double xx, double xy, double yx, double yy)
{
  c.move([=](Vector3d x) -> Vector3d {
    return {xx * x[0] + xy * x[1], yx * x[0] + yy * x[1], 0.0};
  });
}

}    // namespace

TEST(Switch, Balsara)
{
  Tensor<2> L;
  L << -3.0, 5.0, 1.0, 1.0;    // div -2, curl -4
  EXPECT_DOUBLE_EQ((balsara_switch<2, double>(L, 20.0, 2.0)), 2.0 / (2.0 + 4.0 + 1e-3));
  Tensor<3> G;
  G << 1.0, 0.0, 2.0, 3.0, 1.0, 0.0, 0.0, 6.0, 1.0;    // div 3, curl (6, 2, 3): 7
  EXPECT_DOUBLE_EQ((balsara_switch<3, double>(G, 20.0, 2.0)), 3.0 / (3.0 + 7.0 + 1e-3));
  EXPECT_EQ((balsara_switch<2, double>(Tensor<2>::Zero(), 20.0, 2.0)), 0.0);
  // at rest, and c^2 < 0
  EXPECT_EQ((balsara_switch<2, double>(Tensor<2>::Zero(), 0.0, 2.0)), 0.0);
  const Pack at_rest = balsara_switch<2, Pack>(Tensor<2, Pack>::Zero(), Pack(0.0), Pack(2.0));
  for (int m = 0; m < LANES; m++) EXPECT_EQ(at_rest[m], 0.0);
}

TEST(Switch, CompressionShare)
{
  Tensor<2> L = Tensor<2>::Zero();
  EXPECT_EQ((compression_share<2, double>(L)), 0.0);
  L(0, 0) = -2.0;
  EXPECT_EQ((compression_share<2, double>(L)), 1.0);    // plane shock
  L(1, 1) = -2.0;
  EXPECT_EQ((compression_share<2, double>(L)), 1.0);    // from all sides
  L(1, 1) = 1.0;
  EXPECT_DOUBLE_EQ((compression_share<2, double>(L)), 0.2);    // 1/(4 + 1)
  L(0, 1) = 3.0;
  L(1, 0) = -1.0;
  EXPECT_DOUBLE_EQ((compression_share<2, double>(L)), 1.0 / 7.0);    // D_xy = 1
  EXPECT_EQ((compression_share<2, double>(-L)), 0.0);                // expansion
  L << -2.0, 0.0, 0.0, 2.0;
  EXPECT_EQ((compression_share<2, double>(L)), 0.0);    // plastic flow
}

TEST(Switch, UnresolvedShare)
{
  EXPECT_EQ(unresolved_share(0.0, 0.0), 0.0);
  EXPECT_EQ(unresolved_share(0.0, 3.0), 0.0);
  EXPECT_EQ(unresolved_share(3.0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(unresolved_share(0.0025 * 4.0, 4.0), 0.5);
}

TEST(Switch, FrontJump)
{
  EXPECT_EQ(front_jump(-4.0, -4.0, -4.0, 1.0), -4.0);           // front: whole
  EXPECT_EQ(front_jump(-4.0, -4.0, -4.0, 0.0), 0.0);            // resolved: nothing
  EXPECT_DOUBLE_EQ(front_jump(-4.0, -1.0, -3.0, 0.0), -2.0);    // the rest
  EXPECT_DOUBLE_EQ(front_jump(-4.0, -1.0, -3.0, 0.5), -3.0);
  EXPECT_DOUBLE_EQ(front_jump(-4.0, -1.0, 1.0, 0.0), -4.0);    // a crest
  EXPECT_EQ(front_jump(-4.0, -5.0, -5.0, 0.0), 0.0);           // would change its sign
  EXPECT_EQ(front_jump(-4.0, 5.0, 5.0, 0.0), -4.0);            // would grow
}

// by hand: 4 l_i l_j/(l_i + l_j)^2

TEST(LimitedViscosity, VanLeersLimiter)
{
  EXPECT_DOUBLE_EQ(van_leer(1.0, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(van_leer(-2.0, -2.0), 1.0);
  EXPECT_DOUBLE_EQ(van_leer(1.0, 3.0), 0.75);
  EXPECT_DOUBLE_EQ(van_leer(3.0, 1.0), 0.75);
  EXPECT_DOUBLE_EQ(van_leer(-1.0, -9.0), 0.36);
  EXPECT_EQ(van_leer(1.0, -1.0), 0.0);
  EXPECT_EQ(van_leer(-5.0, 2.0), 0.0);
  EXPECT_EQ(van_leer(0.0, 4.0), 0.0);
  EXPECT_EQ(van_leer(0.0, 0.0), 0.0);
}

TEST(LimitedViscosity, JumpThatIsLeft)
{
  EXPECT_EQ(limited_jump(-4.0, -4.0, -4.0), 0.0);            // linear
  EXPECT_DOUBLE_EQ(limited_jump(-4.0, -1.0, -3.0), -2.5);    // -4 + 0.75 * 2
  EXPECT_DOUBLE_EQ(limited_jump(-4.0, -0.5, -4.5), -3.1);    // -4 + 0.36 * 2.5
  EXPECT_EQ(limited_jump(-4.0, -8.0, -8.0), 0.0);            // would change its sign
  EXPECT_EQ(limited_jump(-4.0, 2.0, 2.0), -4.0);             // would grow
  EXPECT_EQ(limited_jump(-4.0, 3.0, -3.0), -4.0);            // no common slope
  EXPECT_EQ(limited_jump(-4.0, 0.0, 0.0), -4.0);             // a shock
  EXPECT_DOUBLE_EQ(limited_jump(4.0, 1.0, 3.0), 2.5);
  EXPECT_EQ(limited_jump(0.0, 1.0, 3.0), 0.0);
}

TEST(LimitedViscosity, JumpIsBetweenZeroAndTheWholeOne)
{
  Noise noise(1);
  for (int k = 0; k < 10000; k++) {
    const double vr = noise(), left = limited_jump(vr, noise(), noise());
    EXPECT_GE(left * vr, 0.0);
    EXPECT_LE(std::fabs(left), std::fabs(vr));
  }
}

/* ----------------------------------------------------------------------
   in bodies
------------------------------------------------------------------------- */

// Eulerian frame (the Lagrangian one: test_linear_map.cpp).  A linear compression is not a
// jump, with gradient plain neither, since the viscosity has the exact gradient there too.  On
// a disc: no corners without one

TEST(LinearField, IsNoJumpForLimited)
{
  for (bool corrected : {true, false}) {
    Cloud c = disc();
    c.no_stress();
    flow(c, -0.3, 0.1, -0.2, -0.1);
    c.opt.corrected = corrected;
    c.opt.viscosity = Viscosity::LIMITED;
    EXPECT_LT(viscous_force(c), 1e-14);
    c.opt.viscosity = Viscosity::FRONT;
    EXPECT_LT(viscous_force(c), 1e-14);
    c.opt.viscosity = Viscosity::MONAGHAN;
    EXPECT_GT(viscous_force(c), 1e-2);
  }
}

// balsara: none of the standard viscosity in a rigid turn and in shear, where pairs
// approach each other; all of it in compression

TEST(Balsara, ShearAndCompression)
{
  for (Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN}) {
    Cloud c = lattice(2, 9);
    c.opt.frame = frame;
    c.opt.h = 1.3;
    auto force = [&c](Viscosity viscosity) {
      c.opt.viscosity = viscosity;
      return viscous_force(c);
    };
    flow(c, 0.0, 0.1, 0.0, 0.0);
    const double shear = force(Viscosity::MONAGHAN);
    EXPECT_GT(shear, 1e-3);
    EXPECT_LT(force(Viscosity::BALSARA), 1e-13);
    flow(c, -0.1, 0.0, 0.0, 0.0);
    const double compression = force(Viscosity::MONAGHAN);
    // 1 - f = 1e-4 c/h over |div v|
    EXPECT_NEAR(force(Viscosity::BALSARA) / compression, 1.0 / (1.0 + 1e-4 / 1.3 / 0.1), 1e-12);
  }
}
