/* ----------------------------------------------------------------------
   Constants that pairs share: nothing is lost or mixed up, what is alike is stored once, and a
   lattice profits from it.
------------------------------------------------------------------------- */

#include "lagrangian_body.h"
#include "sph_solid_shared.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace SPHSolid;

namespace {

constexpr int N = 3;
using Shared = SharedVectors<double, N>;

// vectors of small whole numbers, of which many are alike, or of any numbers

Shared::Numbers vectors(int count, int different, int seed)
{
  Noise noise(seed);
  Shared::Numbers of;
  for (int k = 0; k < count * N; k++)
    of.push_back(different ? std::floor(different * 0.5 * (1.0 + noise())) : noise());
  return of;
}

// in two parts, the second one first, as threads may do

Shared shared(const Shared::Numbers &of)
{
  const std::size_t count = of.size() / N, part = count / 3;
  Shared s;
  s.begin(count);
  s.enter(part, Shared::Numbers(of.begin() + part * N, of.end()));
  s.enter(0, Shared::Numbers(of.begin(), of.begin() + part * N));
  s.end();
  return s;
}

void expect_same(const Shared &s, const Shared::Numbers &of)
{
  for (std::size_t k = 0; k < of.size() / N; k++)
    for (int c = 0; c < N; c++) {
      ASSERT_EQ(s.of(k)[c], of[k * N + c]) << k;
      ASSERT_EQ(s.from(k).of(0)[c], of[k * N + c]) << k;
    }
}

std::size_t entries(const Shared &s, std::size_t count)
{
  std::set<const double *> places;
  for (std::size_t k = 0; k < count; k++) places.insert(s.of(k));
  return places.size();
}

}    // namespace

TEST(SharedVectors, GiveBackWhatWasEntered)
{
  for (int different : {0, 2, 20}) {
    const Shared::Numbers of = vectors(20000, different, 5);
    expect_same(shared(of), of);
  }
}

// 2^3 or 7^3 vectors there are, and one entry for each; where none are alike, one for each vector

TEST(SharedVectors, StoreOnceWhatIsAlike)
{
  const int count = 5000;
  EXPECT_EQ(entries(shared(vectors(count, 2, 6)), count), 8u);
  EXPECT_EQ(entries(shared(vectors(count, 7, 8)), count), 343u);
  EXPECT_EQ(entries(shared(vectors(count, 0, 7)), count), static_cast<std::size_t>(count));
}

// 0 and -0 are equal and not alike

TEST(SharedVectors, TellBitsApart)
{
  const Shared s = shared({1.0, 2.0, 0.0, 1.0, 2.0, -0.0, 1.0, 2.0, 0.0});
  EXPECT_FALSE(std::signbit(s.of(0)[2]));
  EXPECT_TRUE(std::signbit(s.of(1)[2]));
  EXPECT_EQ(s.of(0), s.of(2));
}

// 32 bits: wrong by no more than half of the last one, the same for either sign, and the same again
// where it has been rounded; rounding of lengths makes no difference but for one in a thousand

TEST(Rounded, HasThirtyTwoBits)
{
  Noise noise(9);
  int apart = 0;
  const int trials = 100000;
  for (int k = 0; k < trials; k++) {
    const double x = std::ldexp(1.0 + 0.5 * (1.0 + noise()), k % 80 - 40);
    const double r = rounded(x);
    ASSERT_LE(std::fabs(r / x - 1.0), 0x1p-32);
    ASSERT_EQ(rounded(-x), -r);
    ASSERT_EQ(rounded(r), r);
    int exponent;
    const double bits = std::ldexp(std::frexp(r, &exponent), 32);
    ASSERT_EQ(bits, std::floor(bits));
    if (rounded(x * (1.0 + 3e-15 * noise())) != r) apart++;
  }
  EXPECT_LT(apart, trials / 1000);
  EXPECT_EQ(rounded(0.0), 0.0);
}

// a lattice has some hundred different slots however large it is and however it is turned, one whose particles
// lie anywhere has a vector per slot: kernel gradient and nearness, 4 bytes each, and a weight of 8 for 8 pairs

TEST(SharedVectors, AreFewOnALattice)
{
  auto bytes_per_particle = [](double jitter, double turn) {
    Cloud c(2);
    c.add_lattice(60, 60);
    for (int i = 0; i < c.size(); i++) c.x[i] = Eigen::AngleAxisd(turn, Vector3d::UnitZ()) * c.x[i];
    c.opt.frame = Frame::LAGRANGIAN;
    c.opt.viscosity = Viscosity::CORRECT;
    Noise noise(1);
    for (int i = 0; i < c.size(); i++) c.x[i] += jitter * noise.vector(2);
    c.refer();
    c.evaluate(0.0);
    return c.sweeps->memory_usage() / c.size();
  };
  const double lattice = bytes_per_particle(0.0, 0.0), any = bytes_per_particle(1e-4, 0.0);
  EXPECT_GT(any - lattice, 0.9 * 8 * 16.0);
  EXPECT_LT(lattice, 400.0);
  EXPECT_LT(bytes_per_particle(0.0, 0.6), 1.01 * lattice);
}
