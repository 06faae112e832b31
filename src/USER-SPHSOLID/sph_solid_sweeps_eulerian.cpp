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
   The sweeps of the Eulerian frame in double precision, a source file of their own since that
   is most of the time that this package takes to compile.
------------------------------------------------------------------------- */

#include "sph_solid_eulerian_sweeps.h"

template std::unique_ptr<Sweeps>
SPHSolid::eulerian_sweeps<2, DoublePrecision>(const Options &, const std::vector<TypeData> &);
template std::unique_ptr<Sweeps>
SPHSolid::eulerian_sweeps<3, DoublePrecision>(const Options &, const std::vector<TypeData> &);
