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
   Arguments of the pair_style command: reading, checking.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_OPTIONS_H
#define LMP_SPH_SOLID_OPTIONS_H

#include "sph_solid_sweeps.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHSolid {

// pair_style sph/solid <h> [keyword values ...]; stops with a message that
// names the keyword, the value and what was expected
Options parse_options(LAMMPS_NS::LAMMPS *, int narg, char **arg);

}    // namespace SPHSolid

#endif
