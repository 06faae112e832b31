/* ----------------------------------------------------------------------
   A disordered body for the tests of the gradient and force sweeps, and those of its
   particles at which the corrected gradient is exact.
------------------------------------------------------------------------- */

#ifndef SPH_SOLID_TEST_TURNED_BODY_H
#define SPH_SOLID_TEST_TURNED_BODY_H

#include "sums.h"

#include <Eigen/LU>

namespace SPHSolid {

// a jittered piece of lattice, turned by 0.6 rad

inline Cloud turned_body(int dim, double jitter = 0.15)
{
  Cloud c(dim);
  c.add_lattice(8, 8, dim == 3 ? 8 : 1);
  Noise noise(11);
  c.stir(noise, jitter);
  const Matrix3d Q = Eigen::AngleAxisd(0.6, Vector3d(0, 0, 1)).matrix() *
      Eigen::AngleAxisd(dim == 3 ? 0.4 : 0.0, Vector3d(1, 0, 0)).matrix();
  for (auto &x : c.x) x = Q * x;
  return c;
}

// those that see enough neighbors for the gradient correction: bulk and faces

inline std::vector<int> well_surrounded(const Cloud &c)
{
  std::vector<int> out;
  for (int i = 0; i < c.size(); i++)
    if (moment(c, i).determinant() > 0.25) out.push_back(i);
  return out;
}

inline Matrix3d any_gradient(int dim)
{
  Matrix3d G;
  G << 0.2, 0.7, -0.3, 0.1, -0.4, 0.5, 0.6, -0.2, 0.3;
  if (dim == 2) G.row(2).setZero(), G.col(2).setZero();
  return G;
}

}    // namespace SPHSolid

#endif
