/* ----------------------------------------------------------------------
   One material point of iron that is strained in steps.
------------------------------------------------------------------------- */

#ifndef SPH_SOLID_TEST_MATERIAL_POINT_H
#define SPH_SOLID_TEST_MATERIAL_POINT_H

#include "sph_solid_strength.h"

#include <Eigen/Geometry>
#include <cmath>

namespace SPHSolid {

inline constexpr double RHO0 = 7850.0, MU = 80.0e9, Y0 = 600.0e6;

inline Material solid(Strength strength, double H = 0.0)
{
  Material m;
  m.rho0 = RHO0;
  m.shear = MU;
  m.strength = strength;
  m.Y = Y0;
  m.H = H;
  return m;
}

inline const Material elastic = solid(Strength::ELASTIC);
inline const Material perfect = solid(Strength::PERFECT);

template <int D> PointState<D> at_rest()
{
  PointState<D> p;
  p.rho = RHO0;
  return p;
}

// n equal steps of a constant spatial velocity gradient over the time t

template <int D>
double steady(const Material &m, PointState<D> &p, const Tensor<D> &L, double t, int n)
{
  double work = 0.0;
  for (int i = 0; i < n; i++) work += advance<D>(m, p, L, t / n);
  return work;
}

// one step that takes the deformation gradient from F0 to F1, as the package
// sees it: gradient of the velocity with respect to the positions at the end

template <int D>
double deform(const Material &m, PointState<D> &p, const Tensor<D> &F0, const Tensor<D> &F1,
              double dt)
{
  const Tensor<D> L_end = (F1 - F0) / dt * F1.inverse();
  return advance<D>(m, p, midpoint_velocity_gradient<D>(L_end, dt), dt);
}

// stretch along x of a bar of unit length in n steps

inline double stretch(const Material &m, PointState<3> &p, double from, double to, int n)
{
  double work = 0.0;
  for (int i = 0; i < n; i++) {
    Tensor<3> F0 = Tensor<3>::Identity(), F1 = F0;
    F0(0, 0) = from + (to - from) * i / n;
    F1(0, 0) = from + (to - from) * (i + 1) / n;
    work += deform<3>(m, p, F0, F1, 1.0e-6);
  }
  return work;
}

}    // namespace SPHSolid

#endif
