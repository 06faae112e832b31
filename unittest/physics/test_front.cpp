/* ----------------------------------------------------------------------
   Viscosity front: what it leaves of waves and of jumps, in both frames.
------------------------------------------------------------------------- */

#include "cloud.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

namespace {

// a lattice that is long along x, moving with u(x) along x

Cloud strip(Frame frame, double h, const std::function<double(double)> &u)
{
  Cloud c(2);
  c.opt.frame = frame;
  c.opt.h = h;
  c.add_lattice(121, 9);
  c.move([&](Vector3d x) -> Vector3d {
    return {u(x[0]), 0.0, 0.0};
  });
  return c;
}

double heat_in_the_middle(Cloud &c, Viscosity viscosity)
{
  c.opt.viscosity = viscosity;
  c.evaluate();
  const std::vector<double> q = c.heat(c.v);
  double s = 0.0;
  for (int i = 0; i < c.size(); i++)
    if (c.x[i][0] > 20.0 && c.x[i][0] < 100.0 && c.x[i][1] == 4.0) s += q[i];
  return s;
}

}    // namespace

// a sine along a lattice with h = 1, where only the columns next to a particle count:
// the gradient of a particle is the central difference, and the mean of two predicts
// cos^2(k/2) of the jump.  So the rest is the share r = sin^2(k/2), the switch
// s = r^2/(r^2 + e^2), and s + (1-s) r of the standard heat is left (own derivation for
// pairs away from the crests, which hardly count)

TEST(Front, LeavesThisMuchOfAWave)
{
  for (Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN})
    for (double length : {20.0, 40.0}) {
      const double k = 2.0 * M_PI / length, r = std::pow(std::sin(0.5 * k), 2);
      const double s = r * r / (r * r + 0.05 * 0.05), expected = s + (1.0 - s) * r;
      Cloud c = strip(frame, 1.0, [k](double x) {
        return 1e-4 * std::sin(k * x);
      });
      const double rest = heat_in_the_middle(c, Viscosity::NONE);
      const double all = heat_in_the_middle(c, Viscosity::MONAGHAN) - rest;
      const double left = heat_in_the_middle(c, Viscosity::FRONT) - rest;
      EXPECT_NEAR(left / all / expected, 1.0, 0.03) << length;
    }
}

// most of one that the lattice can hardly hold

TEST(Front, DampsShortWaves)
{
  for (Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN})
    for (double h : {1.0, 1.3}) {
      const double k = 2.0 * M_PI / 6.0;
      Cloud c = strip(frame, h, [k](double x) {
        return 1e-4 * std::sin(k * x);
      });
      const double rest = heat_in_the_middle(c, Viscosity::NONE);
      const double all = heat_in_the_middle(c, Viscosity::MONAGHAN) - rest;
      const double left = (heat_in_the_middle(c, Viscosity::FRONT) - rest) / all;
      EXPECT_GT(left, 0.9);
      EXPECT_LE(left, 1.0);
    }
}

// a step that closes has nearly all of the standard viscosity; the same step opening none,
// and a step of the velocity across, a shear, none of it

TEST(Front, KeepsAClosingStep)
{
  for (Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN}) {
    Cloud c = strip(frame, 1.3, [](double x) {
      return x < 60.5 ? 0.1 : -0.1;
    });
    const double rest = heat_in_the_middle(c, Viscosity::NONE);
    const double all = heat_in_the_middle(c, Viscosity::MONAGHAN) - rest;
    EXPECT_GT((heat_in_the_middle(c, Viscosity::FRONT) - rest) / all, 0.95);
    for (Vector3d &v : c.v) v = -v;
    const double opening = heat_in_the_middle(c, Viscosity::NONE);
    EXPECT_EQ(heat_in_the_middle(c, Viscosity::FRONT), opening);
  }
}
