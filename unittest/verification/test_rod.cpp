/* ----------------------------------------------------------------------
   The whole Taylor rod of examples/taylor (21 x 67 particles, h = 1.5
   spacings, 50 us) on several ranks, newton on and off, against the same rod
   on one rank alone.

   Sums run in the order of atom IDs, and in.taylor numbers the atoms by their
   positions.  So there is no difference that could grow: the states at 10, 20,
   ... 50 us are equal to the last bit on 1, 2 and 4 ranks, newton on and off;
   energies, which are sums over ranks, to 6e-14 of the total.

   Without that (reset_atoms id sort yes), create_atoms numbers the atoms rank
   by rank, sums run in another order, and the torn foot amplifies rounding.
   Measured between the two numberings on one rank; lengths in mm (of 20.5 and
   19.6), energies over KE0, positions over the width of the rod:

     time (us)           10      20      30      35      40      45      50
     length           0       0      7e-15   5e-14   2e-6    7e-4    6e-4
     foot             4e-15   0      1e-14   3e-14   5e-6    4e-4    7e-3
     kinetic energy   6e-16   0      5e-16   3e-13   4e-5    1e-4    1e-5
     plastic work     1e-15   1e-15  1e-14   4e-13   4e-4    7e-5    9e-5
     worst position   1e-15   4e-13  1e-10           7e-3            1e-2

   Started by mpiexec.  With more ranks than processors waiting costs minutes:
   there newton on ends at 20 and newton off at 10 us (all 50 us were measured
   once, all equal).
------------------------------------------------------------------------- */

#include "ranks.h"

#include <thread>

using namespace sphsolid_test;

namespace {

// in.taylor as it is in the examples, with another line "newton", other
// folders, and without its own run command

std::string taylor(const std::string &newton)
{
  const std::string root = SPHSOLID_TEST_ROOT;
  std::istringstream in(read_file(root + "/examples/taylor/in.taylor"));
  std::string line, out;
  bool switched = false;
  while (std::getline(in, line)) {
    if (line.rfind("newton", 0) == 0) {
      line = "newton " + newton;
      switched = true;
    }
    if (line.rfind("run ", 0) == 0) continue;
    const auto at = line.find("../../potentials");
    if (at != std::string::npos) line.replace(at, 5, root);
    out += line + "\n";
  }
  EXPECT_TRUE(switched) << "in.taylor has no line newton";
  return out;
}

// where the run is looked at: its state, and the figures of the table

struct Shot {
  State state;
  double length, foot, energy[8];
};

constexpr int SHOTS = 5;

std::vector<Shot> rod(MPI_Comm comm, const std::string &newton, int nshots = SHOTS,
                      const std::string &h = "1.5", const std::string &part = "whole")
{
  const std::string input = shared_file("in.taylor", comm), output = shared_file("output", comm);
  if (first_rank(comm)) write_file("in.taylor", taylor(newton));
  MPI_Barrier(comm);

  Session s(comm);
  s("variable frame index " + frame_under_test() + "\nvariable h index " + h +
    "\nvariable part index " + part + "\nvariable out index " + output + "\ninclude " + input +
    "\n");
  std::vector<Shot> shots;
  for (int k = 1; k <= nshots; k++) {
    s("unfix stop\nfix stop all halt 1 v_time >= " + num(k * 1.0e-5) +
      " error continue message no\nrun 1000000\n");
    Shot shot;
    shot.state = s.state();
    shot.length = s.value("v_length");
    shot.foot = s.value("v_foot");
    for (int i = 0; i < 7; i++) shot.energy[i] = s.value("c_energy[" + std::to_string(i + 1) + "]");
    shot.energy[7] = s.value("c_energy");
    shots.push_back(shot);
  }
  return shots;
}

// the rod of the first rank alone

const std::vector<Shot> &alone()
{
  static std::vector<Shot> shots;
  if (!shots.empty()) return shots;
  if (first_rank())
    shots = rod(MPI_COMM_SELF, "off");
  else
    shots.resize(SHOTS);
  for (Shot &shot : shots) {
    share(shot.state);
    share(&shot.length, sizeof(double));
    share(&shot.foot, sizeof(double));
    share(shot.energy, sizeof(shot.energy));
  }
  return shots;
}

class Rod : public testing::TestWithParam<std::string> {};

TEST_P(Rod, IsTheSameOnAllRanks)
{
  const bool crowded = ranks() > static_cast<int>(std::thread::hardware_concurrency());
  const int nshots = !crowded ? SHOTS : GetParam() == "on" ? 2 : 1;
  const std::vector<Shot> &one = alone(), all = rod(MPI_COMM_WORLD, GetParam(), nshots);
  ASSERT_EQ(all.size(), static_cast<std::size_t>(nshots));
  for (int k = 0; k < nshots; k++) {
    SCOPED_TRACE("at " + std::to_string(10 * (k + 1)) + " us");
    ASSERT_EQ(one[k].state.size(), 21u * 67u);
    expect_bitwise(one[k].state, all[k].state);
    EXPECT_EQ(one[k].length, all[k].length);
    EXPECT_EQ(one[k].foot, all[k].foot);
    // sums over ranks: rounding
    for (int i = 0; i < 8; i++)
      EXPECT_NEAR(one[k].energy[i], all[k].energy[i], 1.0e-12 * one[k].energy[7]) << i;
  }
}

// half a rod and its mirror image are a whole one, at the time of largest changes: to rounding, and
// half of the energies.  Rounding differs at 1e-16, and in a few pairs of 10^8 the Eulerian frame then rounds a
// distance the other way to single precision: that pair's kernel changes by 6e-8, kinetic energy by 1e-11 of all

TEST(HalfRod, IsHalfOfTheWholeOne)
{
  if (!first_rank()) return;
  const std::string h = frame_under_test() == "lagrangian" ? "1.0" : "1.5";
  const Shot whole = rod(MPI_COMM_SELF, "off", 2, h).back(),
             half = rod(MPI_COMM_SELF, "off", 2, h, "half").back();
  EXPECT_EQ(whole.state.size(), 21u * 67u);
  EXPECT_EQ(half.state.size(), 11u * 67u);
  const bool exact = frame_under_test() == "lagrangian";
  const double rounding = exact ? 1.0e-12 : 1.0e-11, of_energy = exact ? 1.0e-11 : 5.0e-11;
  EXPECT_NEAR(half.length / whole.length, 1.0, rounding);
  EXPECT_NEAR(half.foot / whole.foot, 1.0, rounding);
  for (int i = 0; i < 8; i++)
    EXPECT_NEAR(2.0 * half.energy[i], whole.energy[i], of_energy * whole.energy[7]) << i;
}

INSTANTIATE_TEST_SUITE_P(Newton, Rod, testing::Values("off", "on"), [](const auto &info) {
  return info.param;
});

}    // namespace
