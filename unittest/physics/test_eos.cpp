/* ----------------------------------------------------------------------
   Equations of state: points on exact shock and rarefaction solutions, and
   the sound speed as the slope of the isentrope.

   The states were found by solving the jump conditions with 30 digits
   (rarefaction: adaptive Taylor integration with 20), with P(rho,e) written
   anew from Shaw & Reid (2009), eqs 8-13, tension branch P_H = a0 eta.
------------------------------------------------------------------------- */

#include "sph_solid_eos.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SPHSolid;

namespace {

Material mie(double rho0, double C, double S, double Gamma)
{
  Material m;
  m.rho0 = rho0;
  m.eos = EOS::MIE_GRUNEISEN;
  m.C = C;
  m.S = S;
  m.Gamma = Gamma;
  return m;
}

const Material iron = mie(7850.0, 3600.0, 1.8, 1.8);
const Material copper = mie(8930.0, 3940.0, 1.49, 2.0);
const Material aluminium = mie(2785.0, 5328.0, 1.338, 2.0);

double P(const Material &m, double rho, double e)
{
  return pressure(m, rho, m.rho0, e).P;
}

double sound(const Material &m, double rho, double e)
{
  return std::sqrt(pressure(m, rho, m.rho0, e).c2);
}

// the change of e along the isentrope de = P/rho^2 drho from rho to rho + d: a step of the classical Runge-Kutta
// method, with any P(rho, e)

template <class Pressure> double isentropic_change(Pressure P_of, double rho, double e, double d)
{
  auto slope = [&](double at, double energy) {
    return P_of(at, energy) / (at * at);
  };
  const double k1 = slope(rho, e), k2 = slope(rho + 0.5 * d, e + 0.5 * d * k1);
  const double k3 = slope(rho + 0.5 * d, e + 0.5 * d * k2), k4 = slope(rho + d, e + d * k3);
  return d / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

void expect_relative(double value, double exact, double tolerance)
{
  EXPECT_NEAR(value / exact, 1.0, tolerance);
}

}    // namespace

TEST(Eos, NoPressureAtRest)
{
  EXPECT_EQ(P(iron, 7850.0, 0.0), 0.0);
}

// shock into iron at rest driven at 200 m/s: e = u^2/2, P = rho0 U u with
// U = 3959.009305758428832 m/s

TEST(Eos, PlanarShockInIron)
{
  const double rho = 8267.6632384482038832;
  expect_relative(P(iron, rho, 20000.0), 6215644610.04073326743, 1e-12);
  expect_relative(P(iron, rho, 20000.0), 7850.0 * 3959.00930575842883 * 200.0, 1e-12);
}

// the same of a metal with S < 1, titanium: rho0 4528, U = 5220 + 0.767 u (Marsh 1980), driven at 100 m/s.  The cubic
// is the expansion of the exact jump, and lies below it by (3 (S-1)^2 + 4 (S-1)^3) eta^3 of it in lowest order

TEST(Eos, PlanarShockInTitanium)
{
  const double rho0 = 4528.0, u = 100.0, U = 5220.0 + 0.767 * u, s = -0.233;
  const double eta = U / (U - u) - 1.0;
  const double found = P(mie(rho0, 5220.0, 0.767, 1.09), rho0 * (1.0 + eta), 0.5 * u * u);
  const double below = (3.0 * s * s + 4.0 * s * s * s) * eta * eta * eta;
  EXPECT_NEAR((found / (rho0 * U * u) - 1.0) / -below, 1.0, 0.05);
}

// behind the plastic wave of an elastic-plastic piston, exact two-wave jump
// conditions with a hypoelastic precursor

TEST(Eos, PistonCopper)
{
  expect_relative(P(copper, 8973.45305846046390985, 213.530186400918339), 681592184.372710796,
                  1e-12);
}

TEST(Eos, PistonAluminium)
{
  expect_relative(P(aluminium, 2985.62011434500799820, 81270.9720596151793544), 6436147146.76003524,
                  1e-12);
}

TEST(Eos, PistonIron)
{
  expect_relative(P(iron, 8255.08639439387411359, 21046.6072594875522825), 6037418449.51564647,
                  1e-12);
}

// the elastic precursor: sigma = P + 2/3 Y at rho_y = rho0 exp(Y/2mu)

TEST(Eos, HugoniotElasticLimits)
{
  expect_relative(P(copper, 8930.0 * std::exp(1e-3), 11.1383360512417016634) + 60.0e6,
                  199030163.793670926742, 1e-12);
  expect_relative(P(aluminium, 2785.0 * std::exp(300.0 / 55200.0), 618.764782349782890341) +
                      200.0e6,
                  635884470.976560754083, 1e-12);
  expect_relative(P(iron, 7850.0 * std::exp(600.0 / 160000.0), 187.705803677370953843) + 400.0e6,
                  787336042.886177204242, 1e-12);
}

// shock tube of fluid iron, 10 GPa of heat on the left: P is the same on both
// sides of the contact, 4.950243 GPa

TEST(Eos, ShockTubeStarStates)
{
  const double P_star = 4950242829.9775845;
  expect_relative(P(iron, 8191.1482804004363676, 13131.8299335944042), P_star, 1e-12);
  expect_relative(P(iron, 7542.0176670953757662, 669039.38163779033591), P_star, 1e-12);
}

// head and tail of its rarefaction travel at -c and u* - c

TEST(Eos, SoundSpeedInRarefaction)
{
  expect_relative(sound(iron, 7850.0, 707714.084), 4065.3264301111171656, 1e-12);
  expect_relative(sound(iron, 7542.0176670953757662, 669039.38163779033591),
                  162.06066724282239721 + 3870.4258488119378218, 1e-12);
}

TEST(Eos, SoundSpeedAtRest)
{
  expect_relative(sound(iron, 7850.0, 0.0), 3600.0, 1e-15);
}

// c^2 = dP/drho by a central difference of points on the isentrope, one step to each side

TEST(Eos, SoundSpeedIsSlopeOfIsentrope)
{
  auto P_of_iron = [](double rho, double e) {
    return P(iron, rho, e);
  };
  for (double compression : {0.8, 0.95, 0.999, 1.001, 1.05, 1.3})
    for (double e : {-5.0e4, 0.0, 2.0e4, 7.0e5}) {
      const double rho = 7850.0 * compression, step = 0.5;
      auto on_isentrope = [&](double d) {
        return P(iron, rho + d, e + isentropic_change(P_of_iron, rho, e, d));
      };
      auto difference = [&](double d) {
        return (on_isentrope(d) - on_isentrope(-d)) / (2.0 * d);
      };
      const double c2 = (4.0 * difference(step) - difference(2.0 * step)) / 3.0;
      expect_relative(pressure(iron, rho, 7850.0, e).c2, c2, 1e-9);
    }
}

// the cubic curve with a constant Gamma bends over at strong compression: on the isentrope from rest, integrated
// here from the printed equations, P has a maximum, beyond which c^2 is negative

TEST(Eos, SoundSpeedEndsAtTheTopOfTheIsentrope)
{
  struct Case {
    double S, Gamma, compression;
  };
  for (const Case &of : {Case{1.8, 1.8, 1.934}, Case{1.489, 2.0, 1.856}, Case{1.338, 2.0, 1.863}}) {
    const double rho0 = 7850.0, C = 3600.0, a0 = rho0 * C * C, s = of.S - 1.0;
    auto P_by_hand = [&](double rho, double e) {
      const double eta = rho / rho0 - 1.0;
      const double P_H =
          a0 * (eta + (1.0 + 2.0 * s) * eta * eta + (2.0 * s + 3.0 * s * s) * eta * eta * eta);
      return (1.0 - 0.5 * of.Gamma * eta) * P_H + of.Gamma * rho * e;
    };
    // e on the isentrope, in steps of 0.0005
    auto energy_at = [&](double compression) {
      const int n = 2000;
      const double d = (compression - 1.0) * rho0 / n;
      double e = 0.0;
      for (int k = 0; k < n; k++) e += isentropic_change(P_by_hand, rho0 + k * d, e, d);
      return e;
    };
    auto P_at = [&](double compression) {
      return P_by_hand(compression * rho0, energy_at(compression));
    };
    const Material m = mie(rho0, C, of.S, of.Gamma);
    for (double beyond : {-0.005, 0.005}) {
      const double at = of.compression + beyond, rho = at * rho0, step = 1e-4;
      const double c2 = (P_at(at + step) - P_at(at - step)) / (2.0 * step * rho0);
      const bool ends = beyond > 0.0;
      EXPECT_EQ((c2 < 0.0), ends) << of.S;    // the isentrope says so
      const double found = pressure(m, rho, rho0, energy_at(at)).c2;
      EXPECT_EQ((found < 0.0), ends) << of.S;
      EXPECT_NEAR(found / c2, 1.0, 1e-4) << of.S;
    }
  }
}

// no jump of P or of its slope between compression and tension: both are
// a0 eta + O(eta^2) at e = 0

TEST(Eos, SmoothAtRestDensity)
{
  const double K = 7850.0 * 3600.0 * 3600.0, d = 1e-7;
  expect_relative(P(iron, 7850.0 * (1.0 + d), 0.0), K * d, 3e-7);
  expect_relative(P(iron, 7850.0 * (1.0 - d), 0.0), -K * d, 3e-7);
  expect_relative(pressure(iron, 7850.0 * (1.0 + d), 7850.0, 0.0).c2, 3600.0 * 3600.0, 1e-6);
  expect_relative(pressure(iron, 7850.0 * (1.0 - d), 7850.0, 0.0).c2, 3600.0 * 3600.0, 1e-6);
}

// P_H = a0 eta under tension, times 1 - Gamma eta/2 of the reference energy

TEST(Eos, StiffInTension)
{
  const double K = 7850.0 * 3600.0 * 3600.0;
  for (double eta : {-0.001, -0.01, -0.1})
    expect_relative(P(iron, 7850.0 * (1.0 + eta), 0.0), K * eta * (1.0 - 0.9 * eta), 1e-13);
}

// at constant density the pressure grows with e by Gamma rho

TEST(Eos, GrueneisenParameter)
{
  for (double rho : {7000.0, 7850.0, 9000.0})
    expect_relative(P(iron, rho, 3.0e5) - P(iron, rho, 1.0e5), 1.8 * rho * 2.0e5, 1e-11);
}

// the cubic form is the Taylor series of the exact Hugoniot
// a0 eta(1+eta)/(1-(S-1)eta)^2 to third order: the difference shrinks by 2^4

TEST(Eos, CubicFormFollowsHugoniot)
{
  auto error = [](double eta) {
    const double a0 = 7850.0 * 3600.0 * 3600.0, s = 0.8;
    const double exact = a0 * eta * (1.0 + eta) / std::pow(1.0 - s * eta, 2);
    return exact - P(iron, 7850.0 * (1.0 + eta), 0.0) / (1.0 - 0.9 * eta);
  };
  EXPECT_NEAR(error(0.004) / error(0.002), 16.0, 0.2);
}

TEST(Eos, LinearForm)
{
  Material rubber;
  rubber.rho0 = 1010.0;
  rubber.eos = EOS::LINEAR;
  rubber.K = 3.25e6;
  const PressureState state = pressure(rubber, 1010.0 * 1.02, 1010.0, 1.0e6);
  expect_relative(state.P, 6.5e4, 1e-13);
  expect_relative(state.c2, 3.25e6 / 1010.0, 1e-15);
  expect_relative(pressure(rubber, 1010.0 * 0.98, 1010.0, 0.0).P, -6.5e4, 1e-13);
}

// a particle whose rest density is ten times that of the card has the same
// stiffness: same cold pressure, c^2 a tenth

TEST(Eos, ReferenceDensityKeepsStiffness)
{
  Material linear = iron;
  linear.eos = EOS::LINEAR;
  linear.K = 1.0e11;
  for (const Material &m : {iron, linear})
    for (double compression : {0.9, 1.1}) {
      const PressureState light = pressure(m, 7850.0 * compression, 7850.0, 0.0);
      const PressureState heavy = pressure(m, 78500.0 * compression, 78500.0, 0.0);
      expect_relative(heavy.P, light.P, 1e-14);
      expect_relative(heavy.c2, 0.1 * light.c2, 1e-14);
    }
}
