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

// A number in the words of a user

#ifndef LMP_SPH_SOLID_NUMBER_H
#define LMP_SPH_SOLID_NUMBER_H

#include "utils.h"

#include <optional>
#include <stdexcept>
#include <string>

namespace SPHSolid {

// nothing unless the whole word is a number that a double can hold: 1e400 and 1e-400 are none

inline std::optional<double> number_of(const std::string &word)
{
  if (!LAMMPS_NS::utils::is_double(word)) return std::nullopt;
  try {
    return std::stod(word);
  } catch (const std::out_of_range &) {
    return std::nullopt;
  }
}

}    // namespace SPHSolid

#endif
