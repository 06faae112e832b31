/* ----------------------------------------------------------------------
   The time step: h/(c_L + 0.6 (a1 c + a2 |mu|)) after Monaghan (1992), with h
   instead of 0.3 h for a Courant number of one.
------------------------------------------------------------------------- */

#include "lagrangian_body.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

namespace {

const double C_L = std::sqrt(1.0 + 4.0 / 3.0 * 0.786);    // of test_iron()

}    // namespace

TEST(TimeStep, ElasticWave)
{
  Cloud c = lattice(2, 5);
  c.opt.viscosity = Viscosity::NONE;
  c.evaluate();
  const double limit = c.sweeps->time_step_limit(c.particles(), c.neighbors());
  EXPECT_NEAR(limit, 1.3 / C_L, 1e-15);
}

TEST(TimeStep, ViscosityShortensIt)
{
  Cloud c = closing_pair(1.0);
  c.opt.h = 1.0;
  c.opt.viscosity = Viscosity::MONAGHAN;
  c.opt.a1 = 0.5;
  c.opt.a2 = 2.0;
  c.evaluate();
  const double limit = c.sweeps->time_step_limit(c.particles(), c.neighbors());
  EXPECT_NEAR(limit, 1.0 / (C_L + 0.6 * (0.5 + 2.0 * 0.2 / 1.01)), 1e-15);
}

// Lagrangian frame: less by the least principal stretch, which follows from C where the viscosity
// has neighbors read that

TEST(TimeStep, ShrinksWithTheLeastStretch)
{
  for (int dim : {2, 3})
    for (Viscosity viscosity : {Viscosity::NONE, Viscosity::MONAGHAN})
      for (double stretch : {3.0, 1.0, 0.8, 0.4, 0.1}) {
        Cloud c = body(dim);
        c.opt.viscosity = viscosity;
        c.opt.a1 = c.opt.a2 = 0.0;
        deform(c, turned_stretch(stretch, 1.5, 1.2));
        c.evaluate();
        EXPECT_NEAR(c.sweeps->time_step_limit(c.particles(), c.neighbors()),
                    1.3 * std::min(1.0, stretch) / C_L, 1e-12);
      }
}

// a body of which half is squeezed: that half decides, also where the other one comes first

TEST(TimeStep, TheLeastOfAllWhereverItIs)
{
  for (int dim : {2, 3})
    for (double side : {-1.0, 1.0}) {
      Cloud c(dim);
      c.opt.frame = Frame::LAGRANGIAN;
      c.opt.viscosity = Viscosity::NONE;
      if (dim == 2)
        c.add_lattice(6, 24);
      else
        c.add_lattice(5, 5, 16);
      c.refer();
      const int axis = dim - 1;
      double middle = 0.0;
      for (int i = 0; i < c.size(); i++) middle += c.xref[i][axis] / c.size();
      for (int i = 0; i < c.size(); i++) {
        const double beyond = side * (c.x[i][axis] - middle);
        if (beyond > 0.0) c.x[i][axis] = middle + side * 0.4 * beyond;
      }
      c.evaluate();
      EXPECT_NEAR(c.sweeps->time_step_limit(c.particles(), c.neighbors()), 1.3 * 0.4 / C_L, 1e-12);
    }
}

// of two materials, each with a factor of its own over the root of its density, which only shortens

TEST(TimeStep, FactorsOfTypes)
{
  for (int dim : {2, 3}) {
    Cloud c = lattice(dim, 6);
    c.opt.frame = Frame::LAGRANGIAN;
    c.opt.viscosity = Viscosity::NONE;
    c.make_others({1, 2, 20, 35}, 4.0, 2.0);    // h/c is half of the others'
    c.evaluate();
    const double of_first = 1.3 / C_L, of_others = 0.5 * of_first;
    auto limit = [&](double first, double others) {
      return c.sweeps->scaled_time_step_limit(c.particles(), {0.0, first, others});
    };
    EXPECT_NEAR(c.sweeps->time_step_limit(c.particles(), c.neighbors()), of_others, 1e-15);
    EXPECT_NEAR(limit(1.0, 2.0), of_others, 1e-15);
    EXPECT_NEAR(limit(7.0, 7.0), of_others, 1e-15);
    EXPECT_NEAR(limit(1.0, 1.0), 0.5 * of_others, 1e-15);
    EXPECT_NEAR(limit(0.3, 2.0), 0.3 * of_first, 1e-15);
  }
}
