/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

/* ----------------------------------------------------------------------
   Artificial stress against the tensile instability:
   Gray, Monaghan & Swift, Comput. Methods Appl. Mech. Engrg. 190 (2001) 6641.

   In a pair the principal tensile stresses are reduced by eps of themselves times
   (W(r)/W(spacing))^n: by all of eps at the initial spacing, by less where particles are further apart.
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

// base^n; whole exponents, as the usual 4 is one, by multiplication

inline double power(double base, double n)
{
  return std::pow(base, n);
}
template <class N, class Number> inline PackOf<N, Number> power(PackOf<N, Number> base, double n)
{
  if (n != std::floor(n) || n > 16.0)
    return pack_of<PackOf<N, Number>>([&](int m) {
      return std::pow(static_cast<double>(base[m]), n);
    });
  PackOf<N, Number> product = base;
  for (int k = 1; k < static_cast<int>(n); k++) product *= base;
  return product;
}

// (W(r)/W(spacing))^n; numbers or vectors of them

template <int D, class Real> inline Real crowding(Real r, Real h, Real spacing, double n)
{
  return power(CubicSpline<D>::w(r, h) / CubicSpline<D>::w(spacing, h), n);
}

}    // namespace SPHSolid

#endif
