/* ----------------------------------------------------------------------
   The acceleration correction as a filter: what it leaves of the standard
   viscosity at which wavelength, and what becomes of lonely particles.
------------------------------------------------------------------------- */

#include "spline_by_hand.h"
#include "sums.h"

#include <gtest/gtest.h>

using namespace SPHSolid;

namespace {

// forces of the correction alone for a given viscous acceleration

void correct(Cloud &c, const std::function<Vector3d(Vector3d)> &acceleration)
{
  c.advance(0.0);
  c.sweeps->mirror_stress();
  c.sweeps->force(c.particles(), c.neighbors());
  c.forget_forces();
  for (int i = 0; i < c.size(); i++) c.set(Message::VISCOUS, i, acceleration(c.x[i]));
  c.sweeps->correction(c.particles(), c.neighbors());
}

struct Mean {
  double value, error;    // and its standard error
};

Mean mean(const std::vector<double> &all)
{
  double s = 0.0, s2 = 0.0;
  for (double one : all) {
    s += one;
    s2 += one * one;
  }
  const double n = static_cast<double>(all.size());
  return {s / n, std::sqrt((s2 / n - s * s / n / n) / (n - 1.0))};
}

// Wbar of two particles, without its factor, which is not in the weights

double wbar(const Cloud &c, int i, int j)
{
  return i == j ? 0.0 : spline((c.x[i] - c.x[j]).norm() / (0.5 * c.opt.hbar * c.spacing));
}

// the share of the power of these accelerations that the operator 1/2 sum w_ij (A_i - A_j) leaves, summed
// over all pairs from its definition

double share_left(const Cloud &c, const std::vector<Vector3d> &A)
{
  std::vector<double> n(c.size(), 0.0);
  for (int i = 0; i < c.size(); i++)
    for (int j = 0; j < c.size(); j++) n[i] += c.mass[j] * wbar(c, i, j);
  double left = 0.0, all = 0.0;
  for (int i = 0; i < c.size(); i++) {
    all += c.mass[i] * c.v[i].dot(A[i]);
    for (int j = 0; j < c.size(); j++) {
      const double norm = c.opt.weights == Weights::SHEPARD ? n[i] : std::max(n[i], n[j]);
      left += 0.5 * c.mass[i] * c.mass[j] * wbar(c, i, j) / norm * c.v[i].dot(A[i] - A[j]);
    }
  }
  return left / all;
}

// power the viscosity takes, relative to the standard one, over random clouds
// of 196 particles (25 % jitter, 5 % of density, h = 1.3 spacings).  Of each cloud it is what the
// operator leaves of the standard accelerations

Mean damping(Weights weights, double hbar, const std::function<Vector3d(Vector3d, Noise &)> &field)
{
  std::vector<double> ratio;
  for (int seed = 1; seed <= 100; seed++) {
    Cloud c = random_cloud(2, seed);
    Noise noise(1000 + seed);
    c.no_stress();    // viscosity is all there is
    c.opt.hbar = hbar;
    c.opt.weights = weights;
    c.move([&](Vector3d x) {
      return field(x, noise);
    });
    c.opt.viscosity = Viscosity::MONAGHAN;
    c.evaluate();
    const double standard = power(c);
    std::vector<Vector3d> A = forces(c);
    for (int i = 0; i < c.size(); i++) A[i] /= c.mass[i];
    c.opt.viscosity = Viscosity::CORRECT;
    c.evaluate();
    ratio.push_back(power(c) / standard);
    EXPECT_NEAR(ratio.back(), share_left(c, A), 1e-6) << seed;
  }
  return mean(ratio);
}

// power of the forces on those of a square of n x n particles that are `margin` and more away from its edges:
// the standard viscosity and what the correction leaves of it

struct Powers {
  double standard, left;
};

Powers powers_inside(Cloud &c, int margin, double end)
{
  auto inside = [&](Viscosity viscosity) {
    c.opt.viscosity = viscosity;
    c.evaluate();
    double sum = 0.0;
    for (int i = 0; i < c.size(); i++) {
      const auto x = c.x[i].head<2>();
      if (x.minCoeff() > margin - 0.5 && x.maxCoeff() < end - 0.5) sum += c.f(i).dot(c.v[i]);
    }
    return sum;
  };
  return {inside(Viscosity::MONAGHAN), inside(Viscosity::CORRECT)};
}

// rows of weights on a square lattice: of a neighbor along an axis and along a diagonal, 1.5 spacings of
// support; one row has four of each

struct LatticeWeights {
  double axis, diagonal;
};

LatticeWeights square_lattice_weights()
{
  const double a = spline(1.0 / 0.75), d = spline(M_SQRT2 / 0.75);
  return {a / (4.0 * (a + d)), d / (4.0 * (a + d))};
}

Vector3d white_noise(Vector3d, Noise &noise)
{
  return 0.001 * noise.vector(2);
}

// longitudinal waves of 14 spacings along both axes

Vector3d smooth(Vector3d x, Noise &)
{
  const double k = 2.0 * M_PI / 14.0;
  return 0.001 * Vector3d(std::sin(k * x[0]), std::sin(k * x[1]), 0.0);
}

// a cluster and one particle that is inside its kernels (2.6) but has no
// nearest neighbor (1.5)

Cloud with_lonely_particle(int dim)
{
  Cloud c(dim);
  c.add_lattice(5, 5, 5);
  Noise noise(23);
  c.stir(noise, 0.1);
  c.add({-1.8, 2.0, dim == 3 ? 2.0 : 0.0}, {1.0, 0.3, 0.0});
  return c;
}

}    // namespace

/* ----------------------------------------------------------------------
   the filter 1/2 sum w_ij (a_i - a_j) on a lattice
------------------------------------------------------------------------- */

// a uniform acceleration is given back completely, anywhere in any body

TEST(Filter, UniformAccelerationVanishes)
{
  for (Weights weights : {Weights::CONSERVATIVE, Weights::SHEPARD}) {
    Cloud c = random_cloud(2);
    c.opt.weights = weights;
    correct(c, [](Vector3d) -> Vector3d {
      return {1.0, -2.0, 0.0};
    });
    for (int i = 0; i < c.size(); i++) EXPECT_EQ(c.f(i), Vector3d::Zero().eval());
  }
}

// a linear one too, where neighbors lie symmetrically

TEST(Filter, LinearAccelerationVanishesInLattice)
{
  for (int dim : {2, 3}) {
    Cloud c = lattice(dim, 7);
    correct(c, [](Vector3d x) -> Vector3d {
      return {x[0] + 2.0 * x[1], -x[0], 0.0};
    });
    EXPECT_LT(c.f(middle(c)).norm(), 1e-15);
  }
}

// support of Wbar: 1.5 spacings.  Rows of weights on a lattice, normalised
// without the particle itself (spline evaluated with 30 digits):
// 2d: axis 0.2487436867, diagonal 0.0012563133 each; 3d: 0.1649999579, 0.0008333544.
// A mode cos(k.x) is multiplied by 1/2 sum w (1 - cos k.r).  Wbar is kept in single precision

TEST(Filter, ShortestWaveAlongOneAxis)
{
  const double axis[2] = {0.24874368670764582, 0.16499995791032141};
  const double diagonal[2] = {0.0012563132923541832, 0.0008333543781726295};
  for (int dim : {2, 3})
    for (Weights weights : {Weights::CONSERVATIVE, Weights::SHEPARD}) {
      Cloud c = lattice(dim, 7);
      c.opt.weights = weights;
      correct(c, [](Vector3d x) -> Vector3d {
        return {std::cos(M_PI * (x[0] - 3.0)), 0, 0};
      });
      const double left = 2.0 * axis[dim - 2] + (dim == 2 ? 4.0 : 8.0) * diagonal[dim - 2];
      EXPECT_NEAR(c.f(middle(c))[0], left, SINGLE);
    }
}

TEST(Filter, Checkerboard)
{
  const double axis[2] = {0.24874368670764582, 0.16499995791032141};
  for (int dim : {2, 3}) {
    Cloud c = lattice(dim, 7);
    const double phase = 3.0 * dim;    // + at the middle
    correct(c, [phase](Vector3d x) -> Vector3d {
      return {std::cos(M_PI * (x.sum() - phase)), 0, 0};
    });
    EXPECT_NEAR(c.f(middle(c))[0], 2.0 * dim * axis[dim - 2], SINGLE);
  }
}

// fourth power of the wave number instead of the second: half the wave number
// leaves a quarter of the share (1 - cos k: ratio 3.985 at 2 pi/28 to 2 pi/56)

TEST(Filter, LongWavesKeepTheirEnergy)
{
  auto left = [](double k) {
    Cloud c = lattice(2, 7);
    correct(c, [k](Vector3d x) -> Vector3d {
      return {std::cos(k * (x[0] - 3.0)), 0, 0};
    });
    return c.f(middle(c))[0];
  };
  const double k = 2.0 * M_PI / 28.0;
  EXPECT_NEAR(left(k) / left(0.5 * k), (1.0 - std::cos(k)) / (1.0 - std::cos(0.5 * k)), 1e-11);
  // w over all pairs of columns sums to 1/2: (1 - cos k)/4 and a little
  EXPECT_LT(left(k), 0.26 * (1.0 - std::cos(k)));
}

// a row of weights never exceeds one, so alternating accelerations are at most
// kept, not amplified: |1/2 sum w (a_i - a_j)| <= |a|

TEST(Filter, NeverAmplifies)
{
  for (int dim : {2, 3})
    for (Weights weights : {Weights::CONSERVATIVE, Weights::SHEPARD}) {
      Cloud c = random_cloud(dim);
      c.opt.weights = weights;
      Noise noise(3);
      correct(c, [&](Vector3d) -> Vector3d {
        return {noise() > 0.0 ? 1.0 : -1.0, 0, 0};
      });
      for (int i = 0; i < c.size(); i++) EXPECT_LE(std::fabs(c.f(i)[0]), c.mass[i] * (1.0 + 1e-14));
    }
}

// what one particle keeps of an acceleration that no other has is half of its row of weights.  Rows of
// shepard weights add up to one; conservative ones, which divide by the larger of two n, to less at faces, edges
// and corners, whose neighbors have more neighbors: with a and d what Wbar is along axes and
// diagonals, n is 4a + 4d, 3a + 2d, 2a + d in two dimensions and 6a + 12d, 5a + 8d, 4a + 5d, 3a + 3d in three

TEST(Filter, RowsOfWeightsAddUpToOneAtMost)
{
  const double a = spline(1.0 / 0.75), d = spline(M_SQRT2 / 0.75);
  const double corner[2] = {2.0 * a / (3.0 * a + 2.0 * d) + d / (4.0 * a + 4.0 * d),
                            3.0 * a / (4.0 * a + 5.0 * d) + 3.0 * d / (5.0 * a + 8.0 * d)};
  for (int dim : {2, 3})
    for (Weights weights : {Weights::CONSERVATIVE, Weights::SHEPARD}) {
      Cloud c = lattice(dim, 5);
      c.opt.weights = weights;
      auto row = [&c](int i) {
        correct(c, [&](Vector3d x) -> Vector3d {
          return {x == c.x[i] ? 1.0 : 0.0, 0, 0};
        });
        return 2.0 * c.f(i)[0] / c.mass[i];
      };
      EXPECT_NEAR(row(middle(c)), 1.0, KERNEL_ERROR);
      EXPECT_NEAR(row(0), weights == Weights::SHEPARD ? 1.0 : corner[dim - 2], KERNEL_ERROR);
      Noise noise(5);
      c.stir(noise);
      for (int i = 0; i < c.size(); i++) {
        const double sum = row(i);
        EXPECT_LT(sum, 1.0 + KERNEL_ERROR);
        EXPECT_GT(sum, weights == Weights::SHEPARD ? 1.0 - KERNEL_ERROR : 0.0);
      }
    }
}

// the definition, summed over all pairs: w_ij = m_j Wbar_ij/max(n_i, n_j) or
// m_j Wbar_ij/n_i, n_i = sum over j != i of m_j Wbar_ij

TEST(Filter, MatchesItsDefinition)
{
  for (int dim : {2, 3})
    for (Weights weights : {Weights::CONSERVATIVE, Weights::SHEPARD}) {
      Cloud c = random_cloud(dim);
      Noise noise(4);
      for (double &m : c.mass) m *= 1.0 + 0.3 * noise();
      c.opt.weights = weights;
      auto a = [](Vector3d x) -> Vector3d {
        return {std::sin(3.0 * x[0]), x[1] * x[1], 0.0};
      };
      correct(c, a);
      auto wbar = [&c](int i, int j) {
        const double r = (c.x[i] - c.x[j]).norm(), h = 0.5 * c.opt.hbar;
        return c.dim == 2 ? CubicSpline<2>::w(r, h) : CubicSpline<3>::w(r, h);
      };
      std::vector<double> n(c.size(), 0.0);
      for (int i = 0; i < c.size(); i++)
        for (int j = 0; j < c.size(); j++)
          if (j != i) n[i] += c.mass[j] * wbar(i, j);
      for (int i = 0; i < c.size(); i++) {
        Vector3d sum = Vector3d::Zero();
        double all = 0.0;
        for (int j = 0; j < c.size(); j++) {
          if (j == i) continue;
          const double norm = weights == Weights::SHEPARD ? n[i] : std::max(n[i], n[j]);
          const Vector3d term = c.mass[j] * wbar(i, j) / norm * (a(c.x[i]) - a(c.x[j]));
          sum += term;
          all += term.norm();
        }
        // Wbar_ij and n
        EXPECT_LT((c.f(i) - 0.5 * c.mass[i] * sum).norm(),
                  2 * KERNEL_ERROR * 0.5 * c.mass[i] * all);
      }
    }
}

/* ----------------------------------------------------------------------
   how much of the standard dissipation is left, on disordered particles.
   An own program, written apart from this package, found with Shepard weights
   and a support of 1.4 (2.0) spacings 0.60 (0.58) for white noise; two digits,
   so +-0.005, plus three standard errors of both ensembles
------------------------------------------------------------------------- */

TEST(Damping, NoiseShepard)
{
  const Mean narrow = damping(Weights::SHEPARD, 1.4, white_noise);
  const Mean wide = damping(Weights::SHEPARD, 2.0, white_noise);
  EXPECT_LT(narrow.error, 0.003);
  EXPECT_NEAR(narrow.value, 0.60, 0.005 + 4.3 * narrow.error);
  EXPECT_NEAR(wide.value, 0.58, 0.005 + 4.3 * wide.error);
}

// dividing by the larger n gives conservative weights less than that, of the same noise in the same clouds

TEST(Damping, NoiseConservative)
{
  const Mean m = damping(Weights::CONSERVATIVE, 1.5, white_noise);
  const Mean shepard = damping(Weights::SHEPARD, 1.5, white_noise);
  EXPECT_LT(m.value, shepard.value);
}

// White noise on a lattice.  Of the pair force k min(v_ij.x_ij, 0) x_ij the odd half, k (v_ij.x_ij) x_ij/2, is
// all that noise of either sign has a mean power with: the viscosity counts as a linear operator K, and what
// H = 1/2 (1 - w) leaves of its power is tr(H K)/tr(K) = 1/2 (1 + sum w k r^2/sum k r^2), k from
// the kernel gradient over r^2 + 0.01 h^2 (own derivation)

TEST(Damping, NoiseOnLattice)
{
  const double h = 1.3;
  const LatticeWeights w = square_lattice_weights();
  double weighted = 0.0, all = 0.0;
  for (int x = -2; x <= 2; x++)
    for (int y = -2; y <= 2; y++) {
      const double r2 = x * x + y * y, q = std::sqrt(r2) / h;
      if (r2 == 0.0 || q >= 2.0) continue;
      const double k_r2 = spline_slope(q) / q * r2 / (r2 + 0.01 * h * h);
      all += k_r2;
      weighted += k_r2 * (r2 == 1.0 ? w.axis : r2 == 2.0 ? w.diagonal : 0.0);
    }
  const double expected = 0.5 * (1.0 + weighted / all);
  std::vector<double> ratio;
  for (int seed = 1; seed <= 60; seed++) {
    Cloud c = lattice(2, 25);
    Noise noise(seed);
    for (Vector3d &v : c.v) v = 0.001 * noise.vector(2);
    const Powers p = powers_inside(c, 5, 20.0);
    ratio.push_back(p.left / p.standard);
  }
  const Mean m = mean(ratio);
  EXPECT_LT(m.error, 0.003);
  EXPECT_NEAR(m.value, expected, 4.3 * m.error);
}

// nearly all of the kinetic energy that the standard viscosity takes from a wave of 14 spacings is given back: disorder
// leaves a little more of it than a lattice, 0.0249 (below).  Measured: 0.0267 +- 0.0002, with shepard weights
// 0.0322 +- 0.0005; that it is what the operator leaves in each cloud, damping() has seen

TEST(Damping, SmoothField)
{
  for (Weights weights : {Weights::CONSERVATIVE, Weights::SHEPARD}) {
    const Mean m = damping(weights, 1.5, smooth);
    EXPECT_GT(m.value, 0.0249);
    EXPECT_LT(m.value, 0.035);
  }
}

// on an undisturbed lattice theory tells how much, to rounding, since the operator is symmetric and the wave one
// of its modes, whatever the viscosity makes of it: (1 - cos k)(w_axis + 2 w_diagonal), k = 2 pi/14, over whole
// periods in the bulk.  Without the small weights of diagonals that is (1 - cos k)/4

TEST(Damping, SmoothFieldOnLattice)
{
  Cloud c = lattice(2, 29);
  Noise noise(0);
  c.move([&](Vector3d x) {
    return smooth(x, noise);
  });
  const Powers p = powers_inside(c, 7, 21.0);
  const LatticeWeights w = square_lattice_weights();
  const double one = 1.0 - std::cos(2.0 * M_PI / 14.0);
  EXPECT_NEAR(p.left / p.standard / (one * (w.axis + 2.0 * w.diagonal)), 1.0, 1e-6);
  EXPECT_NEAR(p.left / p.standard / (0.25 * one), 1.0, 0.006);
}

/* ----------------------------------------------------------------------
   particles without nearest neighbors
------------------------------------------------------------------------- */

TEST(Lonely, KeepsStandardViscosity)
{
  for (int dim : {2, 3}) {
    Cloud c = with_lonely_particle(dim);
    const int last = c.size() - 1;
    c.evaluate();
    const Vector3d f = c.f(last);
    c.opt.viscosity = Viscosity::MONAGHAN;
    c.evaluate();
    const Vector3d standard = c.f(last);
    c.opt.viscosity = Viscosity::NONE;
    c.evaluate();
    EXPECT_GT((standard - c.f(last)).norm(), 1e-3);    // there is viscosity
    EXPECT_LT((f - standard).norm(), 1e-15);
  }
}

TEST(Lonely, MomentumAndEnergy)
{
  for (int dim : {2, 3})
    for (Weights weights : {Weights::CONSERVATIVE, Weights::SHEPARD}) {
      Cloud c = with_lonely_particle(dim);
      c.opt.weights = weights;
      c.evaluate();
      if (weights == Weights::CONSERVATIVE) { EXPECT_LT(net_force(c), 1e-14); }
      EXPECT_LT(energy_error(c, c.v), 1e-13);
    }
}

// two particles that see each other only by the large kernel: all is standard

TEST(Lonely, PairOfTwo)
{
  Cloud c = closing_pair(2.0);
  c.evaluate();
  const Vector3d f = c.f(0);
  c.opt.viscosity = Viscosity::MONAGHAN;
  c.evaluate();
  EXPECT_LT(f[0], 0.0);
  EXPECT_EQ(f, c.f(0));
}

// heat left and heat given back are the standard heating here too

TEST(Lonely, Ledger)
{
  Cloud c = with_lonely_particle(2);
  c.no_stress();
  const Ledger ledger = booked_heat(c);
  c.opt.viscosity = Viscosity::MONAGHAN;
  c.evaluate();
  EXPECT_NEAR((ledger.viscous_heat + ledger.returned) / -power(c), 1.0, 1e-12);
}

TEST(Lonely, Virial)
{
  Cloud c = with_lonely_particle(2);
  c.evaluate();
  double six[6] = {}, exact = 0.0;
  c.sweeps->virial(c.particles(), c.neighbors(), six);
  for (int i = 0; i < c.size(); i++) exact += c.x[i][0] * c.f(i)[0];
  EXPECT_NEAR(six[0], exact, 1e-13);
}
