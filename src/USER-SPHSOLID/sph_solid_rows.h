/* ----------------------------------------------------------------------
   What a neighbor reads of a particle, packed: one row of doubles each for
   own particles, ghosts and mirror images, in this order.

   A sweep reads its neighbors from here only, so that an image in a symmetry
   plane is an ordinary neighbor with an index behind the last ghost.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_ROWS_H
#define LMP_SPH_SOLID_ROWS_H

#include <vector>

namespace SPHSolid {

// kinematic row, filled before the gradient sweep

template <int D> struct Kinematics {
  static constexpr int X = 0;                 // position
  static constexpr int V = D;                 // velocity at the half step
  static constexpr int MASS = 2 * D;          // mass
  static constexpr int VOLUME = 2 * D + 1;    // the weight of the gradient sweep
  static constexpr int H = 2 * D + 2;         // smoothing length
  static constexpr int NEAR = 2 * D + 3;      // support of the nearest-neighbor kernel Wbar
  static constexpr int STRIDE = (D == 2) ? 8 : 10;
};

// stress row, filled by the constitutive update and sent to ghosts.
// force on i from j: K_i K_j (T_i + T_j) grad W.  eulerian, gradient corrected:
// K = V, T = sigma B^T; plain: K = m, T = sigma/rho^2 (eq. 19).  lagrangian:
// K = V0, T = sigma C, C = J F^-T B^T

template <int D> struct Stress {
  static constexpr int T = 0;               // D x D, row by row
  static constexpr int K = D * D;           // weight
  static constexpr int RHO = D * D + 1;     // density
  static constexpr int C = D * D + 2;       // bulk sound speed
  static constexpr int NSUM = D * D + 3;    // n = sum m Wbar of the correction
  static constexpr int STRIDE = D * D + 4;
  // followed by tensors (D x D) that only some scenes need.  eulerian: R of the
  // artificial stress; lagrangian: C, and F' with rho c_L h behind it
};

// one pair list: row i holds count[i] pairs from first[i] on, of which the
// first nearest[i] are nearest neighbors.  grad_i W_ij = factor * (y_i - y_j),
// where y are the positions the kernel belongs to: this step's (eulerian) or
// those of the reference configuration (lagrangian, there times V0_j)

struct Pairs {
  std::vector<int> first, count, nearest;
  std::vector<int> j;            // row index of the neighbor
  std::vector<double> factor;    // F_ij
};

}    // namespace SPHSolid

#endif
