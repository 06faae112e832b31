/* ----------------------------------------------------------------------
   Cubic B-spline kernel W(r,h), support 2h (Shaw & Reid 2009, eq. 22).

   W in 1/length^D, dW/dr in 1/length^(D+1).  The sweeps want the gradient
   as  grad_i W(x_i - x_j) = F x_ij  with  F = (dW/dr)/r, which is finite at
   r = 0, so that a particle and its mirror image may coincide.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_KERNEL_H
#define LMP_SPH_SOLID_KERNEL_H

namespace SPHSolid {

static constexpr double PI_SPH = 3.14159265358979323846;

template <int D> struct CubicSpline {
  static_assert(D == 2 || D == 3, "plane strain or three dimensions");

  // reach of the kernel in units of h
  static constexpr double SUPPORT = 2.0;

  // alpha_D h^D: 10/(7 pi) in 2d, 1/pi in 3d
  static constexpr double NORM = (D == 2) ? 10.0 / (7.0 * PI_SPH) : 1.0 / PI_SPH;

  // hinv^D
  static inline double power(double hinv) { return (D == 2) ? hinv * hinv : hinv * hinv * hinv; }

  static inline double w(double r, double h)
  {
    const double hinv = 1.0 / h;
    const double q = r * hinv;
    const double s = q < 2.0 ? 2.0 - q : 0.0;
    const double t = q < 1.0 ? 1.0 - q : 0.0;
    // (2-q)^3/4 - (1-q)^3 is eq. 22 with both branches in one line
    return NORM * power(hinv) * (0.25 * s * s * s - t * t * t);
  }

  // F = (dW/dr)/r, negative inside the support
  static inline double gradient_factor(double r, double h)
  {
    const double hinv = 1.0 / h;
    const double q = r * hinv;
    const double inner = -3.0 + 2.25 * q;
    const double s = 2.0 - q;
    const double outer = -0.75 * s * s / (q > 1.0 ? q : 1.0);
    const double f = q < 1.0 ? inner : outer;
    return NORM * power(hinv) * hinv * hinv * (q < 2.0 ? f : 0.0);
  }
};

}    // namespace SPHSolid

#endif
