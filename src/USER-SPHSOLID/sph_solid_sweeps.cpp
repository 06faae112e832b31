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
