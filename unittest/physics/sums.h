/* ----------------------------------------------------------------------
   Sums over the particles of a cloud: what conservation laws are about after
   evaluate(), and what the viscosity alone does; and over the neighbors of
   one particle.
------------------------------------------------------------------------- */

#ifndef SPH_SOLID_TEST_SUMS_H
#define SPH_SOLID_TEST_SUMS_H

#include "cloud.h"

#include "sph_solid_kernel.h"

namespace SPHSolid {

inline double sum(const std::vector<double> &all)
{
  double s = 0.0;
  for (double one : all) s += one;
  return s;
}

// the larger of two; not a number where one of them is not

inline double larger(double a, double b)
{
  return a > b ? a : b >= a ? b : std::nan("");
}

inline double largest(const std::vector<double> &all)
{
  double most = 0.0;
  for (double one : all) most = larger(most, std::fabs(one));
  return most;
}

inline double largest(const std::vector<Vector3d> &all)
{
  double most = 0.0;
  for (const Vector3d &one : all) most = larger(most, one.norm());
  return most;
}

inline double largest_difference(const std::vector<Vector3d> &a, const std::vector<Vector3d> &b)
{
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); i++) most = larger(most, (a[i] - b[i]).norm());
  return most;
}

inline std::vector<Vector3d> forces(const Cloud &c)
{
  std::vector<Vector3d> f(c.size());
  for (int i = 0; i < c.size(); i++) f[i] = c.f(i);
  return f;
}

/* ----------------------------------------------------------------------
   momentum and energy
------------------------------------------------------------------------- */

// net force over the sum of all forces

inline double net_force(const Cloud &c)
{
  Vector3d net = Vector3d::Zero();
  double all = 0.0;
  for (int i = 0; i < c.size(); i++) {
    net += c.f(i);
    all += c.f(i).norm();
  }
  return net.norm() / all;
}

inline Vector3d torque(const Cloud &c)
{
  Vector3d net = Vector3d::Zero();
  for (int i = 0; i < c.size(); i++) net += c.x[i].cross(c.f(i));
  return net;
}

inline double absolute_torque(const Cloud &c)
{
  double all = 0.0;
  for (int i = 0; i < c.size(); i++) all += c.x[i].norm() * c.f(i).norm();
  return all;
}

// net torque over the sum of all |x| |f|

inline double net_torque(const Cloud &c)
{
  return torque(c).norm() / absolute_torque(c);
}

// power of the forces

inline double power(const Cloud &c)
{
  double sum = 0.0;
  for (int i = 0; i < c.size(); i++) sum += c.f(i).dot(c.v[i]);
  return sum;
}

// what the forces do in a displacement u and the heat of it, which have to cancel, over the
// work of every force

inline double energy_error(Cloud &c, const std::vector<Vector3d> &u)
{
  double work = 0.0, all = 0.0;
  for (int i = 0; i < c.size(); i++) {
    work += u[i].dot(c.f(i));
    all += std::fabs(u[i].dot(c.f(i)));
  }
  return std::fabs(work + sum(c.heat(u))) / all;
}

inline std::vector<Vector3d> random_displacement(const Cloud &c, int seed)
{
  Noise noise(seed);
  std::vector<Vector3d> u(c.size());
  for (Vector3d &one : u) one = noise.vector(c.dim);
  return u;
}

// how much a particle is heated differently in any displacement when seen from a train that passes by, over
// the largest heat

inline double galilean_error(Cloud &c)
{
  const Vector3d train(1.0, -2.0, c.dim == 3 ? 0.5 : 0.0);
  std::vector<Vector3d> u = random_displacement(c, 6);
  const std::vector<double> at_rest = c.heat(u);
  for (Vector3d &one : u) one += train;
  for (Vector3d &one : c.v) one += train;
  c.evaluate();
  std::vector<double> difference = c.heat(u);
  for (int i = 0; i < c.size(); i++) difference[i] -= at_rest[i];
  return largest(difference) / largest(at_rest);
}

// the virial against sum x_i f_i, over the sum of all |x| |f|.  Of the sum the upper triangle:
// it is symmetric only where forces have no torque

inline double virial_error(Cloud &c)
{
  double six[6] = {};
  c.sweeps->virial(c.particles(), c.neighbors(), six);
  Matrix3d exact = Matrix3d::Zero();
  for (int i = 0; i < c.size(); i++) exact += c.x[i] * c.f(i).transpose();
  const Matrix3d difference = (symmetric(six) - exact).triangularView<Eigen::Upper>();
  return difference.norm() / absolute_torque(c);
}

/* ----------------------------------------------------------------------
   what the viscosity does: the difference to the same cloud without one
------------------------------------------------------------------------- */

// heat per time of every particle

inline std::vector<double> viscous_heat(Cloud &c)
{
  const Viscosity chosen = c.opt.viscosity;
  c.evaluate();
  std::vector<double> all = c.heat(c.v);
  c.opt.viscosity = Viscosity::NONE;
  c.evaluate();
  c.opt.viscosity = chosen;
  const std::vector<double> rest = c.heat(c.v);
  for (int i = 0; i < c.size(); i++) all[i] -= rest[i];
  return all;
}

// the largest force on any particle

inline double viscous_force(Cloud &c)
{
  const Viscosity chosen = c.opt.viscosity;
  c.evaluate();
  const std::vector<Vector3d> with = forces(c);
  c.opt.viscosity = Viscosity::NONE;
  c.evaluate();
  c.opt.viscosity = chosen;
  return largest_difference(with, forces(c));
}

// the same heat by the ledger, without its effect on the pressure

inline const Ledger &booked_heat(Cloud &c)
{
  const std::vector<double> e = c.e;
  c.evaluate();
  c.add_heat(c.v);
  c.e = e;
  return c.sweeps->ledger;
}

/* ----------------------------------------------------------------------
   neighbors
------------------------------------------------------------------------- */

// sum_j V_j (x_j - x_i) (x) grad_i W_ij, or with m_j for V_j: unity in the bulk of a body, with
// det a half on a face and 0.13 (2d) or 0.02 (3d) at a corner of a lattice

inline Matrix3d moment(const Cloud &c, int i, bool by_mass = false)
{
  Matrix3d m = Matrix3d::Zero();
  for (int j = 0; j < c.size(); j++) {
    const Vector3d d = c.x[j] - c.x[i];
    const double r = d.norm(), weight = by_mass ? c.mass[j] : c.mass[j] / c.rho[j];
    const double F = c.dim == 2 ? CubicSpline<2>::gradient_factor(r, c.opt.h)
                                : CubicSpline<3>::gradient_factor(r, c.opt.h);
    m -= weight * F * d * d.transpose();
  }
  if (c.dim == 2) m(2, 2) = 1.0;
  return m;
}

}    // namespace SPHSolid

#endif
