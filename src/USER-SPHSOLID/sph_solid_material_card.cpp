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
   Material cards and the keywords of pair_coeff: reading and checking.
------------------------------------------------------------------------- */

#include "sph_solid_material_card.h"

#include "comm.h"
#include "error.h"
#include "sph_solid_eos.h"
#include "sph_solid_number.h"
#include "update.h"
#include "utils.h"

#include <cmath>
#include <fstream>
#include <map>

using namespace LAMMPS_NS;
using namespace SPHSolid;

namespace {

// kilogram, metre and second in the unit styles with a consistent set of
// mechanical units (pressure = mass/(length time^2)); lj has no scale

struct UnitScale {
  double mass, length, time;
};

const std::map<std::string, UnitScale> UNIT_SCALES = {{"si", {1.0, 1.0, 1.0}},
                                                      {"cgs", {1.0e-3, 1.0e-2, 1.0}},
                                                      {"micro", {1.0e-15, 1.0e-6, 1.0e-6}},
                                                      {"nano", {1.0e-21, 1.0e-9, 1.0e-9}}};

class Converter {
 public:
  Converter(LAMMPS *lmp, const std::string &from, const std::string &where)
  {
    const std::string to = lmp->update->unit_style;
    if (from == to) return;
    const auto a = UNIT_SCALES.find(from), b = UNIT_SCALES.find(to);
    if (a == UNIT_SCALES.end() || b == UNIT_SCALES.end())
      lmp->error->all(FLERR,
                      "{}: the material card is in units '{}' and cannot be converted to '{}': "
                      "expected si, cgs, micro or nano on both sides, or the same units",
                      where, from, to);
    mass = a->second.mass / b->second.mass;
    length = a->second.length / b->second.length;
    time = a->second.time / b->second.time;
  }
  double density() const { return mass / (length * length * length); }
  double velocity() const { return length / time; }
  double pressure() const { return mass / (length * time * time); }
  double distance() const { return length; }

 private:
  double mass = 1.0, length = 1.0, time = 1.0;
};

// reads words one by one and says what was expected where they end

class Words {
 public:
  Words(LAMMPS *l, const std::vector<std::string> &w, const std::string &where) :
      lmp(l), words(w), context(where)
  {
  }
  bool more() const { return at < words.size(); }
  const std::string &next(const std::string &expected)
  {
    if (!more())
      lmp->error->all(FLERR, "{}: expected {} after '{}', found the end of the input", context,
                      expected, words.back());
    return words[at++];
  }
  double number(const std::string &keyword, const std::string &what)
  {
    const std::string &w = next(what + " of keyword " + keyword);
    const auto value = number_of(w);
    if (!value)
      lmp->error->all(FLERR, "{}: {} of keyword {} is '{}': expected a number", context, what,
                      keyword, w);
    return *value;
  }

 private:
  LAMMPS *lmp;
  const std::vector<std::string> &words;
  const std::string &context;
  std::size_t at = 0;
};

void parse_eos(LAMMPS *lmp, Material &m, Words &words, const Converter &to,
               const std::string &where)
{
  const std::string &name = words.next("mie-gruneisen or linear");
  m.C = m.S = m.Gamma = m.K = 0.0;    // of a card that this keyword replaces
  if (name == "mie-gruneisen") {
    m.eos = EOS::MIE_GRUNEISEN;
    m.C = words.number("eos mie-gruneisen", "C") * to.velocity();
    m.S = words.number("eos mie-gruneisen", "S");
    m.Gamma = words.number("eos mie-gruneisen", "Gamma");
  } else if (name == "linear") {
    m.eos = EOS::LINEAR;
    m.K = words.number("eos linear", "K") * to.pressure();
  } else
    lmp->error->all(FLERR, "{}: unknown eos '{}': expected mie-gruneisen or linear", where, name);
}

void parse_strength(LAMMPS *lmp, Material &m, Words &words, const Converter &to,
                    const std::string &where)
{
  const std::string &name = words.next("elastic, perfect or linear");
  m.Y = m.H = 0.0;
  if (name == "elastic") {
    m.strength = Strength::ELASTIC;
  } else if (name == "perfect") {
    m.strength = Strength::PERFECT;
    m.Y = words.number("strength perfect", "Y") * to.pressure();
  } else if (name == "linear") {
    m.strength = Strength::LINEAR;
    m.Y = words.number("strength linear", "Y") * to.pressure();
    m.H = words.number("strength linear", "H") * to.pressure();
  } else if (name == "johnson-cook")
    lmp->error->all(
        FLERR, "{}: strength johnson-cook is not available yet: use elastic, perfect or linear",
        where);
  else
    lmp->error->all(FLERR, "{}: unknown strength '{}': expected elastic, perfect or linear", where,
                    name);
}

void require_positive(LAMMPS *lmp, double value, const char *keyword, const std::string &where)
{
  if (!(value > 0.0))
    lmp->error->all(FLERR, "{}: {} is {}: expected a value > 0", where, keyword, value);
}

// what follows from numbers that are possible one by one

void require_finite(LAMMPS *lmp, const Material &m, const std::string &where)
{
  const EosConstants<> k = eos_constants(m);
  const struct {
    const char *name;
    double value;
  } all[] = {{"shear modulus", m.shear},
             {"yield stress", m.Y},
             {"hardening modulus", m.H},
             {"bulk modulus", m.bulk_modulus()},
             {"stiffness of the shock line", k.a0 + k.b0 + k.c0 + k.Gamma},
             {"Young's modulus", m.youngs_modulus()},
             {"longitudinal sound speed", m.longitudinal_speed()}};
  for (const auto &constant : all)
    if (!std::isfinite(constant.value))
      lmp->error->all(FLERR, "{}: the {} is {}: expected a material whose constants are finite",
                      where, constant.name, constant.value);
  if (!(m.bulk_modulus() > 0.0 && m.bulk_sound_speed() > 0.0))
    lmp->error->all(FLERR, "{}: the bulk modulus is {}: expected a value > 0", where,
                    m.bulk_modulus());
}

// the words after "material NAME" in a card, or what is wrong with it

class Card {
 public:
  Card(const std::string &file, const std::string &name) : file(file), name(name) {}

  std::string text, problem;

  void read(const std::string &path)
  {
    std::ifstream in(path);
    if (!in) return complain(0, "cannot be opened");
    std::string line;
    for (int number = 1; problem.empty() && std::getline(in, line); number++)
      take(number, utils::split_words(utils::trim_comment(line)));
    if (problem.empty() && !seen)
      complain(0, "has no material '" + name + "': it holds" + (found.empty() ? " none" : found));
  }

 private:
  const std::string &file, &name;
  std::string found;
  std::map<std::string, int> lines;    // of the materials
  bool inside = false, seen = false;

  void take(int number, const std::vector<std::string> &words)
  {
    if (words.empty()) return;
    if (words[0] == "material") return begin(number, words);
    if (lines.empty())
      return complain(number, "'" + words[0] + "' stands before the first 'material NAME'");
    if (!inside) return;
    for (const auto &w : words) text += w + " ";
  }

  void begin(int number, const std::vector<std::string> &words)
  {
    if (words.size() != 2) {
      std::string line;
      for (const auto &w : words) line += (line.empty() ? "" : " ") + w;
      return complain(number, "expected 'material NAME', found '" + line + "'");
    }
    const auto first = lines.insert({words[1], number});
    if (!first.second)
      return complain(number,
                      "a second material '" + words[1] + "', the first is in line " +
                          std::to_string(first.first->second) + ": expected each name once");
    inside = words[1] == name;
    seen = seen || inside;
    found += " " + words[1];
  }

  void complain(int number, const std::string &what)
  {
    problem =
        "card '" + file + "'" + (number ? ", line " + std::to_string(number) + ": " : " ") + what;
  }
};

}    // namespace

/* ---------------------------------------------------------------------- */

void SPHSolid::parse_material(LAMMPS *lmp, Material &m, const std::vector<std::string> &list,
                              const std::string &units, const std::string &where)
{
  const Converter to(lmp, units, where);
  Words words(lmp, list, where);
  while (words.more()) {
    const std::string &keyword = words.next("a keyword");
    if (keyword == "rho0")
      m.rho0 = words.number("rho0", "the value") * to.density();
    else if (keyword == "shear")
      m.shear = words.number("shear", "the value") * to.pressure();
    else if (keyword == "young") {
      m.young = words.number("young", "the value") * to.pressure();
      require_positive(lmp, m.young, "young", where);
    } else if (keyword == "h") {
      m.h = words.number("h", "the value") * to.distance();
      require_positive(lmp, m.h, "h", where);
    } else if (keyword == "eos")
      parse_eos(lmp, m, words, to, where);
    else if (keyword == "strength")
      parse_strength(lmp, m, words, to, where);
    else
      lmp->error->all(FLERR,
                      "{}: unknown keyword '{}': expected rho0, eos, shear, young, strength or h",
                      where, keyword);
  }
}

/* ----------------------------------------------------------------------
   rank 0 reads, all get the words
------------------------------------------------------------------------- */

std::vector<std::string> SPHSolid::read_card(LAMMPS *lmp, const std::string &file,
                                             const std::string &name, std::string &units)
{
  Card card(file, name);
  std::string &problem = card.problem;
  if (lmp->comm->me == 0) {
    const std::string path = utils::get_potential_file_path(file);
    if (path.empty())
      problem = "cannot open material card '" + file +
          "': expected a file here or in a folder of LAMMPS_POTENTIALS";
    else {
      units = utils::get_potential_units(path, "potential");
      card.read(path);
      if (problem.empty() && units.empty())
        problem = "card '" + file +
            "' does not state its units: expected '# UNITS: si ...' in its first line";
    }
  }

  std::string message = problem + "\n" + units + "\n" + card.text;
  int length = static_cast<int>(message.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, lmp->world);
  message.resize(length);
  MPI_Bcast(&message[0], length, MPI_CHAR, 0, lmp->world);
  const auto a = message.find('\n'), b = message.find('\n', a + 1);
  if (a > 0) lmp->error->all(FLERR, "pair_coeff sph/solid: {}", message.substr(0, a));
  units = message.substr(a + 1, b - a - 1);
  return utils::split_words(message.substr(b + 1));
}

/* ---------------------------------------------------------------------- */

void SPHSolid::check_material(LAMMPS *lmp, const Material &m, const std::string &where)
{
  if (m.eos == EOS::NONE)
    lmp->error->all(FLERR,
                    "{}: keyword eos is missing: expected eos mie-gruneisen C S Gamma or "
                    "eos linear K",
                    where);
  if (m.strength == Strength::NONE)
    lmp->error->all(FLERR,
                    "{}: keyword strength is missing: expected strength elastic, perfect Y "
                    "or linear Y H",
                    where);
  require_positive(lmp, m.rho0, "density rho0", where);
  require_positive(lmp, m.shear, "shear modulus shear", where);
  if (m.eos == EOS::MIE_GRUNEISEN) {
    require_positive(lmp, m.C, "sound speed C", where);
    if (!(m.S >= 0.0))    // titanium: 0.767 (Marsh, LASL Shock Hugoniot Data, 1980)
      lmp->error->all(FLERR, "{}: slope S of the shock line is {}: expected a value >= 0", where,
                      m.S);
    if (!(m.Gamma >= 0.0))
      lmp->error->all(FLERR, "{}: Gamma is {}: expected a value >= 0", where, m.Gamma);
  } else
    require_positive(lmp, m.K, "bulk modulus K", where);
  if (m.strength != Strength::ELASTIC) require_positive(lmp, m.Y, "yield stress Y", where);
  if (m.young >= 3.0 * m.shear)
    lmp->error->all(FLERR, "{}: young is {}: expected less than 3 times the shear modulus {}",
                    where, m.young, m.shear);
  if (m.H < 0.0)
    lmp->error->all(FLERR, "{}: hardening modulus H is {}: expected a value >= 0", where, m.H);
  require_finite(lmp, m, where);
}

/* ---------------------------------------------------------------------- */

void SPHSolid::log_material(LAMMPS *lmp, int type, const Material &m, double h, double spacing)
{
  if (lmp->comm->me != 0) return;
  utils::logmesg(lmp, "sph/solid type {} ({} units)\n", type, lmp->update->unit_style);
  utils::logmesg(lmp, "  rho0 {:.8g}  shear {:.8g}", m.rho0, m.shear);
  if (m.eos == EOS::LINEAR)
    utils::logmesg(lmp, "  eos linear K {:.8g}", m.K);
  else
    utils::logmesg(lmp, "  eos mie-gruneisen C {:.8g} S {:.8g} Gamma {:.8g}", m.C, m.S, m.Gamma);
  if (m.strength == Strength::ELASTIC) utils::logmesg(lmp, "  strength elastic\n");
  if (m.strength == Strength::PERFECT) utils::logmesg(lmp, "  strength perfect Y {:.8g}\n", m.Y);
  if (m.strength == Strength::LINEAR)
    utils::logmesg(lmp, "  strength linear Y {:.8g} H {:.8g}\n", m.Y, m.H);
  utils::logmesg(lmp, "  effective K {:.6g}  E {:.6g}  nu {:.4f}  c {:.6g}  c_L {:.6g}\n",
                 m.bulk_modulus(), m.youngs_modulus(), m.poisson_ratio(), m.bulk_sound_speed(),
                 m.longitudinal_speed());
  utils::logmesg(lmp, "  h {:.6g}  spacing {:.6g}  h/spacing {:.4f}\n", h, spacing, h / spacing);

  if (h <= 0.5 * spacing)
    lmp->error->warning(FLERR,
                        "sph/solid type {}: h is {:.4g} spacings, and its kernel ends before the "
                        "nearest neighbors: expected 0.8 or more",
                        type, h / spacing);

  // Shaw and Reid's iron: C from shock data, E and mu from elastic tests
  if (m.young > 0.0) {
    const double K = m.young * m.shear / (3.0 * (3.0 * m.shear - m.young));
    if (std::fabs(K - m.bulk_modulus()) > 0.05 * K)
      lmp->error->warning(FLERR,
                          "sph/solid type {}: the equation of state has bulk modulus {:.4g}, but "
                          "young {:.4g} and shear {:.4g} belong to {:.4g}; the run uses the first, "
                          "so that its effective Young's modulus is {:.4g}",
                          type, m.bulk_modulus(), m.young, m.shear, K, m.youngs_modulus());
  }
}
