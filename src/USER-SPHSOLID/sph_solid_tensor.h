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
   Small fixed-size tensors and how a symmetric one lies in memory.

   Every tensor of this package that leaves a function is stored as LAMMPS
   stores stresses: xx, yy, zz, xy, xz, yz (6 doubles), tension positive.
   No LAMMPS include here: this header is unit-tested on its own.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_TENSOR_H
#define LMP_SPH_SOLID_TENSOR_H

#include "sph_solid_vector.h"

#include <Eigen/Core>
#include <Eigen/LU>

namespace Eigen {
template <class N, class Number>
struct NumTraits<SPHSolid::PackOf<N, Number>> : GenericNumTraits<SPHSolid::PackOf<N, Number>> {
  typedef SPHSolid::PackOf<N, Number> Real;
  typedef Real NonInteger;
  typedef Real Nested;
  typedef double Literal;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};

// A tensor of packs is aligned as a pack is.  Eigen's own answer follows
// EIGEN_MAX_STATIC_ALIGN_BYTES, which may be less; some compilers (clang) refuse that
namespace internal {
  template <class N, class Number, int Size>
  struct compute_default_alignment<SPHSolid::PackOf<N, Number>, Size> {
    enum { value = 0 };    // nothing beyond that of its numbers
  };
}    // namespace internal
}    // namespace Eigen

namespace SPHSolid {

// second-order tensor and vector in D space dimensions; 2d means plane strain

// Real: a number, or a pack of them, one for each of its particles

template <int D, class Real = double> using Tensor = Eigen::Matrix<Real, D, D>;
template <int D> using Vector = Eigen::Matrix<double, D, 1>;

// the tensor of one lane

template <int D, class Real> inline Tensor<D> of_lane(const Tensor<D, Real> &t, int lane)
{
  return t.unaryExpr([lane](const Real &all) {
    return static_cast<double>(all[lane]);
  });
}

// Is a moment matrix M = sum V (x_j - x_i) (x) grad W well enough conditioned for its inverse, det M above
// this share of (tr M/D)^D?  positive: yes.  det M alone says nothing: of a corner of half cells in three
// dimensions it is 0.001, and its share of the other 0.4 to 0.8; of a row of particles both are 0

template <int D, class Real>
inline Real beyond_share(const Tensor<D, Real> &moment, double least_share)
{
  const Real mean = moment.trace() * (1.0 / D);
  Real round = mean;
  for (int a = 1; a < D; a++) round *= mean;
  return moment.determinant() - least_share * round;
}

// index of component (a,b) in the six stored numbers

static constexpr int VOIGT[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

}    // namespace SPHSolid

#endif
