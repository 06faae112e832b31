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
   What a neighbor reads of a particle in the Eulerian frame, packed: one row of doubles each for
   own particles, ghosts and mirror images, in this order.

   A sweep reads its neighbors from here only, so that an image in a symmetry
   plane is an ordinary neighbor with an index behind the last ghost.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_ROWS_H
#define LMP_SPH_SOLID_ROWS_H

#include "sph_solid_blocks.h"
#include "sph_solid_storage.h"

#include <vector>

namespace SPHSolid {

// Rows consist of blocks of four doubles (sph_solid_blocks.h).  A vector takes
// half a block in two dimensions and one block, the last double 0, in three.  A
// tensor T takes one block in two dimensions, row by row; in three one block per
// column, so that T.a is a sum of blocks times components of a

template <int D> struct Blocks {
  static constexpr int VECTOR = (D == 2) ? 2 : 4;
  static constexpr int TENSOR = (D == 2) ? 4 : 12;
  static constexpr int at(int a, int b) { return (D == 2) ? 2 * a + b : 4 * b + a; }
};

// kinematic row: the motion is filled before the gradient sweep, the rest stays as it is until
// neighbors are new.  In three dimensions mass and volume take the places that vectors leave
// free, so that, where all particles have one smoothing length, a row is one cache line

template <int D> struct Kinematics {
  static constexpr int X = 0;                        // position
  static constexpr int V = Blocks<D>::VECTOR;        // velocity; for heat: displacement
  static constexpr int MASS = (D == 2) ? 4 : 7;      // mass
  static constexpr int VOLUME = (D == 2) ? 5 : 3;    // weight of the gradient sweep, this step's,
                                                     // over h0^(D+2); for heat: K of the stress row
  static constexpr int LENGTHS = (D == 2) ? 4 : 8;    // block of the lengths, which have lanes
  static constexpr int H_LANE = (D == 2) ? 2 : 0;     // H_LANE of it and the next one
  static constexpr int H = LENGTHS + H_LANE;          // smoothing length
  static constexpr int NEAR = H + 1;                  // support of the nearest-neighbor kernel Wbar
  static constexpr int STRIDE = LENGTHS + BLOCK;
  static constexpr int SHORT = 8;    // of rows without lengths; in 2D da of eq. 28 lies there
};

// stress row, filled by the constitutive update and sent to ghosts.
// force on i from j: K_i K_j (T_i + T_j) grad W.  Gradient corrected:
// K = V, T = sigma B^T; plain: K = m, T = sigma/rho^2 (eq. 19)

template <int D> struct Stress {
  static constexpr int T = 0;
  static constexpr int K = Blocks<D>::TENSOR;    // weight
  static constexpr int RHO = K + 1;              // density
  static constexpr int C = K + 2;                // bulk sound speed
  static constexpr int NSUM = K + 3;             // n = sum m Wbar of the correction
  static constexpr int SWITCH = NSUM;            // in its place: of the viscosities that have one
  static constexpr int STRIDE = K + 4;
  // followed by tensors that only some scenes need: R of the artificial stress, velocity gradient
};

// one pair list: row i holds count[i] pairs from first[i] on, of which the
// first nearest[i] are nearest neighbors.  grad_i W_ij = F_ij (x_i - x_j).
// Rows follow each other without holes, so that the last vector of one has pairs of the next, too,
// in room for all candidates from which pairs are found in every step: a batch of particles begins
// at begin[batch] or before.  What only nearest neighbors have lies in arrays of its own, from
// near_first[i] on, in whole vectors, 0 behind the last

struct Pairs {
  std::vector<int> first, count, near_first, nearest;
  std::vector<int> begin;
  int most = 0;          // room of a batch at most
  Room<int> j;           // row index of the neighbor
  Room<float> factor;    // F_ij h0^(D+2), h0 the largest smoothing length: of order 1 in any units
};

}    // namespace SPHSolid

#endif
