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
   Mirror images in symmetry planes.

   The image of j interacts with i.  Since |x_i - image(x_j)| >= |x_i - x_j|
   for two particles on the same side, the neighbor list of i (and i itself)
   holds every candidate: no ghost particles are created.  Where planes meet,
   images of images complete the picture (quarter and eighth models).
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_IMAGES_H
#define LMP_SPH_SOLID_IMAGES_H

#include <vector>

namespace SPHSolid {

// a particle this close to a plane, in smoothing lengths, is on it, and the particle and its image
// are the two halves of one: no pair
constexpr double ON_PLANE = 1.0e-6;

struct Plane {
  int dim;            // normal along x, y or z: 0, 1, 2
  double position;    // coordinate of the plane [length]
};

// which particles have which images; reach = how far an image can act.
// an image is a source row and the set of planes it was mirrored in, as bits

class Images {
 public:
  void set_planes(const std::vector<Plane> &p) { planes = p; }
  const std::vector<Plane> &all_planes() const { return planes; }
  bool any() const { return !planes.empty(); }
  int count() const { return static_cast<int>(source.size()); }

  // find all images of those of the nall particles at x that have any; called when neighbors change
  template <class Call> void find(int nall, const double *const *x, double reach, Call has_images)
  {
    source.clear();
    bits.clear();
    first.assign(nall + 1, 0);
    for (int i = 0; i < nall; i++) {
      first[i] = count();
      if (!has_images(i)) continue;
      for (int b = 1; b < (1 << planes.size()); b++)
        if (within(x[i], b, reach)) {
          source.push_back(i);
          bits.push_back(b);
        }
    }
    first[nall] = count();
  }

  // images of particle i are first_of(i) .. first_of(i+1)-1
  int first_of(int i) const { return first[i]; }

  int source_of(int k) const { return source[k]; }

  // +1 or -1 for each dimension: how a vector component changes in image k
  void signs(int k, double *s) const
  {
    s[0] = s[1] = s[2] = 1.0;
    for (std::size_t p = 0; p < planes.size(); p++)
      if (bits[k] & (1 << p)) s[planes[p].dim] = -s[planes[p].dim];
  }

  // mirrored coordinates of image k of a particle at x, D of them
  template <int D> void position(int k, const double *x, double *out) const
  {
    for (int a = 0; a < D; a++) out[a] = x[a];
    for (std::size_t p = 0; p < planes.size(); p++)
      if (bits[k] & (1 << p)) {
        const int d = planes[p].dim;
        out[d] = 2.0 * planes[p].position - out[d];
      }
  }

 private:
  std::vector<Plane> planes;
  std::vector<int> source, bits, first;

  bool within(const double *x, int b, double reach) const
  {
    bool mirrored[3] = {false, false, false};
    for (std::size_t p = 0; p < planes.size(); p++) {
      if (!(b & (1 << p))) continue;
      const int dim = planes[p].dim;
      if (mirrored[dim]) return false;    // parallel planes lie further apart than the kernel
      mirrored[dim] = true;
      const double d = x[dim] - planes[p].position;
      if (d > reach || d < -reach) return false;
    }
    return true;
  }
};

}    // namespace SPHSolid

#endif
