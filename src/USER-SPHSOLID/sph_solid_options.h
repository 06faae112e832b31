/* ----------------------------------------------------------------------
   Arguments of the pair_style command: reading, checking, saving.
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
