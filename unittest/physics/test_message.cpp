/* ----------------------------------------------------------------------
   What ghosts are sent.  A hybrid pair style asks once, before options are known, how long a
   message can be, and LAMMPS' buffers do not grow.
------------------------------------------------------------------------- */

#include "cloud.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

namespace {

TEST(Messages, NoneIsLongerThanWhatIsSaidBeforehand)
{
  int longest = 0;
  for (int dimension : {2, 3})
    for (Frame frame : {Frame::EULERIAN, Frame::LAGRANGIAN})
      for (Viscosity viscosity : VISCOSITIES)
        for (bool tensile : {false, true}) {
          Options o;
          o.h = 1.3;
          o.frame = frame;
          o.viscosity = viscosity;
          o.tensile = tensile && frame == Frame::EULERIAN;
          o.hourglass = frame == Frame::LAGRANGIAN ? 0.1 : 0.0;
          const auto sweeps = Sweeps::create(dimension, o, std::vector<TypeData>(2));
          for (Message what :
               {Message::STRESS, Message::SWITCH, Message::VISCOUS, Message::DISPLACEMENT})
            longest = std::max(longest, sweeps->message_size(what));
        }
  EXPECT_EQ(longest, LARGEST_MESSAGE);
}

}    // namespace
