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
   The least principal stretch of a deformation gradient F: the root of the least eigenvalue
   of F^T F.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_STRETCH_H
#define LMP_SPH_SOLID_STRETCH_H

#include "sph_solid_tensor.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace SPHSolid {

template <int D> double least_stretch(const Tensor<D> &F)
{
  Eigen::SelfAdjointEigenSolver<Tensor<D>> eigen;
  eigen.computeDirect(F.transpose() * F, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(eigen.eigenvalues()[0], 0.0));
}

// A lower bound for as many particles as there are lanes, in two dimensions the stretch itself but
// for rounding: the square of one eigenvalue's distance from the mean of all D is at most
// (D-1)/D of the sum of these squares.  A few operations instead of an eigenvalue problem, for
// those who want to know who can be beyond a limit at all

template <int D, class Real> Real stretch_bound(const Tensor<D, Real> &F)
{
  constexpr double ROUNDING = sizeof(F(0, 0)[0]) < sizeof(double) ? 1.0e-5 : 1.0e-9;
  Tensor<D, Real> C = F.transpose() * F;
  const Real mean = C.trace() / double(D);
  for (int a = 0; a < D; a++) C(a, a) -= mean;
  const Real least = mean - square_root(C.cwiseProduct(C).sum() * ((D - 1.0) / D));
  return square_root(maximum(least - ROUNDING * mean, Real(0.0)));
}

}    // namespace SPHSolid

#endif
