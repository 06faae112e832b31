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

using namespace SPHSolid;

std::unique_ptr<Sweeps> Sweeps::create(int dimension, const Options &o,
                                       const std::vector<TypeData> &t)
{
  if (o.frame == Frame::LAGRANGIAN)
    return dimension == 2 ? lagrangian_sweeps<2>(o, t) : lagrangian_sweeps<3>(o, t);
  return dimension == 2 ? eulerian_sweeps<2>(o, t) : eulerian_sweeps<3>(o, t);
}
