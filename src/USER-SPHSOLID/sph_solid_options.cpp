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
  o.viscosity = Viscosity::CORRECT;
  for (bool more = true; more;) {
    const std::string key = r.peek();
    if (key == "hbar") {
      r.word(key, "");
      o.hbar = r.number("viscosity correct hbar", "support in spacings", 0.0, true);
    } else if (key == "weights") {
      r.word(key, "");
      const std::string w = r.word("viscosity correct weights", "conservative, shepard or safe");
      if (w == "conservative")
        o.weights = Weights::CONSERVATIVE;
      else if (w == "shepard")
        o.weights = Weights::SHEPARD;
      else if (w == "safe")
        o.weights = Weights::SAFE;
      else
        r.unknown("viscosity correct weights", w, "conservative, shepard or safe");
    } else if (key == "alpha") {
      r.word(key, "");
      parse_alpha(o, r, "viscosity correct alpha");
    } else if (key == "heating") {
      r.word(key, "");
      const std::string w = r.word("viscosity correct heating", "compatible or printed");
      if (w == "compatible")
        o.heating = Heating::COMPATIBLE;
      else if (w == "printed")
        o.heating = Heating::PRINTED;
      else
        r.unknown("viscosity correct heating", w, "compatible or printed");
    } else
      more = false;
  }
}

const char VISCOSITIES[] = "none, monaghan, correct, limited, balsara or front";

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
  const std::string form = r.word("viscosity", VISCOSITIES);
  forget_viscosity(o);
  if (form == "none")
    o.viscosity = Viscosity::NONE;
  else if (form == "monaghan") {
    o.viscosity = Viscosity::MONAGHAN;
    parse_alpha(o, r, "viscosity monaghan");
  } else if (form == "correct")
    parse_correct(o, r);
  else if (form == "limited") {
    o.viscosity = Viscosity::LIMITED;
    parse_alpha(o, r, "viscosity limited");
  } else if (form == "balsara") {
    o.viscosity = Viscosity::BALSARA;
    parse_alpha(o, r, "viscosity balsara");
  } else if (form == "front") {
    o.viscosity = Viscosity::FRONT;
    if (r.peek() == "alpha") {
      r.word("alpha", "");
      parse_alpha(o, r, "viscosity front alpha");
    }
  } else
    r.unknown("viscosity", form, VISCOSITIES);
}

void parse_tensile(Options &o, Reader &r)
{
  const std::string form = r.word("tensile", "none or artificial");
  if (form == "artificial") {
    o.tensile = true;
    o.tensile_eps = r.number("tensile artificial", "eps", 0.0, false);
    o.tensile_n = r.number("tensile artificial", "n", 0.0, true);
  } else if (form == "none")
    o.tensile = false;
  else
    r.unknown("tensile", form, "none or artificial");
}

void parse_gradient(Options &o, Reader &r)
{
  const std::string form = r.word("gradient", "plain or corrected");
  if (form != "plain" && form != "corrected") r.unknown("gradient", form, "plain or corrected");
  o.corrected = (form == "corrected");
}

void parse_frame(Options &o, Reader &r)
{
  const std::string form = r.word("frame", "eulerian or lagrangian");
  if (form == "eulerian")
    o.frame = Frame::EULERIAN;
  else if (form == "lagrangian")
    o.frame = Frame::LAGRANGIAN;
  else
    r.unknown("frame", form, "eulerian or lagrangian");
}

void parse_distortion(Options &o, Reader &r)
{
  const std::string form = r.word("distortion", "error, warn or ignore");
  if (form == "error")
    o.distortion = Distortion::ERROR;
  else if (form == "warn")
    o.distortion = Distortion::WARN;
  else if (form == "ignore")
    o.distortion = Distortion::IGNORE;
  else
    r.unknown("distortion", form, "error, warn or ignore");
}

void parse_energy(Options &o, Reader &r)
{
  const std::string form = r.word("energy", "yes or no");
  if (form != "yes" && form != "no") r.unknown("energy", form, "yes or no");
  o.energy = (form == "yes");
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
      parse_gradient(o, r);
    else if (keyword == "tensile")
      parse_tensile(o, r);
    else if (keyword == "frame")
      parse_frame(o, r);
    else if (keyword == "hourglass")
      o.hourglass = r.number("hourglass", "c", 0.0, false);
    else if (keyword == "distortion")
      parse_distortion(o, r);
    else if (keyword == "energy")
      parse_energy(o, r);
    else
      r.unknown("keyword", keyword,
                "viscosity, gradient, tensile, frame, hourglass, distortion or energy");
  }
  if (o.hourglass == UNSET) o.hourglass = o.frame == Frame::LAGRANGIAN ? HOURGLASS_DEFAULT : 0.0;
  require_frame(lmp, o);
  if (o.weights == Weights::SAFE && o.heating == Heating::PRINTED)
    lmp->error->all(FLERR,
                    "pair_style sph/solid: heating printed needs weights conservative or shepard: "
                    "weights safe heats compatibly");
  return o;
}
