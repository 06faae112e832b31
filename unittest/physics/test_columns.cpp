/* ----------------------------------------------------------------------
   How the Lagrangian frame stores particles and pairs: loads from columns, slots of pairs, and
   that neither the order of particles nor the number of threads makes a difference.
------------------------------------------------------------------------- */

#include "lagrangian_body.h"
#include "sph_solid_columns.h"
#include "sph_solid_slots.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace SPHSolid;

namespace {

double number(int column, int component)
{
  return 1000.0 * component + column;
}

// from the one that ends with the first column to the one that begins with the last

void expect_numbers(const Columns &columns, int n, int components)
{
  for (int c = 0; c < components; c++)
    for (int first = 1 - LANES; first < n; first++) {
      const Pack read = load(columns.at(first) + c * Columns::NEXT);
      for (int m = std::max(0, -first); m < std::min(LANES, n - first); m++)
        ASSERT_EQ(read[m], number(first + m, c)) << first;
    }
}

using Lists = std::vector<Partner>[LANES];

// what arrange() makes of lists: in each lane its partners in their order, side by side only what
// lies so

struct Arranged {
  int slots = 0, gathered = 0;
  std::vector<int> seen[LANES];
};

Arranged arranged(const Lists &lists, int first, int price)
{
  Arranged out;
  arrange(lists, first, price, [&](bool side_by_side, int offset, const int *which) {
    out.slots++;
    if (!side_by_side) out.gathered++;
    for (int m = 0; m < LANES; m++) {
      if (which[m] < 0) continue;
      out.seen[m].push_back(which[m]);
      if (side_by_side) { EXPECT_EQ(lists[m][which[m]].column, first + m + offset); }
    }
  });
  for (int m = 0; m < LANES; m++) {
    std::vector<int> all(lists[m].size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(out.seen[m], all);
  }
  return out;
}

Partner partner(int column, bool nearest, int direction)
{
  return {column, column, nearest, direction, 0, 1.0};
}

}    // namespace

TEST(Columns, AreReadFromAnywhere)
{
  const int n = 3 * Columns::LENGTH + 5, components = 3;
  Columns one, several;
  one.resize(n, components, true);
  several.resize(n, components, true);
  for (int c = 0; c < components; c++) {
    for (int k = 0; k < n; k++) one.set(k, c, number(k, c));
    for (int k = 0; k < n; k += LANES)
      several.store(k, c, pack_of([&](int m) {
                      return number(k + m, c);
                    }));
    for (int k = 0; k < n; k += LANES) several.copy_to_rows(k, c, c + 1);
  }
  expect_numbers(one, n, components);
  expect_numbers(several, n, components);
  for (int k = 0; k < n; k++) {
    EXPECT_EQ(one.column(one.at(k)), k);
    EXPECT_EQ(several.get(k, 1), number(k, 1));
    for (int c = 0; c < components; c++) {
      EXPECT_EQ(one.row(k)[c], number(k, c));
      EXPECT_EQ(several.row(k)[c], number(k, c));
    }
  }
}

// a square lattice, 20 to a row, with 8 neighbors: as many slots, whether or not a row ends

TEST(Slots, OfALatticeLieSideBySide)
{
  for (int first : {42, 60 - LANES / 2}) {
    Lists lists;
    for (int m = 0; m < LANES; m++)
      for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++)
          if (x || y) lists[m].push_back(partner(first + m + x + 20 * y, true, x + 10 * y));
    const Arranged a = arranged(lists, first, 4);
    EXPECT_EQ(a.slots, 8);
    EXPECT_EQ(a.gathered, 0);
  }
}

// what is too far away for the number of doubles to it is gathered

TEST(Slots, TooFarAwayAreGathered)
{
  for (int further : {FURTHEST - 1, FURTHEST}) {
    Lists lists;
    for (int m = 0; m < LANES; m++) {
      lists[m].push_back(partner(m + 1, false, 1));
      lists[m].push_back(partner(m + further, false, 2));
    }
    const Arranged a = arranged(lists, 0, 4);
    EXPECT_EQ(a.slots, 2);
    EXPECT_EQ(a.gathered, further < FURTHEST ? 0 : 1);
  }
  // as many components as columns could have
  EXPECT_LT(60LL * FURTHEST * Columns::NEXT / Columns::LENGTH, GATHERED);
}

// partners anywhere: no more slots than pairs, nothing lost

TEST(Slots, OfAnythingAreComplete)
{
  Noise noise(3);
  for (int trial = 0; trial < 50; trial++) {
    Lists lists;
    int most = 0, all = 0;
    for (int m = 0; m < LANES; m++) {
      const int n = static_cast<int>(6.0 * (1.0 + noise()));
      for (int k = 0; k < n; k++)
        lists[m].push_back(partner(static_cast<int>(50.0 * noise()) + 100, noise() > 0.0,
                                   static_cast<int>(3.0 * noise())));
      std::sort(lists[m].begin(), lists[m].end(), comes_before);
      most = std::max(most, n);
      all += n;
    }
    for (int price : {2, 4}) {
      const Arranged a = arranged(lists, 96, price);
      EXPECT_GE(a.slots, most);
      EXPECT_LE(a.slots, all);
    }
  }
}

// a body and the same one whose particles are stored in another order.  On a lattice to the last
// bit: which partner comes first depends on where it lies

class ParticlesInAnyOrder : public testing::TestWithParam<Viscosity> {};

TEST_P(ParticlesInAnyOrder, AndOnAnyNumberOfThreads)
{
  for (int dim : {2, 3})
    for (double jitter : {0.0, 0.2}) {
      Cloud one = body(dim, 1, jitter), two = body(dim, 1, jitter);
      const int n = one.size();
      std::vector<int> at(n);
      std::iota(at.begin(), at.end(), 0);
      Noise noise(11);
      for (int i = n - 1; i > 0; i--)
        std::swap(at[i], at[static_cast<int>(0.5 * (noise() + 1.0) * i)]);
      deform(one, Matrix3d::Identity(), 0.1 * large(dim));
      one.stir(noise, 0.05);
      for (int i = 0; i < n; i++) {
        const int k = at[i];
        two.x[i] = one.x[k];
        two.v[i] = one.v[k];
        two.mass[i] = one.mass[k];
        two.volume[i] = one.volume[k];
        two.rho[i] = one.rho[k];
        two.e[i] = one.e[k];
        two.S[i] = one.S[k];
        two.xref[i] = one.xref[k];
        two.vref[i] = one.vref[k];
      }
      one.opt.viscosity = two.opt.viscosity = GetParam();
      one.opt.hourglass = two.opt.hourglass = 0.03;
      two.nthreads = 2;
      one.evaluate(0.01);
      two.evaluate(0.01);
      const std::vector<double> heat_one = one.heat(one.v), heat_two = two.heat(two.v);
      const double tolerance = jitter > 0.0 ? 1e-13 : 0.0;
      for (int i = 0; i < n; i++) {
        EXPECT_LE((two.f(i) - one.f(at[i])).norm(), tolerance);    // forces are of order 1
        EXPECT_LE(std::fabs(two.rho[i] - one.rho[at[i]]), tolerance);
        EXPECT_LE(std::fabs(heat_two[i] - heat_one[at[i]]), tolerance);
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Viscosities, ParticlesInAnyOrder, testing::ValuesIn(VISCOSITIES),
                         [](const testing::TestParamInfo<Viscosity> &info) {
                           return name_of(info.param);
                         });

// a lattice that is 1.3 % longer along y, h the square root of a particle's area: two spacings along x lie
// within two h, where the kernel's gradient is next to nothing, and are no partners

TEST(Partners, OnTheEdgeOfTheKernelAreNone)
{
  Cloud c = lattice(2, 7);
  c.opt.frame = Frame::LAGRANGIAN;
  c.opt.h = c.spacing;
  const double longer = std::sqrt(1.0127);
  for (Vector3d &x : c.x) x = Vector3d(x[0] / longer, x[1] * longer, 0.0);
  c.refer();
  c.evaluate();
  EXPECT_LT(2.0 / longer, 2.0);
  EXPECT_EQ(c.sweeps->neighbor_count(middle(c)), 8);
  EXPECT_EQ(c.sweeps->neighbor_count(0), 3);
}
