/* ----------------------------------------------------------------------
   Sweeps in mixed precision: what they give differs from what double precision gives by roundings of
   single precision and by nothing else, wherever a body is and however fast; roundings have no
   direction; and what single precision keeps exactly is exact.
------------------------------------------------------------------------- */

#include "lagrangian_body.h"

#include "sph_solid_precision.h"

#include <gtest/gtest.h>

#include <string>

using namespace SPHSolid;

namespace {

void nothing(Cloud &) {}

struct Scene {
  std::string name;
  int dim;
  Frame frame;
  Viscosity viscosity;
  std::function<void(Cloud &)> change = [](Cloud &) {
  };
};

Cloud of_scene(const Scene &scene, int seed = 1)
{
  Cloud c = scene.frame == Frame::EULERIAN ? random_cloud(scene.dim, seed)
                                           : shaken(scene.dim, seed);
  c.opt.viscosity = scene.viscosity;
  c.opt.hourglass = scene.frame == Frame::LAGRANGIAN ? 0.1 : 0.0;
  c.material.strength = Strength::LINEAR;
  c.material.Y = 0.02;
  c.material.H = 0.1;
  scene.change(c);
  return c;
}

// everything that an evaluation gives particles

struct Outcome {
  std::vector<Vector3d> f;
  std::vector<double> heat, rho, stress, virial;
  double step;
};

Outcome outcome(const Scene &scene, bool mixed,
                const std::function<void(Cloud &)> &change = nothing)
{
  Cloud c = of_scene(scene);
  change(c);
  c.opt.mixed = mixed;
  Outcome out;
  EXPECT_EQ(c.evaluate(0.1), -1);
  out.f = forces(c);
  out.step = c.sweeps->time_step_limit(c.particles(), c.neighbors());
  out.virial.assign(6, 0.0);
  c.sweeps->virial(c.particles(), c.neighbors(), out.virial.data());
  out.heat = c.heat(c.v);
  out.rho = c.rho;
  for (const auto &S : c.S) out.stress.insert(out.stress.end(), S.begin(), S.end());
  return out;
}

double largest_change(const std::vector<double> &a, const std::vector<double> &b)
{
  std::vector<double> change(a.size());
  for (std::size_t i = 0; i < a.size(); i++) change[i] = a[i] - b[i];
  return largest(change);
}

// some tens of pairs, each rounded some times, at random: less than 20 of the largest roundings
constexpr double ROUNDED = 20.0 * SINGLE;

// not the same numbers, but for rounding

void expect_rounded(const std::vector<double> &mixed, const std::vector<double> &exact,
                    const std::string &what)
{
  ASSERT_EQ(mixed.size(), exact.size());
  EXPECT_LT(largest_change(mixed, exact), ROUNDED * largest(exact)) << what;
}

void expect_rounded(const Outcome &mixed, const Outcome &exact)
{
  EXPECT_LT(largest_difference(mixed.f, exact.f), ROUNDED * largest(exact.f));
  EXPECT_GT(largest_difference(mixed.f, exact.f), 0.0);
  expect_rounded(mixed.heat, exact.heat, "heat");
  expect_rounded(mixed.rho, exact.rho, "density");
  expect_rounded(mixed.stress, exact.stress, "stress");
  expect_rounded(mixed.virial, exact.virial, "virial");
  EXPECT_NEAR(mixed.step, exact.step, ROUNDED * exact.step);
}

/* ----------------------------------------------------------------------
   every option
------------------------------------------------------------------------- */

std::vector<Scene> all_scenes()
{
  std::vector<Scene> scenes;
  for (const int dim : {2, 3})
    for (const Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN}) {
      const std::string where = std::string(dim == 2 ? "Flat" : "Full") +
          (frame == Frame::EULERIAN ? "Eulerian" : "Lagrangian");
      for (const Viscosity v : VISCOSITIES) scenes.push_back({where + name_of(v), dim, frame, v});
      auto add = [&](const std::string &name, Viscosity v, std::function<void(Cloud &)> change) {
        scenes.push_back({where + name, dim, frame, v, change});
      };
      for (const Weights weights : {Weights::SHEPARD, Weights::SAFE})
        add(weights == Weights::SAFE ? "Safe" : "Shepard", Viscosity::CORRECT, [=](Cloud &c) {
          c.opt.weights = weights;
        });
      add("Printed", Viscosity::CORRECT, [](Cloud &c) {
        c.opt.heating = Heating::PRINTED;
      });
      add("TwoLengths", Viscosity::CORRECT, [](Cloud &c) {
        c.other_h = 1.1 * c.opt.h;
        c.others = {3, 4, 5, 20, 21, 33};
      });
      add("TwoMaterials", Viscosity::MONAGHAN, [](Cloud &c) {
        c.make_others({3, 4, 5, 20, 21, 33}, 4.0, 0.7);
        if (c.opt.frame == Frame::LAGRANGIAN) c.refer();
      });
      add("InFrontOfAPlane", Viscosity::CORRECT, [](Cloud &c) {
        double low = 0.0;
        for (const Vector3d &x : c.x) low = std::min(low, x[0]);
        c.planes.push_back({0, low - 0.3});
      });
      add("Threads", Viscosity::CORRECT, [](Cloud &c) {
        c.nthreads = 3;
      });
      if (frame == Frame::LAGRANGIAN) continue;
      add("Plain", Viscosity::MONAGHAN, [](Cloud &c) {
        c.opt.corrected = false;
      });
      add("Tensile", Viscosity::MONAGHAN, [](Cloud &c) {
        c.opt.tensile = true;
        c.opt.tensile_eps = 0.3;
      });
    }
  return scenes;
}

class Mixed : public testing::TestWithParam<Scene> {};

TEST_P(Mixed, IsDoubleButForRounding)
{
  expect_rounded(outcome(GetParam(), true), outcome(GetParam(), false));
}

// momentum and energy: each pair's force is the same from both sides, sums of them are rounded

TEST_P(Mixed, ConservesButForRounding)
{
  Cloud c = of_scene(GetParam());
  c.opt.mixed = true;
  c.evaluate(0.1);
  const bool leaks = c.opt.weights == Weights::SHEPARD || !c.planes.empty();
  if (!leaks) EXPECT_LT(net_force(c), 2.0 * SINGLE);
  if (c.opt.heating != Heating::PRINTED)
    EXPECT_LT(energy_error(c, random_displacement(c, 5)), 2.0 * SINGLE);
}

// with threads, too, the same to the bit

TEST_P(Mixed, ThreadsChangeNothing)
{
  auto with = [](int n) {
    return outcome(Mixed::GetParam(), true, [n](Cloud &c) {
      c.nthreads = n;
    });
  };
  const Outcome one = with(1), four = with(4);
  EXPECT_EQ(one.f, four.f);
  EXPECT_EQ(one.heat, four.heat);
  EXPECT_EQ(one.stress, four.stress);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Mixed, testing::ValuesIn(all_scenes()), [](const auto &info) {
  return info.param.name;
});

/* ----------------------------------------------------------------------
   roundings have no direction: net forces of many bodies add up as steps in all directions do, to less
   than three times the root of the sum of their squares
------------------------------------------------------------------------- */

TEST(MixedRounding, HasNoDirection)
{
  for (const Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN}) {
    Vector3d sum = Vector3d::Zero();
    double squares = 0.0;
    for (int seed = 1; seed <= 100; seed++) {
      Cloud c = of_scene({"", 2, frame, Viscosity::CORRECT}, seed);
      c.opt.mixed = true;
      c.evaluate(0.1);
      Vector3d net = Vector3d::Zero();
      for (int i = 0; i < c.size(); i++) net += c.f(i);
      sum += net;
      squares += net.squaredNorm();
    }
    EXPECT_GT(squares, 0.0);
    EXPECT_LT(sum.norm(), 3.0 * std::sqrt(squares));
  }
}

// inside of a lattice under uniform pressure, where all particles are rounded in the same direction, less than a fifth
// of the rounding of a force at its surface is left of each.  (It is a tenth; more than a fifth in three dimensions if V0_j g_ij were
// summed up in single precision)

TEST(MixedRounding, LeavesNoForceInALattice)
{
  for (const int dim : {2, 3}) {
    Cloud c = lattice(dim, 9);
    c.opt.frame = Frame::LAGRANGIAN;
    c.opt.viscosity = Viscosity::NONE;
    c.opt.h = 1.0;
    c.opt.mixed = true;
    c.refer();
    for (double &rho : c.rho) rho *= 1.1;
    c.evaluate();
    Vector3d inner = Vector3d::Zero();
    for (int i = 0; i < c.size(); i++) {
      const Vector3d apart = c.x[i] - c.x[middle(c)];
      if (apart.cwiseAbs().maxCoeff() < 2.5) inner += c.f(i);
    }
    EXPECT_LT(inner.norm(), 0.2 * SINGLE * largest(forces(c)) * std::pow(5, dim));
  }
}

/* ----------------------------------------------------------------------
   where a body is.  Coordinates of 10^6 h in single precision would be off by a tenth of a spacing; the
   whole numbers begin anew every 1024 h
------------------------------------------------------------------------- */

class MixedPlace : public testing::TestWithParam<double> {};

TEST_P(MixedPlace, DoesNotMatter)
{
  for (const int dim : {2, 3})
    for (const Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN}) {
      const Scene scene = {"", dim, frame, Viscosity::CORRECT};
      const Outcome here = outcome(scene, false);
      const double far = GetParam() * 1.3;
      const Outcome there = outcome(scene, true, [&](Cloud &c) {
        const Vector3d shift(far, -far, dim == 3 ? 0.5 * far : 0.0);
        for (Vector3d &x : c.x) x += shift;
        for (Vector3d &x : c.xref) x -= shift;
      });
      EXPECT_LT(largest_difference(there.f, here.f), ROUNDED * largest(here.f)) << far;
      expect_rounded(there.heat, here.heat, "heat");
    }
}

INSTANTIATE_TEST_SUITE_P(SmoothingLengths, MixedPlace,
                         testing::Values(510.0, 512.0, -1023.0, 1022.0, 4.0e4, 1.0e6, -3.3e7));

// a body that passes by with 1000 times the speed of sound: of velocities each is rounded to half of 2^-23
// of it, and two spacings apart that is a rate of deformation of as much

TEST(MixedSpeed, StrainsByItsRounding)
{
  for (const Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN}) {
    Cloud c = of_scene({"", 2, frame, Viscosity::CORRECT});
    c.v.assign(c.size(), Vector3d(1000.0, -300.0, 0.0));
    c.opt.mixed = true;
    const std::vector<double> before = c.rho;
    c.evaluate(0.1);
    EXPECT_LT(largest_change(c.rho, before), 0.1 * 1000.0 * SINGLE);
  }
}

/* ----------------------------------------------------------------------
   what is exact
------------------------------------------------------------------------- */

TEST(MixedExact, OneParticleAndFragmentsFarAwayFeelNothing)
{
  for (const int dim : {2, 3})
    for (const Weights weights : {Weights::CONSERVATIVE, Weights::SHEPARD, Weights::SAFE}) {
      Cloud c = random_cloud(dim);
      c.opt.mixed = true;
      c.opt.viscosity = Viscosity::CORRECT;
      c.opt.weights = weights;
      c.add({100, 0, 0}, {1, 2, 0});
      const int last = c.size() - 1;
      EXPECT_EQ(c.evaluate(0.01), -1);
      EXPECT_EQ(c.f(last), Vector3d::Zero().eval());
      EXPECT_EQ(c.heat(c.v)[last], 0.0);
      EXPECT_EQ(c.rho[last], 1.0);
    }
}

TEST(MixedExact, PairForcesAreOpposite)
{
  for (const Viscosity viscosity : VISCOSITIES)
    for (const double r : {0.0, 0.3, 1.0, 1.7}) {
      Cloud c = closing_pair(r);
      c.opt.mixed = true;
      c.opt.viscosity = viscosity;
      c.S[0] = c.S[1] = {0.1, 0.2, -0.3, 0.4, 0.0, 0.0};
      c.evaluate(0.1);
      EXPECT_EQ(c.f(0), (-c.f(1)).eval()) << name_of(viscosity) << " " << r;
    }
}

// the state of particles is in double precision: a change of 10^-10 is not lost

TEST(MixedExact, SmallChangesOfDensityAddUp)
{
  for (const Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN}) {
    Cloud c = lattice(2, 7);
    c.opt.frame = frame;
    c.opt.mixed = true;
    c.move([](const Vector3d &x) {
      return Vector3d(-1.0e-9 * x);
    });
    c.evaluate(0.1);
    EXPECT_NEAR(c.rho[middle(c)] - 1.0, 2.0e-10, 1.0e-6 * 2.0e-10);
  }
}

/* ----------------------------------------------------------------------
   its end: partners so far apart that whole numbers could not tell any more
------------------------------------------------------------------------- */

TEST(MixedOverload, PartnersTooFarApart)
{
  for (const bool mixed : {true, false}) {
    Cloud c = body(2, 1, 0.0);
    c.opt.mixed = mixed;
    const int last = c.size() - 1;
    c.x[last] += Vector3d(300.0 * c.opt.h, 0, 0);
    c.evaluate();
    const Overload end = c.sweeps->find_torn();
    EXPECT_EQ(end.kind, mixed ? Overload::APART : Overload::NONE);
    if (!mixed) continue;
    EXPECT_NEAR(end.value, 300.0 * c.opt.h, 2.0 * c.opt.h);
  }
}

TEST(MixedOverload, IsThatOfDouble)
{
  for (const int dim : {2, 3}) {
    Cloud c = body(dim);
    c.opt.mixed = true;
    deform(c, large(dim));
    c.evaluate();
    EXPECT_EQ(c.sweeps->find_overload().kind, Overload::NONE);
    EXPECT_EQ(c.sweeps->find_torn().kind, Overload::NONE);
    deform(c, turned_stretch(0.005, 2.0, 1.0));
    c.evaluate();
    const Overload end = c.sweeps->find_overload();
    EXPECT_EQ(end.kind, Overload::STRETCH);
    EXPECT_NEAR(end.value, 0.005, 1.0e-4);
    deform(c, turned_stretch(-0.5, 2.0, 1.0));
    c.evaluate();
    EXPECT_EQ(c.sweeps->find_overload().kind, Overload::TURNED_OVER);
  }
}

/* ----------------------------------------------------------------------
   whole numbers
------------------------------------------------------------------------- */

TEST(WholeNumbers, AreTheNearestAndTheirDifferencesExact)
{
  const double all[] = {0.0,    0.4,     -0.4,   0.6,     -0.6,         1.5,           2.5, -1.0,
                        1234.0, -1234.6, 0x1p31, -0x1p31, 0x1p50 + 3.0, -0x1p50 - 5.0, 7e9, -7e9};
  constexpr int N = sizeof(all) / sizeof(all[0]);
  for (int k = 0; k < N; k++) {
    float one[WIDE], other[WIDE];
    for (int half = 0; half < 2; half++) {
      store_whole(one + half * LANES, Pack(all[k]));
      store_whole(other + half * LANES, Pack(all[k] - 8388607.0));
    }
    const WidePack apart = difference(load_whole(one), load_whole(other));
    const double expected = std::nearbyint(all[k]) - std::nearbyint(all[k] - 8388607.0);
    for (int m = 0; m < WIDE; m++) EXPECT_EQ(apart[m], expected) << all[k];
  }
}

TEST(WholeNumbers, AreThoseOfARuler)
{
  using Ruler = MixedPrecision::Ruler;
  const Ruler ruler(1.25);
  for (const double x : {0.0, 3.7, -3.7, 1.0e6, -2.0e6, 639.9999, 640.0001}) {
    float of_x[WIDE], of_y[WIDE];
    for (int m = 0; m < WIDE; m++) {
      of_x[m] = ruler.number_of(x);
      of_y[m] = ruler.number_of(x - 2.0);
    }
    EXPECT_NEAR(ruler.apart(of_x, of_y), 2.0, 1.25 * 0x1p-22) << x;
    const WidePack apart = ruler.apart(Ruler::place(of_x), Ruler::place(of_y));
    for (int m = 0; m < WIDE; m++) EXPECT_NEAR(apart[m], 2.0, 1.25 * 0x1p-22) << x;
  }
}

}    // namespace
