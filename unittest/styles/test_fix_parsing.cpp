/* ----------------------------------------------------------------------
   Arguments of the fixes and computes: the message for every wrong one.
------------------------------------------------------------------------- */

#include "answers.h"

using namespace sphsolid_test;

namespace {

std::string answer(const std::string &command)
{
  Session s;
  Block b;
  b.fixes = "";
  s(b.script());
  return s.error(command);
}

class CommandRefuses : public testing::TestWithParam<Case> {};

TEST_P(CommandRefuses, WithMessage)
{
  EXPECT_THAT(answer(GetParam().input), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(Fix, CommandRefuses,
                         testing::Values(Case{
                             "extra", "fix 1 all sph/solid now",
                             "Fix sph/solid has no arguments after its style, found 'now' ("}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(
    Dt, CommandRefuses,
    testing::Values(Case{"nothing", "fix 1 all sph/solid/dt",
                         "Illegal fix sph/solid/dt command: missing argument"},
                    Case{"no_cfl", "fix 1 all sph/solid/dt 1",
                         "Illegal fix sph/solid/dt command: missing argument"},
                    Case{"every_word", "fix 1 all sph/solid/dt often 0.3", "'often'"},
                    Case{"every_real", "fix 1 all sph/solid/dt 1.5 0.3", "'1.5'"},
                    Case{"every_zero", "fix 1 all sph/solid/dt 0 0.3",
                         "Fix sph/solid/dt: every is 0: expected an integer > 0 ("},
                    Case{"cfl_word", "fix 1 all sph/solid/dt 1 safe",
                         "Fix sph/solid/dt: cfl is 'safe': expected a number > 0 or auto ("},
                    Case{"cfl_negative", "fix 1 all sph/solid/dt 1 -0.3",
                         "Fix sph/solid/dt: cfl is '-0.3': expected a number > 0 or auto ("},
                    Case{"keyword", "fix 1 all sph/solid/dt 1 0.3 most 1",
                         "Fix sph/solid/dt: unknown keyword 'most': expected max or min ("},
                    Case{"max_missing", "fix 1 all sph/solid/dt 1 0.3 max",
                         "Illegal fix sph/solid/dt max command: missing argument"},
                    Case{"min_missing", "fix 1 all sph/solid/dt 1 0.3 max 1 min",
                         "Illegal fix sph/solid/dt min command: missing argument"},
                    Case{"max_zero", "fix 1 all sph/solid/dt 1 0.3 max 0",
                         "Fix sph/solid/dt: max is 0: expected a time step > 0 ("},
                    Case{"min_negative", "fix 1 all sph/solid/dt 1 0.3 min -1",
                         "Fix sph/solid/dt: min is -1: expected a time step > 0 ("},
                    Case{"min_above_max", "fix 1 all sph/solid/dt 1 0.3 max 1 min 2",
                         "Fix sph/solid/dt: min 2 is larger than max 1 ("}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Wall, CommandRefuses,
    testing::Values(
        Case{"nothing", "fix 1 all sph/solid/wall",
             "Illegal fix sph/solid/wall command: missing argument"},
        Case{"no_position", "fix 1 all sph/solid/wall ylo",
             "Illegal fix sph/solid/wall command: missing argument"},
        Case{"side", "fix 1 all sph/solid/wall floor 0",
             "Fix sph/solid/wall: unknown side 'floor': expected xlo, xhi, ylo, yhi, zlo or zhi ("},
        Case{"position_word", "fix 1 all sph/solid/wall ylo bottom", "'bottom'"},
        Case{"kind", "fix 1 all sph/solid/wall ylo 0 sticky",
             "Fix sph/solid/wall: unknown kind 'sticky': expected contact or symmetry ("},
        Case{"extra", "fix 1 all sph/solid/wall ylo 0 contact now",
             "Fix sph/solid/wall: found 'now' after the last argument ("},
        Case{"third_side_in_2d", "fix 1 all sph/solid/wall zhi 0",
             "Fix sph/solid/wall: side zhi does not exist in two dimensions ("}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Atom, CommandRefuses,
    testing::Values(
        Case{"nothing", "compute 1 all sph/solid/atom",
             "Illegal compute sph/solid/atom command: missing argument"},
        Case{"name", "compute 1 all sph/solid/atom rho density",
             "Compute sph/solid/atom: unknown name 'density': expected one of rho p e c epl "
             "vonmises sxx syy szz sxy sxz syz h neigh ("}),
    name_of);

INSTANTIATE_TEST_SUITE_P(Energy, CommandRefuses,
                         testing::Values(Case{
                             "extra", "compute 1 all sph/solid/energy total",
                             "Compute sph/solid/energy has no arguments, found 'total' ("}),
                         name_of);

/* ---------------------------------------------------------------------- */

class CommandAccepts : public testing::TestWithParam<Case> {};

TEST_P(CommandAccepts, AndRuns)
{
  Session s;
  Block b;
  b.nx = b.ny = 4;
  b.fixes = "fix move all sph/solid\ntimestep 1e-8\n";
  s(b.script());
  s(GetParam().input);
  s("run 2");
  EXPECT_EQ(s.value("step"), 2.0);
}

INSTANTIATE_TEST_SUITE_P(
    Command, CommandAccepts,
    testing::Values(
        Case{"dt", "fix 1 all sph/solid/dt 5 0.3", ""},
        Case{"dt_auto", "fix 1 all sph/solid/dt 5 auto", ""},
        Case{"dt_max", "fix 1 all sph/solid/dt 1 0.3 max 1e-8", ""},
        Case{"dt_both", "fix 1 all sph/solid/dt 1 0.3 min 1e-9 max 1e-8", ""},
        Case{"xlo", "fix 1 all sph/solid/wall xlo 0", ""},
        Case{"xhi", "fix 1 all sph/solid/wall xhi 0.003", ""},
        Case{"ylo", "fix 1 all sph/solid/wall ylo 0 contact", ""},
        Case{"yhi", "fix 1 all sph/solid/wall yhi 0.003 symmetry", ""},
        Case{"every_column",
             "compute 1 all sph/solid/atom rho p e c epl vonmises sxx syy szz sxy sxz syz "
             "h neigh\ncompute 2 all reduce sum c_1[*]\nthermo_style custom step c_2[*]",
             ""},
        Case{"one_column",
             "compute 1 all sph/solid/atom p\ncompute 2 all reduce sum c_1\n"
             "thermo_style custom step c_2",
             ""},
        Case{"energy", "compute 1 all sph/solid/energy\nthermo_style custom step c_1 c_1[*]", ""}),
    name_of);

// without the pair style each of them says so

class NeedsThePair : public testing::TestWithParam<Case> {};

TEST_P(NeedsThePair, AndSaysSo)
{
  Session s;
  s(Block().particles());
  s("pair_style zero 1e-3\npair_coeff * *");
  s(GetParam().input);
  EXPECT_THAT(
      s.error("run 0"),
      HasSubstr(GetParam().message + " needs pair style sph/solid, once (alone or in hybrid)"));
}

INSTANTIATE_TEST_SUITE_P(
    Command, NeedsThePair,
    testing::Values(Case{"fix", "fix 1 all sph/solid", "Fix sph/solid"},
                    Case{"dt", "fix 1 all sph/solid/dt 1 0.3", "Fix sph/solid/dt"},
                    Case{"wall", "fix 1 all sph/solid/wall ylo 0", "Fix sph/solid/wall"},
                    Case{"atom", "compute 1 all sph/solid/atom p", "Compute sph/solid/atom"},
                    Case{"energy", "compute 1 all sph/solid/energy", "Compute sph/solid/energy"}),
    name_of);

}    // namespace
