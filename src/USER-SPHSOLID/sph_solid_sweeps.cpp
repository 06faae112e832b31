/* ----------------------------------------------------------------------
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
   Which sweeps a run takes; see sph_solid_sweeps.h.
------------------------------------------------------------------------- */

#include "sph_solid_sweeps.h"

#include "sph_solid_precision.h"

using namespace SPHSolid;

namespace {

template <int D, class Precision>
std::unique_ptr<Sweeps> of_frame(const Options &o, const std::vector<TypeData> &t)
{
  return o.frame == Frame::LAGRANGIAN ? lagrangian_sweeps<D, Precision>(o, t)
                                      : eulerian_sweeps<D, Precision>(o, t);
}

template <int D>
std::unique_ptr<Sweeps> of_dimension(const Options &o, const std::vector<TypeData> &t)
{
  return o.mixed ? of_frame<D, MixedPrecision>(o, t) : of_frame<D, DoublePrecision>(o, t);
}

}    // namespace

std::unique_ptr<Sweeps> Sweeps::create(int dimension, const Options &o,
                                       const std::vector<TypeData> &t)
{
  return dimension == 2 ? of_dimension<2>(o, t) : of_dimension<3>(o, t);
}
