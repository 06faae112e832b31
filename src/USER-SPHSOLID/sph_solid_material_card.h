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
   Material cards and the keywords of pair_coeff: reading and checking.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_MATERIAL_CARD_H
#define LMP_SPH_SOLID_MATERIAL_CARD_H

#include "sph_solid_material.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHSolid {

// keywords of one material, as a card or an input line holds them; units: of
// the card, converted to those of the run.  where: for messages
void parse_material(LAMMPS_NS::LAMMPS *, Material &, const std::vector<std::string> &words,
                    const std::string &units, const std::string &where);

// the words after "material NAME" in a card, and the units it states
std::vector<std::string> read_card(LAMMPS_NS::LAMMPS *, const std::string &file,
                                   const std::string &name, std::string &units);

// every keyword there and every value possible, or stop with a message
void check_material(LAMMPS_NS::LAMMPS *, const Material &, const std::string &where);

// one block of log lines: what was read and what follows from it
void log_material(LAMMPS_NS::LAMMPS *, int type, const Material &, double h, double spacing);

}    // namespace SPHSolid

#endif
