/* ----------------------------------------------------------------------
   A half, quarter or eighth of a body with symmetry planes behaves as the
   whole body does.  In the Lagrangian frame the images belong to the reference
   configuration, which has been stretched and shaken since.
------------------------------------------------------------------------- */

#include "sums.h"

#include <gtest/gtest.h>

#include <tuple>

using namespace SPHSolid;

namespace {

// a part of a body that lies in x, y, z >= 0; planes at 0 in the first nplanes
// directions.  on_plane: the lattice has nodes on the planes, which carry half
// a cell (a quarter, an eighth where planes meet)

Cloud part(int dim, int nplanes, bool on_plane, Frame frame = Frame::EULERIAN)
{
  Cloud c(dim);
  c.opt.frame = frame;
  c.add_lattice(5, 5, 5);
  Noise noise(17);
  if (!on_plane)
    for (auto &x : c.x) x += Vector3d(0.5, 0.5, dim == 3 ? 0.5 : 0.0);
  const std::vector<Vector3d> lattice = c.x;
  c.stir(noise, 0.2);
  for (int d = 0; d < nplanes; d++) {
    c.planes.push_back({d, 0.0});
    for (int i = 0; i < c.size(); i++) {
      if (lattice[i][d] != 0.0) continue;
      c.x[i][d] = c.v[i][d] = 0.0;    // stays on the plane, no shear stress across it
      for (int a = 0; a < 3; a++)
        if (a != d) c.S[i][a + d == 1 ? 3 : a + d == 2 ? 4 : 5] = 0.0;
      c.mass[i] *= 0.5;
      c.volume[i] *= 0.5;
    }
  }
  if (frame == Frame::EULERIAN) return c;
  c.opt.hourglass = 0.1;
  c.refer();
  for (int i = 0; i < c.size(); i++) {
    c.x[i] = c.x[i].cwiseProduct(Vector3d(1.3, 0.8, 1.1)) + 0.05 * noise.vector(dim);
    for (const Plane &p : c.planes)
      if (c.xref[i][p.dim] == 0.0) c.x[i][p.dim] = 0.0;
  }
  return c;
}

int planes_through(const Cloud &c, int i)
{
  int n = 0;
  for (const Plane &p : c.planes) n += c.x[i][p.dim] == p.position;
  return n;
}

// the whole body: first the particles of the part, then their images; those on
// a plane become whole

Cloud whole(const Cloud &part)
{
  Cloud c(part.dim);
  c.opt = part.opt;
  for (int b = 0; b < (1 << part.planes.size()); b++)
    for (int i = 0; i < part.size(); i++) {
      Vector3d sign(1, 1, 1);
      bool is_image = true;
      for (std::size_t p = 0; p < part.planes.size(); p++)
        if (b & (1 << p)) {
          sign[part.planes[p].dim] = -1.0;
          if (part.x[i][part.planes[p].dim] == 0.0) is_image = false;
        }
      if (!is_image) continue;
      const double cells = 1 << planes_through(part, i);
      c.add(part.x[i].cwiseProduct(sign), part.v[i].cwiseProduct(sign), cells * part.volume[i]);
      c.mass.back() = cells * part.mass[i];
      c.rho.back() = part.rho[i];
      c.e.back() = part.e[i];
      if (part.opt.frame == Frame::LAGRANGIAN) {
        c.xref.push_back(part.xref[i].cwiseProduct(sign));
        c.vref.push_back(cells * part.vref[i]);
      }
      const std::array<double, 6> &s = part.S[i];
      c.S.back() = {s[0],
                    s[1],
                    s[2],
                    sign[0] * sign[1] * s[3],
                    sign[0] * sign[2] * s[4],
                    sign[1] * sign[2] * s[5]};
    }
  return c;
}

using Choice = std::tuple<int, bool, Viscosity, Weights, Frame>;    // planes, on_plane

class Mirror : public testing::TestWithParam<Choice> {
 protected:
  int dim() const { return std::get<0>(GetParam()) == 3 ? 3 : 2; }
  Cloud symmetric_part() const
  {
    auto [nplanes, on_plane, viscosity, weights, frame] = GetParam();
    Cloud c = part(dim(), nplanes, on_plane, frame);
    c.opt.viscosity = viscosity;
    c.opt.weights = weights;
    return c;
  }
};

std::string name(const testing::TestParamInfo<Choice> &info)
{
  auto [nplanes, on_plane, viscosity, weights, frame] = info.param;
  std::string s = nplanes == 1 ? "Half" : nplanes == 2 ? "Quarter" : "Eighth";
  s += on_plane ? "OnPlane" : "OffPlane";
  s += name_of(viscosity);
  if (viscosity == Viscosity::CORRECT)
    s += weights == Weights::SHEPARD ? "Shepard"
        : weights == Weights::SAFE   ? "Safe"
                                     : "Conservative";
  s += frame == Frame::LAGRANGIAN ? "Lagrangian" : "";
  return s;
}

}    // namespace

/* ---------------------------------------------------------------------- */

TEST_P(Mirror, Force)
{
  Cloud half = symmetric_part(), full = whole(half);
  half.evaluate(0.1);
  full.evaluate(0.1);
  double worst = 0.0;
  for (int i = 0; i < half.size(); i++) {
    const double cells = 1 << planes_through(half, i);
    worst = std::max(worst, (cells * half.f(i) - full.f(i)).norm());
  }
  EXPECT_LT(worst, 1e-14);    // forces are of order one
}

TEST_P(Mirror, State)
{
  Cloud half = symmetric_part(), full = whole(half);
  half.evaluate(0.1);
  full.evaluate(0.1);
  for (int i = 0; i < half.size(); i++) {
    EXPECT_NEAR(half.rho[i], full.rho[i], 1e-14);
    for (int a = 0; a < 6; a++) EXPECT_NEAR(half.S[i][a], full.S[i][a], 1e-15);
  }
}

TEST_P(Mirror, Heat)
{
  Cloud half = symmetric_part(), full = whole(half);
  half.evaluate(0.1);
  full.evaluate(0.1);
  const std::vector<double> h = half.heat(half.v), f = full.heat(full.v);
  double worst = 0.0;
  for (int i = 0; i < half.size(); i++)
    worst = std::max(worst, std::fabs((1 << planes_through(half, i)) * h[i] - f[i]));
  EXPECT_LT(worst, 1e-15);
}

// no force across a plane on a particle that lies on it

TEST_P(Mirror, NoForceAcrossPlane)
{
  Cloud half = symmetric_part();
  half.evaluate(0.1);
  for (int i = 0; i < half.size(); i++)
    for (const Plane &p : half.planes)
      if (half.x[i][p.dim] == p.position) { EXPECT_NEAR(half.f(i)[p.dim], 0.0, 1e-15); }
}

// a symmetry plane does no work

TEST_P(Mirror, Energy)
{
  Cloud half = symmetric_part();
  half.evaluate(0.1);
  EXPECT_LT(energy_error(half, half.v), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Standard, Mirror,
                         testing::Combine(testing::Values(1, 2, 3), testing::Bool(),
                                          testing::Values(Viscosity::NONE, Viscosity::MONAGHAN,
                                                          Viscosity::LIMITED, Viscosity::BALSARA,
                                                          Viscosity::FRONT),
                                          testing::Values(Weights::CONSERVATIVE),
                                          testing::Values(Frame::EULERIAN)),
                         name);
INSTANTIATE_TEST_SUITE_P(
    Correction, Mirror,
    testing::Combine(testing::Values(1, 2, 3), testing::Bool(), testing::Values(Viscosity::CORRECT),
                     testing::Values(Weights::CONSERVATIVE, Weights::SHEPARD, Weights::SAFE),
                     testing::Values(Frame::EULERIAN, Frame::LAGRANGIAN)),
    name);
INSTANTIATE_TEST_SUITE_P(Reference, Mirror,
                         testing::Combine(testing::Values(1, 2, 3), testing::Bool(),
                                          testing::Values(Viscosity::NONE, Viscosity::MONAGHAN,
                                                          Viscosity::LIMITED, Viscosity::BALSARA,
                                                          Viscosity::FRONT),
                                          testing::Values(Weights::CONSERVATIVE),
                                          testing::Values(Frame::LAGRANGIAN)),
                         name);

// a plane pushes along its normal only

TEST(MirrorHalf, MomentumAlongPlane)
{
  for (bool on_plane : {false, true})
    for (Viscosity viscosity : {Viscosity::NONE, Viscosity::MONAGHAN, Viscosity::CORRECT}) {
      Cloud half = part(2, 1, on_plane);
      half.opt.viscosity = viscosity;
      half.evaluate(0.1);
      double along = 0.0, all = 0.0;
      for (int i = 0; i < half.size(); i++) {
        along += half.f(i)[1];
        all += std::fabs(half.f(i)[1]);
      }
      EXPECT_LT(std::fabs(along), 1e-14 * all);
    }
}
