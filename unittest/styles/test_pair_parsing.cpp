/* ----------------------------------------------------------------------
   pair_style sph/solid: every keyword, and the message for every wrong value.
------------------------------------------------------------------------- */

#include "answers.h"

using namespace sphsolid_test;

namespace {

Block small(const std::string &arguments)
{
  Block b;
  b.nx = b.ny = 4;
  b.options = arguments;
  return b;
}

/* ---------------------------------------------------------------------- */

class PairStyleAccepts : public testing::TestWithParam<Case> {};

TEST_P(PairStyleAccepts, AndRuns)
{
  Session s;
  s(small(GetParam().input).script());
  s("run 2");
  EXPECT_EQ(s.value("step"), 2.0);
}

INSTANTIATE_TEST_SUITE_P(
    Keyword, PairStyleAccepts,
    testing::Values(
        Case{"nothing", "", ""}, Case{"viscosity_none", "viscosity none", ""},
        Case{"viscosity_monaghan", "viscosity monaghan 1 2", ""},
        Case{"viscosity_monaghan_zero", "viscosity monaghan 0 0", ""},
        Case{"viscosity_correct", "viscosity correct", ""},
        Case{"hbar", "viscosity correct hbar 1.2", ""},
        Case{"weights_conservative", "viscosity correct weights conservative", ""},
        Case{"weights_shepard", "viscosity correct weights shepard", ""},
        Case{"weights_safe", "viscosity correct weights safe", ""},
        Case{"alpha", "viscosity correct alpha 0.5 0.25", ""},
        Case{"heating_compatible", "viscosity correct heating compatible", ""},
        Case{"heating_printed", "viscosity correct heating printed", ""},
        Case{"all_of_correct",
             "viscosity correct heating printed alpha 1 2 weights shepard hbar 1.6 gradient plain",
             ""},
        Case{"gradient_plain", "gradient plain", ""},
        Case{"gradient_corrected", "gradient corrected", ""},
        Case{"tensile_none", "tensile none", ""},
        Case{"tensile_artificial", "tensile artificial 0.3 4", ""},
        Case{"frame_eulerian", "frame eulerian", ""},
        Case{"frame_lagrangian", "frame lagrangian", ""},
        Case{"hourglass", "frame lagrangian hourglass 0.1", ""},
        Case{"limited", "frame lagrangian viscosity limited 1 0.5", ""},
        Case{"limited_eulerian", "frame eulerian viscosity limited 1 0.5", ""},
        Case{"limited_plain", "frame eulerian viscosity limited 2 2 gradient plain", ""},
        Case{"balsara", "viscosity balsara 1 1", ""},
        Case{"balsara_tensile", "frame eulerian viscosity balsara 1 1 tensile artificial 0.3 4",
             ""},
        Case{"front", "viscosity front", ""},
        Case{"front_lagrangian", "frame lagrangian viscosity front hourglass 0", ""},
        Case{"front_alpha", "viscosity front alpha 1.5 2 gradient corrected", ""},
        Case{"front_tensile",
             "frame eulerian viscosity front gradient plain tensile artificial 0.3 4", ""},
        Case{"distortion_error", "distortion error", ""},
        Case{"distortion_warn", "distortion warn", ""},
        Case{"distortion_ignore", "distortion ignore", ""}, Case{"energy_yes", "energy yes", ""},
        Case{"precision_double", "precision double", ""},
        Case{"precision_mixed", "precision mixed", ""}, Case{"hourglass_zero", "hourglass 0", ""},
        Case{"any_order", "hourglass 0 frame eulerian tensile none viscosity none", ""}),
    name_of);

/* ---------------------------------------------------------------------- */

class PairStyleRefuses : public testing::TestWithParam<Case> {};

TEST_P(PairStyleRefuses, WithMessage)
{
  Session s;
  s(small("").particles());
  EXPECT_THAT(s.error("pair_style sph/solid " + GetParam().input),
              HasSubstr("pair_style sph/solid: " + GetParam().message + " ("));
}

INSTANTIATE_TEST_SUITE_P(
    Wrong, PairStyleRefuses,
    testing::Values(
        Case{"no_h", "", "expected the smoothing length h, a number > 0"},
        Case{"h_word", "one", "smoothing length h of pair_style is 'one': expected a number > 0"},
        Case{"h_zero", "0", "smoothing length h of pair_style is 0: expected a number > 0"},
        Case{"h_negative", "-1", "smoothing length h of pair_style is -1: expected a number > 0"},
        Case{"h_nan", "nan", "smoothing length h of pair_style is 'nan': expected a number > 0"},
        Case{"h_too_large", "1e400",
             "smoothing length h of pair_style is '1e400': expected a number > 0"},
        Case{"h_too_small", "1e-400",
             "smoothing length h of pair_style is '1e-400': expected a number > 0"},
        Case{"a1_too_large", "1 viscosity monaghan 1e400 1",
             "a1 of viscosity monaghan is '1e400': expected a number >= 0"},
        Case{"keyword", "1 viscous none",
             "unknown keyword 'viscous': expected viscosity, gradient, tensile, frame, hourglass, "
             "distortion, energy or precision"},
        Case{"viscosity_missing", "1 viscosity",
             "keyword viscosity needs none, monaghan, correct, limited, balsara or front"},
        Case{"viscosity_word", "1 viscosity some",
             "unknown viscosity 'some': expected none, monaghan, correct, limited, balsara or "
             "front"},
        Case{"a1_missing", "1 viscosity monaghan", "keyword viscosity monaghan needs a1"},
        Case{"a2_missing", "1 viscosity monaghan 1", "keyword viscosity monaghan needs a2"},
        Case{"a1_word", "1 viscosity monaghan a 1",
             "a1 of viscosity monaghan is 'a': expected a number >= 0"},
        Case{"a2_negative", "1 viscosity monaghan 1 -2",
             "a2 of viscosity monaghan is -2: expected a number >= 0"},
        Case{"hbar_missing", "1 viscosity correct hbar",
             "keyword viscosity correct hbar needs support in spacings"},
        Case{"hbar_zero", "1 viscosity correct hbar 0",
             "support in spacings of viscosity correct hbar is 0: expected a number > 0"},
        Case{"weights_missing", "1 viscosity correct weights",
             "keyword viscosity correct weights needs conservative, shepard or safe"},
        Case{"weights_word", "1 viscosity correct weights plain",
             "unknown viscosity correct weights 'plain': expected conservative, shepard or safe"},
        Case{"alpha_missing", "1 viscosity correct alpha 1",
             "keyword viscosity correct alpha needs a2"},
        Case{"alpha_negative", "1 viscosity correct alpha -1 1",
             "a1 of viscosity correct alpha is -1: expected a number >= 0"},
        Case{"heating_missing", "1 viscosity correct heating",
             "keyword viscosity correct heating needs compatible or printed"},
        Case{"heating_word", "1 viscosity correct heating none",
             "unknown viscosity correct heating 'none': expected compatible or printed"},
        Case{"correct_keyword", "1 viscosity correct beta 1",
             "unknown keyword 'beta': expected viscosity, gradient, tensile, frame, hourglass, "
             "distortion, energy or precision"},
        Case{"gradient_missing", "1 gradient", "keyword gradient needs plain or corrected"},
        Case{"gradient_word", "1 gradient exact",
             "unknown gradient 'exact': expected plain or corrected"},
        Case{"energy_missing", "1 energy", "keyword energy needs yes or no"},
        Case{"energy_word", "1 energy off", "unknown energy 'off': expected yes or no"},
        Case{"tensile_missing", "1 tensile", "keyword tensile needs none or artificial"},
        Case{"tensile_word", "1 tensile some",
             "unknown tensile 'some': expected none or artificial"},
        Case{"eps_missing", "1 tensile artificial", "keyword tensile artificial needs eps"},
        Case{"n_missing", "1 tensile artificial 0.3", "keyword tensile artificial needs n"},
        Case{"eps_negative", "1 tensile artificial -0.3 4",
             "eps of tensile artificial is -0.3: expected a number >= 0"},
        Case{"n_zero", "1 tensile artificial 0.3 0",
             "n of tensile artificial is 0: expected a number > 0"},
        Case{"frame_missing", "1 frame", "keyword frame needs eulerian or lagrangian"},
        Case{"frame_word", "1 frame other",
             "unknown frame 'other': expected eulerian or lagrangian"},
        Case{"limited_a2", "1 viscosity limited 1", "keyword viscosity limited needs a2"},
        Case{"balsara_a1", "1 viscosity balsara", "keyword viscosity balsara needs a1"},
        Case{"balsara_negative", "1 viscosity balsara 1 -1",
             "a2 of viscosity balsara is -1: expected a number >= 0"},
        Case{"front_alpha", "1 viscosity front alpha 1", "keyword viscosity front alpha needs a2"},
        Case{"front_keyword", "1 viscosity front 1",
             "unknown keyword '1': expected viscosity, gradient, tensile, frame, hourglass, "
             "distortion, energy or precision"},
        Case{"safe_printed", "1 viscosity correct weights safe heating printed",
             "heating printed needs weights conservative or shepard: weights safe heats "
             "compatibly"},
        Case{"hourglass_eulerian", "1 hourglass 0.1 frame eulerian",
             "hourglass 0.1 needs frame lagrangian: expected 0 in frame eulerian"},
        Case{"plain_lagrangian", "1 gradient plain",
             "gradient plain needs frame eulerian: the lagrangian frame always corrects its "
             "gradients"},
        Case{"tensile_lagrangian", "1 tensile artificial 0.3 4",
             "tensile artificial needs frame eulerian: the lagrangian frame has no tensile "
             "instability"},
        Case{"distortion_missing", "1 distortion",
             "keyword distortion needs error, warn or ignore"},
        Case{"distortion_word", "1 distortion stop",
             "unknown distortion 'stop': expected error, warn or ignore"},
        Case{"hourglass_missing", "1 hourglass", "keyword hourglass needs c"},
        Case{"hourglass_word", "1 hourglass x", "c of hourglass is 'x': expected a number >= 0"},
        Case{"hourglass_negative", "1 hourglass -1",
             "c of hourglass is -1: expected a number >= 0"}),
    name_of);

// the mark below the echoed line stands under the word that is wrong

// of repeated keywords the last one counts, with nothing left of those before

TEST(PairStyleRepeats, NoCoefficientsOfAnotherViscosity)
{
  auto state = [](const std::string &options) {
    Session s;
    s(small(options).script());
    s("run 5");
    return s.state();
  };
  expect_bitwise(state("viscosity correct"), state("viscosity monaghan 0.3 0.2 viscosity correct"));
  expect_bitwise(state("viscosity front"),
                 state("viscosity correct hbar 2 alpha 3 3 viscosity front"));
  Session s;
  s(small("viscosity correct heating printed viscosity correct weights safe").script());
  s("run 1");
}

TEST(PairStyleMessage, PointsAtTheWord)
{
  Session s;
  s(small("").particles());
  std::istringstream message(s.error("pair_style sph/solid 1 viscosity monaghan 1 two"));
  std::string first, line, mark;
  std::getline(message, first);
  std::getline(message, line);
  std::getline(message, mark);
  const auto word = line.find("two");
  ASSERT_NE(word, std::string::npos) << line;
  EXPECT_EQ(mark.find('^'), word) << line << "\n" << mark;
}

}    // namespace
