/* ----------------------------------------------------------------------
   Bodies for the tests of the Lagrangian frame: a disordered reference
   configuration with particles of different volume, and what has deformed
   it since.
------------------------------------------------------------------------- */

#ifndef SPH_SOLID_TEST_LAGRANGIAN_BODY_H
#define SPH_SOLID_TEST_LAGRANGIAN_BODY_H

#include "sums.h"

namespace SPHSolid {

inline Matrix3d rows(double xx, double xy, double xz, double yx, double yy, double yz, double zx,
                     double zy, double zz)
{
  Matrix3d m;
  m << xx, xy, xz, yx, yy, yz, zx, zy, zz;
  return m;
}

// a jittered body at rest in its reference, without stress

inline Cloud body(int dim, int seed = 1, double jitter = 0.2)
{
  Cloud c(dim);
  c.opt.frame = Frame::LAGRANGIAN;
  c.opt.viscosity = Viscosity::NONE;
  if (dim == 2)
    c.add_lattice(9, 8);
  else
    c.add_lattice(5, 5, 4);
  Noise noise(seed);
  for (int i = 0; i < c.size(); i++) {
    c.x[i] += jitter * noise.vector(dim);
    c.volume[i] *= 1.0 + 0.2 * noise();
    c.mass[i] = c.volume[i] * c.material.rho0;
  }
  c.refer();
  return c;
}

// x = A X, v = G X

inline void deform(Cloud &c, const Matrix3d &A, const Matrix3d &G = Matrix3d::Zero())
{
  for (int i = 0; i < c.size(); i++) {
    c.x[i] = A * c.xref[i];
    c.v[i] = G * c.xref[i];
  }
}

// large stretch and shear with a rotation; plane in two dimensions

inline Matrix3d large(int dim)
{
  return dim == 2 ? rows(1.8, 0.6, 0, -0.5, 0.7, 0, 0, 0, 1)
                  : rows(1.8, 0.6, -0.2, -0.5, 0.7, 0.3, 0.2, 0.4, 1.3);
}

// principal stretches x, y and z between two turns

inline Matrix3d turned_stretch(double x, double y, double z)
{
  const Matrix3d turn = Eigen::AngleAxisd(0.5, Vector3d(0, 0, 1)).toRotationMatrix();
  return turn * Vector3d(x, y, z).asDiagonal() * turn;
}

// stretched, sheared, shaken, pre-stressed and in motion

inline Cloud shaken(int dim, int seed)
{
  Cloud c = body(dim, seed);
  const Matrix3d A = dim == 2 ? rows(1.2, 0.3, 0, -0.1, 0.8, 0, 0, 0, 1)
                              : rows(1.2, 0.3, -0.1, -0.1, 0.8, 0.2, 0.1, 0.1, 1.1);
  deform(c, A);
  Noise noise(100 + seed);
  c.stir(noise, 0.05);
  return c;
}

}    // namespace SPHSolid

#endif
