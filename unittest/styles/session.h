/* ----------------------------------------------------------------------
   One LAMMPS in this process, fed with lines of input, and what the tests
   of the styles ask it: messages of errors, numbers, the state of particles.
------------------------------------------------------------------------- */

#ifndef SPHSOLID_TEST_SESSION_H
#define SPHSOLID_TEST_SESSION_H

#include "atom.h"
#include "atom_vec_sph_solid.h"
#include "comm.h"
#include "compute.h"
#include "exceptions.h"
#include "fix.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"
#include "variable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <mpi.h>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace sphsolid_test {

using testing::HasSubstr;
using testing::Not;

// a folder for the files of this process, removed when it ends

inline const std::string &folder()
{
  struct Folder {
    std::string path;
    Folder()
    {
      const auto root = std::filesystem::temp_directory_path();
      path = (root / ("sphsolid-test-" + std::to_string(getpid()))).string();
      std::filesystem::create_directories(path);
    }
    ~Folder()
    {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static const Folder one;
  return one.path;
}

inline std::string file(const std::string &name)
{
  return folder() + "/" + name;
}

inline std::string write_file(const std::string &name, const std::string &text)
{
  std::ofstream out(file(name));
  out << text;
  return file(name);
}

inline std::string read_file(const std::string &path)
{
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

// a number as LAMMPS reads it back exactly

inline std::string num(double value)
{
  char text[32];
  snprintf(text, sizeof(text), "%.17g", value);
  return text;
}

// what a particle is, in doubles, for comparisons

struct Particle {
  double id, x[3], v[3], f[3], mass, rho, e, stress[6], epl;
};

static constexpr int NDOUBLES = sizeof(Particle) / sizeof(double);

inline const char *name_of_double(int k)
{
  static const char *const names[] = {"id",  "x",   "y",   "z",    "vx",  "vy", "vz",
                                      "fx",  "fy",  "fz",  "mass", "rho", "e",  "sxx",
                                      "syy", "szz", "sxy", "sxz",  "syz", "epl"};
  return names[k];
}

using State = std::vector<Particle>;    // in the order of IDs

/* ---------------------------------------------------------------------- */

class Session {
 public:
  LAMMPS_NS::LAMMPS *lmp;

  explicit Session(MPI_Comm comm = MPI_COMM_WORLD)
  {
    static int count = 0;
    int me;
    MPI_Comm_rank(comm, &me);
    logfile = file("log." + std::to_string(count++));
    std::vector<std::string> words = {"test", "-screen", "none", "-nocite", "-log", logfile};
    std::vector<char *> args;
    for (auto &w : words) args.push_back(&w[0]);
    lmp = new LAMMPS_NS::LAMMPS(static_cast<int>(args.size()), args.data(), comm);
    world = comm;
  }
  ~Session() { delete lmp; }
  Session(const Session &) = delete;
  Session &operator=(const Session &) = delete;

  // lines of input; an error is a failure of the test

  Session &operator()(const std::string &lines)
  {
    const std::string problem = error(lines);
    if (!problem.empty()) ADD_FAILURE() << "LAMMPS stopped: " << problem;
    return *this;
  }

  // the message LAMMPS stops with, empty if it does not

  std::string error(const std::string &lines)
  {
    std::istringstream in(lines);
    std::string line;
    try {
      while (std::getline(in, line))
        if (line.find_first_not_of(" ") != std::string::npos) lmp->input->one(line);
    } catch (LAMMPS_NS::LAMMPSException &e) {
      return e.what();
    }
    return "";
  }

  std::string log() const
  {
    if (lmp->logfile) fflush(lmp->logfile);
    return read_file(logfile);
  }

  // value of a formula as in "variable x equal <formula>"

  double value(const std::string &formula)
  {
    try {
      return lmp->input->variable->compute_equal(formula);
    } catch (LAMMPS_NS::LAMMPSException &e) {
      ADD_FAILURE() << "LAMMPS stopped: " << e.what();
      return NAN;
    }
  }

  // column of a per-atom compute by ID; column 0 of one with a single column

  std::map<int, double> per_atom(const std::string &compute, int column = 0)
  {
    LAMMPS_NS::Compute *c = lmp->modify->get_compute_by_id(compute);
    c->compute_peratom();
    std::map<int, double> out;
    for (int i = 0; i < lmp->atom->nlocal; i++)
      out[lmp->atom->tag[i]] = c->size_peratom_cols ? c->array_atom[i][column] : c->vector_atom[i];
    return out;
  }

  // all particles of all ranks, on every rank

  State state() const
  {
    const LAMMPS_NS::Atom *atom = lmp->atom;
    const auto *own = LAMMPS_NS::AtomVecSPHSolid::arrays(lmp->atom);
    State mine(atom->nlocal);
    for (int i = 0; i < atom->nlocal; i++) {
      Particle &p = mine[i];
      p.id = atom->tag[i];
      std::copy(atom->x[i], atom->x[i] + 3, p.x);
      std::copy(atom->v[i], atom->v[i] + 3, p.v);
      std::copy(atom->f[i], atom->f[i] + 3, p.f);
      p.mass = atom->rmass[i];
      p.rho = atom->rho[i];
      p.e = atom->esph[i];
      std::copy(own->stress[i], own->stress[i] + 6, p.stress);
      p.epl = own->epl[i];
    }
    int nprocs;
    MPI_Comm_size(world, &nprocs);
    std::vector<int> sizes(nprocs), starts(nprocs, 0);
    const int size = atom->nlocal * NDOUBLES;
    MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
    for (int k = 1; k < nprocs; k++) starts[k] = starts[k - 1] + sizes[k - 1];
    State all((starts.back() + sizes.back()) / NDOUBLES);
    MPI_Allgatherv(mine.data(), size, MPI_DOUBLE, all.data(), sizes.data(), starts.data(),
                   MPI_DOUBLE, world);
    std::sort(all.begin(), all.end(), [](const Particle &a, const Particle &b) {
      return a.id < b.id;
    });
    return all;
  }

  Particle particle(int id) const
  {
    for (const Particle &p : state())
      if (p.id == id) return p;
    ADD_FAILURE() << "no particle " << id;
    return Particle();
  }

 private:
  std::string logfile;
  MPI_Comm world;
};

/* ----------------------------------------------------------------------
   comparisons of states
------------------------------------------------------------------------- */

inline void expect_bitwise(const State &a, const State &b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); i++) {
    const double *p = &a[i].id, *q = &b[i].id;
    for (int k = 0; k < NDOUBLES; k++)
      ASSERT_EQ(std::memcmp(p + k, q + k, sizeof(double)), 0)
          << name_of_double(k) << " of particle " << a[i].id << " is " << num(p[k]) << " and "
          << num(q[k]) << ", difference " << p[k] - q[k];
  }
}

// largest difference of the kth double over the largest value of its kind
// (vectors and tensors count as one kind); kinds that are zero everywhere fit

inline double largest_difference(const State &a, const State &b)
{
  static const int kinds[][2] = {{1, 4},   {4, 7},   {7, 10},  {10, 11},
                                 {11, 12}, {12, 13}, {13, 19}, {19, 20}};
  if (a.size() != b.size()) return INFINITY;
  double worst = 0.0;
  for (const auto &kind : kinds) {
    double scale = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < a.size(); i++)
      for (int k = kind[0]; k < kind[1]; k++) {
        const double p = (&a[i].id)[k], q = (&b[i].id)[k];
        scale = std::max(scale, std::fabs(p));
        if (!std::isfinite(p - q)) return INFINITY;
        difference = std::max(difference, std::fabs(p - q));
      }
    if (difference > 0.0) worst = std::max(worst, difference / scale);
  }
  return worst;
}

// the frame of this process: tests that hold in both run once in each

inline std::string frame_under_test()
{
  const char *frame = std::getenv("SPHSOLID_TEST_FRAME");
  return frame ? frame : "eulerian";
}

// and more words for pair_style, for tests that hold whatever the precision

inline std::string options_under_test()
{
  const char *options = std::getenv("SPHSOLID_TEST_OPTIONS");
  return options ? options : "";
}
inline bool mixed_under_test()
{
  return options_under_test().find("precision mixed") != std::string::npos;
}

/* ----------------------------------------------------------------------
   bodies.  The iron is that of potentials/metals.sphsolid
------------------------------------------------------------------------- */

static constexpr double RHO0 = 7850.0, C0 = 3600.0, S0 = 1.8, GAMMA = 1.8, MU = 80.0e9,
                        Y0 = 600.0e6;
static constexpr const char *IRON =
    "inline rho0 7850 eos mie-gruneisen 3600 1.8 1.8 shear 80e9 strength perfect 600e6\n";

inline const std::string NEIGHBOR = "neighbor 0.0003 bin\nneigh_modify every 1 delay 0 check yes\n";
inline const std::string MOVE = "fix move all sph/solid\nfix step all sph/solid/dt 1 0.3\n";

// a block of nx x ny (x nz) particles, 1 mm apart, the lowest one at the
// origin, in an ample box.  Every text goes where its name says

struct Block {
  int nx = 12, ny = 20, nz = 0;    // nz = 0: two dimensions
  int types = 1;                   // that there is room for
  std::string first = "";          // before the box exists
  std::string style = "sph/solid";
  std::string boundary = "f f";
  std::string box = "-0.04 0.04 -0.04 0.04";
  double h = 1.3e-3;
  std::string frame = frame_under_test();
  std::string options = "";    // of pair_style
  std::string material = IRON;
  std::string motion = "velocity all set 0 -200 0 units box\n";
  std::string fixes = MOVE;

  double spacing() const { return 1.0e-3; }

  std::string particles() const
  {
    const bool flat = (nz == 0);
    const std::string z = flat ? "-0.0005 0.0005" : "-0.04 0.04";
    std::ostringstream s;
    s << "units si\n"
      << "dimension " << (flat ? 2 : 3) << "\n"
      << "boundary " << boundary << (flat ? " p" : " f") << "\n"
      << "atom_style " << style << "\n"
      << "atom_modify map array\n"
      << first << "region box block " << box << " " << z << "\n"
      << "create_box " << types << " box\n"
      << "lattice " << (flat ? "sq" : "sc") << " 0.001\n"
      << "region body block -0.1 " << nx - 0.9 << " -0.1 " << ny - 0.9 << " -0.1 "
      << (flat ? 0.1 : nz - 0.9) << "\n"
      << "create_atoms 1 region body\n"
      << "set group all volume " << (flat ? "1e-6" : "1e-9") << "\n";
    return s.str();
  }

  std::string interaction() const
  {
    return "pair_style sph/solid " + num(h) + " frame " + frame + " " + options + " " +
        options_under_test() + "\npair_coeff * * " + material + NEIGHBOR;
  }

  std::string script() const { return particles() + interaction() + motion + fixes; }
};

// particles from a list, through a data file: any position, volume, velocity

struct Point {
  double x, y, z, volume, vx, vy, vz;
};

inline std::string data_file(const std::string &name, const std::vector<Point> &points,
                             bool flat = true)
{
  std::ostringstream s;
  const char *z = flat ? "-0.0005 0.0005" : "-0.04 0.04";
  s << "particles of a test\n\n"
    << points.size() << " atoms\n1 atom types\n\n-0.04 0.04 xlo xhi\n-0.04 0.04 ylo yhi\n"
    << z << " zlo zhi\n\nAtoms # sph/solid\n\n";
  int id = 0;
  for (const Point &p : points)
    s << ++id << " 1 " << num(p.volume) << " 0 0 0 " << num(p.x) << " " << num(p.y) << " "
      << num(p.z) << "\n";
  s << "\nVelocities\n\n";
  id = 0;
  for (const Point &p : points)
    s << ++id << " " << num(p.vx) << " " << num(p.vy) << " " << num(p.vz) << "\n";
  return write_file(name, s.str());
}

}    // namespace sphsolid_test

#endif
