/* ----------------------------------------------------------------------
   Prints every force and heat of random clouds, to the last bit.  Built twice,
   with native vectors and with SPHSOLID_PORTABLE_VECTOR: both have to print
   the same (test physics.portable_vectors).
------------------------------------------------------------------------- */

#include "cloud.h"

#include <cstdio>

using namespace SPHSolid;

static void print_cloud(int dim, Frame frame, Viscosity viscosity, bool mixed)
{
  Cloud c = random_cloud(dim);
  c.opt.mixed = mixed;
  c.opt.frame = frame;
  c.opt.viscosity = viscosity;
  c.opt.hourglass = frame == Frame::LAGRANGIAN ? 0.03 : 0.0;
  c.material.strength = Strength::LINEAR;
  c.material.Y = 0.02;
  c.material.H = 0.1;
  c.evaluate(0.1);
  const std::vector<double> heat = c.heat(c.v);
  for (int i = 0; i < c.size(); i++)
    std::printf("%d %d %d %d %d: %a %a %a %a %a\n", mixed ? 1 : 0, dim, static_cast<int>(frame),
                static_cast<int>(viscosity), i, c.f(i)[0], c.f(i)[1], c.f(i)[2], heat[i],
                c.S[i][3]);
}

int main()
{
  for (bool mixed : {false, true})
    for (int dim : {2, 3}) {
      for (Viscosity v : {Viscosity::NONE, Viscosity::MONAGHAN, Viscosity::CORRECT}) {
        print_cloud(dim, Frame::EULERIAN, v, mixed);
        print_cloud(dim, Frame::LAGRANGIAN, v, mixed);
      }
      print_cloud(dim, Frame::LAGRANGIAN, Viscosity::LIMITED, mixed);
    }
  return 0;
}
