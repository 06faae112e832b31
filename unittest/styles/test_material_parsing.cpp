/* ----------------------------------------------------------------------
   pair_coeff of sph/solid: keywords, cards, and the message for every error.
------------------------------------------------------------------------- */

#include "answers.h"

using namespace sphsolid_test;

namespace {

// the answer to one pair_coeff command

std::string pair_coeff(const std::string &arguments)
{
  Session s;
  s(Block().particles());
  s("pair_style sph/solid 1.3e-3");
  return s.error("pair_coeff " + arguments);
}

const std::string REST = " eos linear 170e9 shear 80e9 strength elastic";

/* ---------------------------------------------------------------------- */

class InlineMaterial : public testing::TestWithParam<Case> {};

TEST_P(InlineMaterial, IsAccepted)
{
  Block b;
  b.nx = b.ny = 4;
  b.material = "inline " + GetParam().input + "\n";
  Session s;
  s(b.script());
  s("run 2");
  EXPECT_THAT(s.log(), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Keyword, InlineMaterial,
    testing::Values(
        Case{"elastic", "rho0 7850" + REST, "strength elastic"},
        Case{"perfect", "rho0 7850 eos linear 170e9 shear 80e9 strength perfect 6e8",
             "strength perfect Y 6e+08"},
        Case{"linear", "rho0 7850 eos linear 170e9 shear 80e9 strength linear 6e8 1e9",
             "strength linear Y 6e+08 H 1e+09"},
        Case{"eos_linear", "rho0 7850" + REST, "eos linear K 1.7e+11"},
        Case{"eos_mie_gruneisen",
             "rho0 7850 shear 80e9 strength elastic eos mie-gruneisen 4650 1.5 1.7",
             "eos mie-gruneisen C 4650 S 1.5 Gamma 1.7"},
        Case{"gamma_zero", "rho0 7850 shear 80e9 strength elastic eos mie-gruneisen 4650 1 0",
             "eos mie-gruneisen C 4650 S 1 Gamma 0"},
        Case{"h_of_type", "rho0 7850 h 1.5e-3" + REST, "h 0.0015  spacing 0.001  h/spacing 1.5000"},
        // K = 170, mu = 80 GPa: E = 9 K mu/(3 K + mu), nu = (3K-2mu)/(6K+2mu), c_L^2 = (K+4mu/3)/rho
        Case{"what_follows", "rho0 7850" + REST,
             "effective K 1.7e+11  E 2.07458e+11  nu 0.2966  c 4653.61  c_L 5936.68"},
        Case{"last_word_counts", "rho0 1 rho0 7850" + REST, "rho0 7850"}),
    name_of);

// of repeated keywords the last one counts: Gamma of the first is gone, and no energy is needed

TEST(InlineMaterial, SecondEquationOfStateReplacesTheFirst)
{
  Block b;
  b.nx = b.ny = 4;
  b.options = "energy no";
  b.material = "inline rho0 7850 eos mie-gruneisen 3600 1.8 1.8" + REST + "\n";
  Session s;
  s(b.script());
  s("run 2");
  EXPECT_THAT(s.log(), HasSubstr("eos linear K 1.7e+11"));
}

TEST(InlineMaterial, YoungFarFromTheEquationOfStateWarns)
{
  // K of young and shear: E mu/(3 (3 mu - E)) = 173.3 GPa, of the card: 101.7 GPa
  Session s;
  s(Block().particles());
  s("pair_style sph/solid 1.3e-3\npair_coeff * * inline rho0 7850 eos mie-gruneisen 3600 1.8 1.8 "
    "shear 80e9 young 208e9 strength perfect 600e6\nfix 1 all sph/solid\nrun 0");
  EXPECT_THAT(s.log(),
              HasSubstr("has bulk modulus 1.017e+11, but young 2.08e+11 and shear 8e+10 "
                        "belong to 1.733e+11"));
}

TEST(InlineMaterial, YoungThatFitsIsSilent)
{
  Session s;
  s(Block().particles());
  s("pair_style sph/solid 1.3e-3\npair_coeff * * inline rho0 7850 young 207.458e9" + REST +
    "\nfix 1 all sph/solid\nrun 0");
  EXPECT_THAT(s.log(), Not(HasSubstr("WARNING")));
}

/* ---------------------------------------------------------------------- */

class PairCoeffRefuses : public testing::TestWithParam<Case> {};

TEST_P(PairCoeffRefuses, WithMessage)
{
  EXPECT_THAT(pair_coeff(GetParam().input), HasSubstr(GetParam().message + " ("));
}

INSTANTIATE_TEST_SUITE_P(
    Wrong, PairCoeffRefuses,
    testing::Values(
        Case{"nothing", "* *",
             "pair_coeff sph/solid: expected I J <file> <material> [keyword values] or I J inline "
             "<keyword values>"},
        Case{"keyword", "* * inline rho 7850",
             "pair_coeff * * sph/solid: unknown keyword 'rho': expected rho0, eos, shear, young, "
             "strength or h"},
        Case{"rho0_missing_value", "* * inline rho0",
             "pair_coeff * * sph/solid: expected the value of keyword rho0 after 'rho0', found the "
             "end of the input"},
        Case{"rho0_word", "* * inline rho0 heavy",
             "pair_coeff * * sph/solid: the value of keyword rho0 is 'heavy': expected a number"},
        Case{"rho0_too_large", "* * inline rho0 1e400",
             "pair_coeff * * sph/solid: the value of keyword rho0 is '1e400': expected a number"},
        Case{"shear_too_small", "* * inline shear 1e-400",
             "the value of keyword shear is '1e-400': expected a number"},
        Case{"bulk_modulus_infinite",
             "* * inline rho0 1 eos mie-gruneisen 1e300 1 1 shear 1 strength elastic",
             "the bulk modulus is inf: expected a material whose constants are finite"},
        Case{"bulk_modulus_zero",
             "* * inline rho0 1 eos mie-gruneisen 1e-300 1 1 shear 1 strength elastic",
             "the bulk modulus is 0: expected a value > 0"},
        Case{"shock_line_infinite",
             "* * inline rho0 1 eos mie-gruneisen 1 1e200 1 shear 1 strength elastic",
             "the stiffness of the shock line is inf: expected a material whose constants are "
             "finite"},
        Case{"young_infinite", "* * inline rho0 1 eos linear 1e200 shear 1e200 strength elastic",
             "the Young's modulus is inf: expected a material whose constants are finite"},
        Case{"rho0_missing", "* * inline" + REST,
             "pair_coeff * * sph/solid: density rho0 is 0: expected a value > 0"},
        Case{"rho0_negative", "* * inline rho0 -1" + REST,
             "pair_coeff * * sph/solid: density rho0 is -1: expected a value > 0"},
        Case{"shear_word", "* * inline shear stiff",
             "the value of keyword shear is 'stiff': expected "
             "a number"},
        Case{"shear_missing", "* * inline rho0 1 eos linear 1 strength elastic",
             "shear modulus shear is 0: expected a value > 0"},
        Case{"young_zero", "* * inline young 0", "young is 0: expected a value > 0"},
        Case{"young_impossible", "* * inline rho0 1 young 240e9" + REST,
             "young is 240000000000: expected less than 3 times the shear modulus 80000000000"},
        Case{"h_negative", "* * inline h -1", "h is -1: expected a value > 0"},
        Case{"eos_missing", "* * inline rho0 1 shear 1 strength elastic",
             "keyword eos is missing: expected eos mie-gruneisen C S Gamma or eos linear K"},
        Case{"eos_end", "* * inline eos",
             "expected mie-gruneisen or linear after 'eos', found the end of the input"},
        Case{"eos_word", "* * inline eos tillotson",
             "unknown eos 'tillotson': expected mie-gruneisen or linear"},
        Case{"gruneisen_short", "* * inline eos mie-gruneisen 1 2",
             "expected Gamma of keyword eos mie-gruneisen after '2', found the end of the input"},
        Case{"gruneisen_word", "* * inline eos mie-gruneisen 1 two 3",
             "S of keyword eos mie-gruneisen is 'two': expected a number"},
        Case{"c_zero", "* * inline rho0 1 eos mie-gruneisen 0 1 1 shear 1 strength elastic",
             "sound speed C is 0: expected a value > 0"},
        Case{"s_negative", "* * inline rho0 1 eos mie-gruneisen 1 -0.1 1 shear 1 strength elastic",
             "slope S of the shock line is -0.1: expected a value >= 0"},
        Case{"gamma_negative",
             "* * inline rho0 1 eos mie-gruneisen 1 1 -1 shear 1 strength elastic",
             "Gamma is -1: expected a value >= 0"},
        Case{"k_zero", "* * inline rho0 1 eos linear 0 shear 1 strength elastic",
             "bulk modulus K is 0: expected a value > 0"},
        Case{"strength_missing", "* * inline rho0 1 eos linear 1 shear 1",
             "keyword strength is missing: expected strength elastic, perfect Y or linear Y H"},
        Case{"strength_end", "* * inline strength",
             "expected elastic, perfect or linear after 'strength', found the end of the input"},
        Case{"strength_word", "* * inline strength brittle",
             "unknown strength 'brittle': expected elastic, perfect or linear"},
        Case{"perfect_short", "* * inline strength perfect",
             "expected Y of keyword strength perfect after 'perfect', found the end of the input"},
        Case{"linear_short", "* * inline strength linear 1",
             "expected H of keyword strength linear after '1', found the end of the input"},
        Case{"y_zero", "* * inline rho0 1 eos linear 1 shear 1 strength perfect 0",
             "yield stress Y is 0: expected a value > 0"},
        Case{"h_softening", "* * inline rho0 1 eos linear 1 shear 1 strength linear 1 -1",
             "hardening modulus H is -1: expected a value >= 0"},
        Case{"card_without_material", "* * metals.sphsolid",
             "pair_coeff * * sph/solid: card 'metals.sphsolid' needs the name of a material after "
             "it"},
        Case{"card_missing", "* * nowhere.sphsolid iron",
             "pair_coeff sph/solid: cannot open material card 'nowhere.sphsolid': expected a file "
             "here or in a folder of LAMMPS_POTENTIALS"},
        Case{"override_keyword", "* * metals.sphsolid iron-taylor yield 1",
             "pair_coeff * * sph/solid: unknown keyword 'yield': expected rho0, eos, shear, young, "
             "strength or h"}),
    name_of);

TEST(PairCoeff, MaterialBetweenTwoTypesIsRefused)
{
  Session s;
  s("units si\ndimension 2\nboundary f f p\natom_style sph/solid\n"
    "region box block 0 1 0 1 -0.5 0.5\ncreate_box 2 box\npair_style sph/solid 1");
  EXPECT_THAT(
      s.error("pair_coeff 1 2 inline rho0 1" + REST),
      HasSubstr("pair_coeff 1 2 sph/solid: a material belongs to one type: expected I = J or "
                "ranges with common types"));
}

/* ----------------------------------------------------------------------
   cards
------------------------------------------------------------------------- */

const std::string CARD_HEAD = "# UNITS: si DATE: 2020-01-01 CONTRIBUTOR: nobody\n";
const std::string CARD = "# a comment\nmaterial one\n  rho0 7850  # another\n  eos linear 170e9\n"
                         "  shear 80e9\n  strength elastic\n\nmaterial two\n  rho0 1\n";

TEST(Card, IsFoundThroughLammpsPotentials)
{
  EXPECT_EQ(pair_coeff("* * metals.sphsolid iron-taylor"), "");
}

TEST(Card, CommentsAndLineBreaksDoNotMatter)
{
  EXPECT_EQ(pair_coeff("* * " + write_file("card", CARD_HEAD + CARD) + " one"), "");
}

TEST(Card, LinesMayBeLong)
{
  const std::string one_line = "material one\n rho0 7850 eos linear " + std::string(2000, ' ') +
      "1.7e11 shear 80e9 strength elastic " + std::string(2000, ' ') + "h -1\n";
  EXPECT_THAT(pair_coeff("* * " + write_file("card", CARD_HEAD + one_line) + " one"),
              testing::ContainsRegex("h is -1"));
}

TEST(Card, EveryMaterialOfThePackageIsComplete)
{
  std::istringstream in(read_file(SPHSOLID_TEST_ROOT "/potentials/metals.sphsolid"));
  std::string line, word, name;
  int count = 0;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    words >> word >> name;
    if (line.rfind("material", 0) != 0) continue;
    EXPECT_EQ(pair_coeff("* * metals.sphsolid " + name), "") << name;
    count++;
  }
  EXPECT_GT(count, 3);
}

TEST(Card, UnknownMaterialListsThoseThere)
{
  EXPECT_THAT(pair_coeff("* * " + write_file("card", CARD_HEAD + CARD) + " three"),
              HasSubstr("has no material 'three': it holds one two ("));
}

TEST(Card, IncompleteMaterialIsRefused)
{
  EXPECT_THAT(pair_coeff("* * " + write_file("card", CARD_HEAD + CARD) + " two"),
              HasSubstr("pair_coeff * * sph/solid: keyword eos is missing"));
}

TEST(Card, OverrideCompletesAMaterial)
{
  EXPECT_EQ(pair_coeff("* * " + write_file("card", CARD_HEAD + CARD) +
                       " two eos linear 1 shear 1 strength elastic"),
            "");
}

TEST(Card, OverrideWinsOverTheCard)
{
  Session s;
  s(Block().particles());
  s("pair_style sph/solid 1.3e-3\npair_coeff * * metals.sphsolid iron-taylor strength perfect 5e8\n"
    "fix 1 all sph/solid\nrun 0");
  EXPECT_THAT(s.log(), HasSubstr("strength perfect Y 5e+08"));
}

TEST(Card, WithoutUnitsIsRefused)
{
  EXPECT_THAT(pair_coeff("* * " + write_file("card", CARD) + " one"),
              HasSubstr("does not state its units: expected '# UNITS: si ...' in its first line"));
}

TEST(Card, MaterialLineWithoutNameIsRefused)
{
  EXPECT_THAT(pair_coeff("* * " + write_file("card", CARD_HEAD + "material\n rho0 1\n") + " one"),
              HasSubstr("expected 'material NAME', found 'material'"));
}

TEST(Card, KeywordsBeforeTheFirstMaterialAreRefused)
{
  const std::string path = write_file("card", CARD_HEAD + "\nrho0 1 # lost\n" + CARD);
  EXPECT_THAT(
      pair_coeff("* * " + path + " one"),
      HasSubstr("card '" + path + "', line 3: 'rho0' stands before the first 'material NAME' ("));
}

TEST(Card, SecondMaterialOfOneNameIsRefused)
{
  const std::string path =
      write_file("card", CARD_HEAD + CARD + "material one\n strength perfect 1\n");
  for (const std::string name : {"one", "two"})
    EXPECT_THAT(pair_coeff("* * " + path + " " + name),
                HasSubstr("card '" + path +
                          "', line 11: a second material 'one', the first is in line 3: expected "
                          "each name once ("));
}

TEST(Card, NumberOutOfRangeIsRefused)
{
  const std::string path = write_file("card", CARD_HEAD + "material one\n rho0 1e400\n");
  EXPECT_THAT(pair_coeff("* * " + path + " one"),
              HasSubstr("card '" + path +
                        "': the value of keyword rho0 is '1e400': expected a "
                        "number ("));
}

TEST(Card, ErrorInsideNamesTheCard)
{
  const std::string path = write_file("card", CARD_HEAD + "material one\n rho0 much\n");
  EXPECT_THAT(pair_coeff("* * " + path + " one"),
              HasSubstr("card '" + path + "': the value of keyword rho0 is 'much'"));
}

TEST(Card, CannotBeConvertedToLj)
{
  Session s;
  s("units lj\ndimension 2\nboundary f f p\natom_style sph/solid\n"
    "region box block 0 1 0 1 -0.5 0.5\ncreate_box 1 box\npair_style sph/solid 1");
  EXPECT_THAT(s.error("pair_coeff * * metals.sphsolid iron-taylor"),
              HasSubstr("the material card is in units 'si' and cannot be converted to 'lj'"));
  EXPECT_EQ(s.error("pair_coeff * * inline rho0 1 eos linear 1 shear 1 strength elastic"), "");
}

TEST(Card, InUnknownUnitsIsRefused)
{
  EXPECT_THAT(
      pair_coeff("* * " + write_file("card", "# UNITS: real\n" + CARD) + " one"),
      HasSubstr("in units 'real' and cannot be converted to 'si': expected si, cgs, micro or "
                "nano on both sides"));
}

// lj to lj needs no conversion

TEST(Card, InLjUnitsWorksInLj)
{
  Session s;
  s("units lj\ndimension 2\nboundary f f p\natom_style sph/solid\n"
    "region box block 0 1 0 1 -0.5 0.5\ncreate_box 1 box\npair_style sph/solid 1");
  const std::string card =
      "# UNITS: lj\nmaterial m\n rho0 1\n eos linear 1\n shear 1\n strength elastic\n";
  EXPECT_EQ(s.error("pair_coeff * * " + write_file("card", card) + " m"), "");
}

/* ----------------------------------------------------------------------
   one rod in all unit styles: the same trajectory, scaled
------------------------------------------------------------------------- */

struct Units {
  std::string name;
  double mass, length;    // kilogram and metre in these units
  double time;            // second
};

class CardUnits : public testing::TestWithParam<Units> {
 public:
  static State run(const Units &u, const std::string &card)
  {
    Session s;
    s("variable L equal " + num(u.length) + "\nvariable T equal " + num(u.time) + "\nunits " +
      u.name);
    s("dimension 2\nboundary f f p\natom_style sph/solid\natom_modify map array\n"
      "variable big equal 0.05*v_L\nvariable z equal 0.0005*v_L\n"
      "region box block -${big} ${big} -${big} ${big} -${z} ${z}\ncreate_box 1 box\n"
      "variable d equal 0.001*v_L\nlattice custom 1.0 a1 $d 0 0 a2 0 $d 0 a3 0 0 $d basis 0 0 0\n"
      "region rod block -0.1 7.1 -0.1 11.1 -0.1 0.1\ncreate_atoms 1 region rod\n"
      "variable a equal v_d*v_d\nset group all volume $a\n"
      "variable h equal 1.3*v_d\npair_style sph/solid $h\n"
      "pair_coeff * * " +
      card +
      " iron-taylor\n"
      "variable skin equal 0.3*v_d\nneighbor ${skin} bin\n"
      "variable speed equal -200*v_L/v_T\nvelocity all set 0 ${speed} 0 units box\n"
      "fix move all sph/solid\nfix step all sph/solid/dt 1 0.3\n"
      "fix floor all sph/solid/wall ylo 0\nrun 150\n");
    State st = s.state();
    const double V = u.length / u.time, P = u.mass / (u.length * u.time * u.time);
    for (Particle &p : st) {
      for (double &c : p.x) c /= u.length;
      for (double &c : p.v) c /= V;
      for (double &c : p.f) c /= u.mass / u.length * V / u.time;    // per unit width
      for (double &c : p.stress) c /= P;
      p.rho /= u.mass / std::pow(u.length, 3);
      p.mass /= u.mass / u.length;
      p.e /= V * V;
    }
    return st;
  }
};

TEST_P(CardUnits, TrajectoryIsTheSame)
{
  const State si = run({"si", 1.0, 1.0, 1.0}, "metals.sphsolid");
  const State other = run(GetParam(), "metals.sphsolid");
  EXPECT_LT(largest_difference(si, other), 1.0e-9);
}

TEST_P(CardUnits, CardInTheseUnitsIsReadInSi)
{
  const Units &u = GetParam();
  const double P = u.mass / (u.length * u.time * u.time);
  const std::string card = "# UNITS: " + u.name + "\nmaterial iron-taylor\n rho0 " +
      num(7850.0 * u.mass / std::pow(u.length, 3)) + "\n eos mie-gruneisen " +
      num(3600.0 * u.length / u.time) + " 1.8 1.8\n shear " + num(80.0e9 * P) +
      "\n strength perfect " + num(600.0e6 * P) + "\n";
  const Units si = {"si", 1.0, 1.0, 1.0};
  EXPECT_LT(largest_difference(run(si, "metals.sphsolid"), run(si, write_file("card", card))),
            1.0e-9);
}

INSTANTIATE_TEST_SUITE_P(Card, CardUnits,
                         testing::Values(Units{"cgs", 1.0e3, 1.0e2, 1.0},
                                         Units{"micro", 1.0e15, 1.0e6, 1.0e6},
                                         Units{"nano", 1.0e21, 1.0e9, 1.0e9}),
                         [](const auto &info) {
                           return info.param.name;
                         });

}    // namespace
