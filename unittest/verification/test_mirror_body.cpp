/* ----------------------------------------------------------------------
   A body that hits `fix sph/solid/wall ... symmetry` is half of a body twice
   as large, made of real particles, whose halves hit each other.

   Particles on the plane have full cells in the whole body and half cells
   in the half one.  Sums run in different orders, so the two differ by
   rounding, and by what the motion makes of it.
------------------------------------------------------------------------- */

#include "session.h"

using namespace sphsolid_test;

namespace {

constexpr double V0 = 200.0, DX = 1.0e-3;

struct Body {
  std::vector<Point> points;
  std::map<std::array<int, 3>, int> id;    // by lattice indices
};

// nx x ny x nz cells on each side of the planes; nplanes = 1: y = 0; 2: x = 0
// as well; 3: z = 0 as well.  part: only what lies in front of the planes

Body body(int nplanes, bool part, const std::array<int, 3> &n)
{
  const int dim = n[2] ? 3 : 2;
  static const int order[] = {1, 0, 2};    // which plane comes first
  bool mirrored[3] = {false, false, false};
  for (int k = 0; k < nplanes; k++) mirrored[order[k]] = true;

  Body b;
  std::array<int, 3> lo = {0, 0, 0};
  for (int d = 0; d < dim; d++)
    if (mirrored[d] && !part) lo[d] = -n[d];
  for (int k = lo[2]; k <= n[2]; k++)
    for (int j = lo[1]; j <= n[1]; j++)
      for (int i = lo[0]; i <= n[0]; i++) {
        const std::array<int, 3> at = {i, j, k};
        double volume = std::pow(DX, dim);
        for (int d = 0; d < dim; d++)
          if (at[d] == lo[d] || at[d] == n[d]) volume *= 0.5;
        // every direction with a plane closes at it; halves move towards each other along y
        const double vy = (j > 0) ? -V0 : (j < 0) ? V0 : 0.0;
        b.points.push_back({i * DX, j * DX, k * DX, volume, 0.0, vy, 0.0});
        b.id[at] = static_cast<int>(b.points.size());
      }
  return b;
}

std::string script(const Body &b, const std::string &name, const std::string &options, bool flat,
                   const std::string &walls)
{
  return "units si\ndimension " + std::string(flat ? "2" : "3") + "\nboundary f f " +
      (flat ? "p" : "f") + "\natom_style sph/solid\natom_modify map array\nread_data " +
      data_file(name, b.points, flat) + "\npair_style sph/solid " + num(1.3 * DX) +
      " frame eulerian " + options + "\npair_coeff * * " + IRON +
      "neighbor 0.0003 bin\nneigh_modify every 1 delay 0 check yes\ntimestep 4e-8\n"
      "fix move all sph/solid\n" +
      walls;
}

const std::string WALL[] = {"fix wy all sph/solid/wall ylo 0.0 symmetry\n",
                            "fix wx all sph/solid/wall xlo 0.0 symmetry\n",
                            "fix wz all sph/solid/wall zlo 0.0 symmetry\n"};

// largest difference between the part and the same particles of the whole,
// over the largest value of its kind in the whole

void compare(int nplanes, const std::array<int, 3> &n, const std::string &options)
{
  const bool flat = (n[2] == 0);
  const Body part = body(nplanes, true, n), whole = body(nplanes, false, n);
  std::string walls;
  for (int k = 0; k < nplanes; k++) walls += WALL[k];
  Session a, b;
  a(script(part, "part.data", options, flat, walls));
  b(script(whole, "whole.data", options, flat, ""));
  for (int steps = 0; steps <= 200; steps += 50) {
    const std::string run = "run " + std::to_string(steps ? 50 : 0) + "\n";
    a(run);
    b(run);
    const State p = a.state(), w = b.state();
    State mine, same;
    for (const auto &entry : part.id) {
      mine.push_back(p[entry.second - 1]);
      same.push_back(w[whole.id.at(entry.first) - 1]);
    }
    double epl = 0.0;
    for (std::size_t k = 0; k < same.size(); k++) {
      // on a plane the part has half of the cell, of the mass and of the force
      Particle &q = same[k];
      const double share = mine[k].mass / q.mass;
      q.id = mine[k].id;
      q.mass *= share;
      for (double &f : q.f) f *= share;
      epl = std::max(epl, q.epl);
    }
    EXPECT_LT(largest_difference(mine, same), 1.0e-11) << "step " << steps;
    if (steps == 200) { EXPECT_GT(epl, 0.1); }    // much has happened
  }
}

}    // namespace

// measured after 200 steps, largest plastic strain 0.4 to 0.55: differences of 5e-14 to 1.4e-13

TEST(MirrorBody, HalfWithCorrection)
{
  compare(1, {7, 12, 0}, "viscosity correct");
}

TEST(MirrorBody, HalfWithShepardWeights)
{
  compare(1, {7, 12, 0}, "viscosity correct weights shepard");
}

TEST(MirrorBody, HalfWithMonaghansViscosity)
{
  compare(1, {7, 12, 0}, "viscosity monaghan 1 1");
}

TEST(MirrorBody, HalfWithPlainGradientAndArtificialStress)
{
  compare(1, {7, 12, 0}, "viscosity monaghan 1 1 gradient plain tensile artificial 0.3 4");
}

TEST(MirrorBody, Quarter)
{
  compare(2, {4, 12, 0}, "viscosity correct");
}

TEST(MirrorBody, Eighth)
{
  compare(3, {3, 5, 3}, "viscosity correct");
}
