/* ----------------------------------------------------------------------
   Where the Lagrangian frame ends: the message, the warning or nothing.
------------------------------------------------------------------------- */

#include "lagrangian_block.h"

using namespace sphsolid_test;

namespace {

// soft, so that a jump of the positions between two runs does not blow up

Block torn(const std::string &options)
{
  Block b = body("viscosity none hourglass 0 " + options);
  b.material = "inline rho0 7850 eos mie-gruneisen 3600 1.8 1.8 shear 1e5 strength elastic\n";
  b.motion = "";
  b.fixes = "fix move all sph/solid\ntimestep 1e-9\n";
  return b;
}

// turned over between two runs: the whole body is mirrored in x

const std::string MIRROR = "variable dx atom -2*x\ndisplace_atoms all move v_dx 0 0 units box\n";

TEST(Distortion, StopsWithThePlaceAndAWayOut)
{
  Session s;
  s(torn("").script());
  s("run 5");
  const std::string message = s.error(MIRROR + "run 1");
  EXPECT_THAT(message,
              HasSubstr("the deformation is beyond what this frame can follow at particle "));
  EXPECT_THAT(message,
              HasSubstr(" in step 5: its deformation gradient has turned over, with "
                        "determinant -1"));
  EXPECT_THAT(message,
              HasSubstr("Use frame eulerian for fracture, splash and self-contact, or "
                        "pair_style keyword distortion warn to go on"));
}

TEST(Distortion, NamesTheLeastStretch)
{
  Session s;
  s(torn("").script());
  EXPECT_THAT(s.error("run 5\nvariable dx atom -0.995*x\ndisplace_atoms all move v_dx 0 0 units "
                      "box\nset group all sph/rho 7850\nrun 1"),
              HasSubstr("it is squeezed flat, with a least principal stretch of 0.005"));
}

TEST(Distortion, NamesAnOverlap)
{
  Session s;
  s(torn("").script());
  const std::string message =
      s.error("run 5\ngroup a id 21\ngroup b id 22\ndisplace_atoms a move 0.000498 0 0 units box\n"
              "displace_atoms b move -0.000498 0 0 units box\nrun 1");
  EXPECT_THAT(message, HasSubstr("at particle 21 at 0.002498 "));
  EXPECT_THAT(message,
              HasSubstr("it lies on a partner, their distance over that in the reference "
                        "is 0.004"));
}

TEST(Distortion, WarnsOnceAndGoesOn)
{
  Session s;
  s(torn("distortion warn").script());
  s("run 5\n" + MIRROR + "run 100");
  EXPECT_EQ(s.value("step"), 105.0);
  const std::string log = s.log(), text = "its deformation gradient has turned over";
  const std::size_t first = log.find(text);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(log.find(text, first + 1), std::string::npos);
  EXPECT_THAT(log, HasSubstr("WARNING: sph/solid, frame lagrangian"));
}

TEST(Distortion, IgnoredIsSilent)
{
  Session s;
  s(torn("distortion ignore").script());
  s("run 5\n" + MIRROR + "run 100");
  EXPECT_EQ(s.value("step"), 105.0);
  EXPECT_THAT(s.log(), Not(HasSubstr("deformation")));
}

}    // namespace
