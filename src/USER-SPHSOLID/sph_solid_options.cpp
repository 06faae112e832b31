/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

/* ----------------------------------------------------------------------
   Arguments of the pair_style command: reading and checking.
------------------------------------------------------------------------- */

#include "sph_solid_options.h"

#include "error.h"
#include "sph_solid_number.h"

#include <string>
#include <utility>
#include <vector>

using namespace LAMMPS_NS;
using namespace SPHSolid;

namespace {

constexpr double UNSET = -1.0, HOURGLASS_DEFAULT = 0.03;

// walks through the arguments; index errors point at the word in the line

class Reader {
 public:
  Reader(LAMMPS *l, int n, char **a) : lmp(l), narg(n), arg(a) {}

  bool more() const { return at < narg; }
  std::string peek() const { return more() ? arg[at] : ""; }
  // is this the next word?  Then it is done with
  bool takes(const char *word)
  {
    const bool is = peek() == word;
    if (is) at++;
    return is;
  }

  std::string word(const std::string &keyword, const std::string &expected)
  {
    if (!more())
      lmp->error->all(FLERR, "pair_style sph/solid: keyword {} needs {}", keyword, expected);
    return arg[at++];
  }

  double number(const std::string &keyword, const std::string &what, double least, bool open)
  {
    const std::string text = word(keyword, what);
    const std::string bound = open ? "> " : ">= ";
    const auto value = number_of(text);
    if (!value)
      lmp->error->all(FLERR, at, "pair_style sph/solid: {} of {} is '{}': expected a number {}{}",
                      what, keyword, text, bound, least);
    if (!(open ? *value > least : *value >= least))
      lmp->error->all(FLERR, at, "pair_style sph/solid: {} of {} is {}: expected a number {}{}",
                      what, keyword, *value, bound, least);
    return *value;
  }

  // one of some words, which stand for values
  template <class Value> using Choices = std::vector<std::pair<const char *, Value>>;
  template <class Value> Value choose(const std::string &keyword, const Choices<Value> &choices)
  {
    std::string expected = choices.front().first;
    for (std::size_t k = 1; k < choices.size(); k++)
      expected += (k + 1 < choices.size() ? ", " : " or ") + std::string(choices[k].first);
    const std::string text = word(keyword, expected);
    for (const auto &choice : choices)
      if (text == choice.first) return choice.second;
    unknown(keyword, text, expected);
  }

  [[noreturn]] void unknown(const std::string &keyword, const std::string &value,
                            const std::string &expected)
  {
    lmp->error->all(FLERR, at, "pair_style sph/solid: unknown {} '{}': expected {}", keyword, value,
                    expected);
  }

 private:
  LAMMPS *lmp;
  int narg, at = 0;
  char **arg;
};

void parse_alpha(Options &o, Reader &r, const std::string &keyword)
{
  o.a1 = r.number(keyword, "a1", 0.0, false);
  o.a2 = r.number(keyword, "a2", 0.0, false);
}

void parse_correct(Options &o, Reader &r)
{
  for (bool more = true; more;) {
    if (r.takes("hbar"))
      o.hbar = r.number("viscosity correct hbar", "support in spacings", 0.0, true);
    else if (r.takes("weights"))
      o.weights = r.choose<Weights>("viscosity correct weights",
                                    {{"conservative", Weights::CONSERVATIVE},
                                     {"shepard", Weights::SHEPARD},
                                     {"safe", Weights::SAFE}});
    else if (r.takes("alpha"))
      parse_alpha(o, r, "viscosity correct alpha");
    else if (r.takes("heating"))
      o.heating =
          r.choose<Heating>("viscosity correct heating",
                            {{"compatible", Heating::COMPATIBLE}, {"printed", Heating::PRINTED}});
    else
      more = false;
  }
}

// the last of several keywords counts, with nothing left of those before

void forget_viscosity(Options &o)
{
  const Options usual;
  o.a1 = usual.a1;
  o.a2 = usual.a2;
  o.hbar = usual.hbar;
  o.weights = usual.weights;
  o.heating = usual.heating;
}

void parse_viscosity(Options &o, Reader &r)
{
  forget_viscosity(o);
  const std::string form = r.peek();
  o.viscosity = r.choose<Viscosity>("viscosity",
                                    {{"none", Viscosity::NONE},
                                     {"monaghan", Viscosity::MONAGHAN},
                                     {"correct", Viscosity::CORRECT},
                                     {"limited", Viscosity::LIMITED},
                                     {"balsara", Viscosity::BALSARA},
                                     {"front", Viscosity::FRONT}});
  switch (o.viscosity) {
    case Viscosity::NONE:
      break;
    case Viscosity::CORRECT:
      parse_correct(o, r);
      break;
    case Viscosity::FRONT:
      if (r.takes("alpha")) parse_alpha(o, r, "viscosity front alpha");
      break;
    default:
      parse_alpha(o, r, "viscosity " + form);
  }
}

void parse_tensile(Options &o, Reader &r)
{
  o.tensile = r.choose<bool>("tensile", {{"none", false}, {"artificial", true}});
  if (!o.tensile) return;
  o.tensile_eps = r.number("tensile artificial", "eps", 0.0, false);
  o.tensile_n = r.number("tensile artificial", "n", 0.0, true);
}

// what only one of the two frames has

void require_frame(LAMMPS *lmp, const Options &o)
{
  const bool lagrangian = o.frame == Frame::LAGRANGIAN;
  if (lagrangian && !o.corrected)
    lmp->error->all(FLERR,
                    "pair_style sph/solid: gradient plain needs frame eulerian: the "
                    "lagrangian frame always corrects its gradients");
  if (lagrangian && o.tensile)
    lmp->error->all(FLERR,
                    "pair_style sph/solid: tensile artificial needs frame eulerian: the "
                    "lagrangian frame has no tensile instability");
  if (!lagrangian && o.hourglass > 0.0)
    lmp->error->all(FLERR,
                    "pair_style sph/solid: hourglass {} needs frame lagrangian: expected 0 in "
                    "frame eulerian",
                    o.hourglass);
}

}    // namespace

/* ---------------------------------------------------------------------- */

Options SPHSolid::parse_options(LAMMPS *lmp, int narg, char **arg)
{
  if (narg < 1)
    lmp->error->all(FLERR, "pair_style sph/solid: expected the smoothing length h, a number > 0");
  Options o;
  o.hourglass = UNSET;
  Reader r(lmp, narg, arg);
  o.h = r.number("pair_style", "smoothing length h", 0.0, true);
  while (r.more()) {
    const std::string keyword = r.word("", "");
    if (keyword == "viscosity")
      parse_viscosity(o, r);
    else if (keyword == "gradient")
      o.corrected = r.choose<bool>(keyword, {{"plain", false}, {"corrected", true}});
    else if (keyword == "tensile")
      parse_tensile(o, r);
    else if (keyword == "frame")
      o.frame = r.choose<Frame>(keyword,
                                {{"eulerian", Frame::EULERIAN}, {"lagrangian", Frame::LAGRANGIAN}});
    else if (keyword == "hourglass")
      o.hourglass = r.number("hourglass", "c", 0.0, false);
    else if (keyword == "distortion")
      o.distortion = r.choose<Distortion>(keyword,
                                          {{"error", Distortion::ERROR},
                                           {"warn", Distortion::WARN},
                                           {"ignore", Distortion::IGNORE}});
    else if (keyword == "energy")
      o.energy = r.choose<bool>(keyword, {{"yes", true}, {"no", false}});
    else if (keyword == "precision")
      o.mixed = r.choose<bool>(keyword, {{"double", false}, {"mixed", true}});
    else
      r.unknown("keyword", keyword,
                "viscosity, gradient, tensile, frame, hourglass, distortion, energy or precision");
  }
  if (o.hourglass == UNSET) o.hourglass = o.frame == Frame::LAGRANGIAN ? HOURGLASS_DEFAULT : 0.0;
  require_frame(lmp, o);
  if (o.weights == Weights::SAFE && o.heating == Heating::PRINTED)
    lmp->error->all(FLERR,
                    "pair_style sph/solid: heating printed needs weights conservative or shepard: "
                    "weights safe heats compatibly");
  return o;
}
