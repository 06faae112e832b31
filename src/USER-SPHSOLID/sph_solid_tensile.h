/* ----------------------------------------------------------------------
   Artificial stress against the tensile instability:
   Gray, Monaghan & Swift, Comput. Methods Appl. Mech. Engrg. 190 (2001) 6641.

   The principal tensile stresses are reduced by eps of themselves in a pair
   that is closer than the initial spacing, times (W(r)/W(spacing))^n.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_TENSILE_H
#define LMP_SPH_SOLID_TENSILE_H

#include "sph_solid_kernel.h"
#include "sph_solid_tensor.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace SPHSolid {

// R = -eps * (tensile part of sigma), tension positive [pressure]

template <int D> inline Tensor<D> artificial_stress(const Tensor<D> &sigma, double eps)
{
  Eigen::SelfAdjointEigenSolver<Tensor<D>> eigen(sigma);
  const Vector<D> tension = eigen.eigenvalues().cwiseMax(0.0);
  return -eps * eigen.eigenvectors() * tension.asDiagonal() * eigen.eigenvectors().transpose();
}

// (W(r)/W(spacing))^n

template <int D> inline double crowding(double r, double h, double spacing, double n)
{
  return std::pow(CubicSpline<D>::w(r, h) / CubicSpline<D>::w(spacing, h), n);
}

}    // namespace SPHSolid

#endif
