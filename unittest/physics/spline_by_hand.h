/* ----------------------------------------------------------------------
   The cubic spline (Monaghan & Lattanzio 1985) written out for the tests: nothing of it is the
   package's own kernel.
------------------------------------------------------------------------- */

#ifndef SPH_SOLID_TEST_SPLINE_BY_HAND_H
#define SPH_SOLID_TEST_SPLINE_BY_HAND_H

#include <cmath>

namespace SPHSolid {

// without its factor, of q = r/h, and minus its derivative

inline double spline(double q)
{
  if (q <= 1.0) return 1.0 - 1.5 * q * q + 0.75 * q * q * q;
  return q < 2.0 ? 0.25 * std::pow(2.0 - q, 3) : 0.0;
}

inline double spline_slope(double q)
{
  if (q <= 1.0) return 3.0 * q - 2.25 * q * q;
  return q < 2.0 ? 0.75 * (2.0 - q) * (2.0 - q) : 0.0;
}

// -W'(r)/r

inline double psi_by_hand(int dim, double r, double h)
{
  const double beta = dim == 2 ? 10.0 / (7.0 * M_PI * h * h) : 1.0 / (M_PI * h * h * h);
  return beta * spline_slope(r / h) / (h * r);
}

}    // namespace SPHSolid

#endif
