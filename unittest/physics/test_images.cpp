/* ----------------------------------------------------------------------
   Mirror images in one, two and three planes.
------------------------------------------------------------------------- */

#include "sph_solid_images.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

using namespace SPHSolid;

namespace {

using Point = std::array<double, 3>;

// all images of some points as a sorted set of positions

std::multiset<Point> images_of(
    const std::vector<Plane> &planes, std::vector<Point> points, double reach,
    bool (*has_images)(const Point &) = [](const Point &) {
      return true;
    })
{
  std::vector<const double *> x;
  for (auto &p : points) x.push_back(p.data());
  Images images;
  images.set_planes(planes);
  images.find(static_cast<int>(points.size()), x.data(), reach, [&](int i) {
    return has_images(points[i]);
  });
  std::multiset<Point> out;
  for (int k = 0; k < images.count(); k++) {
    Point at;
    images.position<3>(k, x[images.source_of(k)], at.data());
    out.insert(at);
  }
  return out;
}

}    // namespace

TEST(Images, NoneWithoutPlanes)
{
  Images images;
  EXPECT_FALSE(images.any());
}

TEST(Images, PositionInOnePlane)
{
  EXPECT_EQ(images_of({{1, 2.0}}, {{5.0, 2.5, 7.0}}, 1.0), (std::multiset<Point>{{5.0, 1.5, 7.0}}));
}

// either side of the plane is the body

TEST(Images, PositionFromBelow)
{
  EXPECT_EQ(images_of({{0, 2.0}}, {{1.25, 0.0, 0.0}}, 1.0),
            (std::multiset<Point>{{2.75, 0.0, 0.0}}));
}

TEST(Images, OnPlaneCoincides)
{
  EXPECT_EQ(images_of({{2, 3.0}}, {{1.0, 2.0, 3.0}}, 1.0), (std::multiset<Point>{{1.0, 2.0, 3.0}}));
}

TEST(Images, OnlyOfThoseThatHaveAny)
{
  EXPECT_EQ(images_of({{0, 0.0}}, {{0.5, 1.0, 0.0}, {0.5, 2.0, 0.0}}, 1.0,
                      [](const Point &p) {
                        return p[1] > 1.5;
                      }),
            (std::multiset<Point>{{-0.5, 2.0, 0.0}}));
}

TEST(Images, NoneBeyondReach)
{
  EXPECT_TRUE(images_of({{0, 0.0}}, {{1.5, 0.0, 0.0}, {-1.5, 0.0, 0.0}}, 1.0).empty());
}

// a quarter model: two images and the image of images

TEST(Images, TwoPlanes)
{
  EXPECT_EQ(images_of({{0, 0.0}, {1, 0.0}}, {{0.5, 0.25, 0.0}}, 1.0),
            (std::multiset<Point>{{-0.5, 0.25, 0.0}, {0.5, -0.25, 0.0}, {-0.5, -0.25, 0.0}}));
}

// near one of two planes only: one image

TEST(Images, TwoPlanesNearOne)
{
  EXPECT_EQ(images_of({{0, 0.0}, {1, 0.0}}, {{0.5, 2.0, 0.0}}, 1.0),
            (std::multiset<Point>{{-0.5, 2.0, 0.0}}));
}

// an eighth model: all other corners of the box around the planes' common point

TEST(Images, ThreePlanes)
{
  std::multiset<Point> corners;
  for (double x : {-0.5, 0.5})
    for (double y : {-0.25, 0.25})
      for (double z : {-0.75, 0.75})
        if (x < 0.0 || y < 0.0 || z < 0.0) corners.insert({x, y, z});
  EXPECT_EQ(images_of({{0, 0.0}, {1, 0.0}, {2, 0.0}}, {{0.5, 0.25, 0.75}}, 1.0), corners);
}

// a channel: each plane its own image, no image of images through both

TEST(Images, ParallelPlanes)
{
  EXPECT_EQ(images_of({{0, 0.0}, {0, 10.0}}, {{0.5, 0.0, 0.0}, {9.5, 0.0, 0.0}}, 1.0),
            (std::multiset<Point>{{-0.5, 0.0, 0.0}, {10.5, 0.0, 0.0}}));
}

// a vector turns over in each plane's normal

TEST(Images, Signs)
{
  const double x[3] = {0.5, 0.5, 0.5};
  const double *all[1] = {x};
  Images images;
  images.set_planes({{0, 0.0}, {2, 0.0}});
  images.find(1, all, 1.0, [](int) {
    return true;
  });
  ASSERT_EQ(images.count(), 3);
  for (int k = 0; k < 3; k++) {
    double at[3], sign[3];
    images.position<3>(k, x, at);
    images.signs(k, sign);
    for (int a = 0; a < 3; a++) EXPECT_EQ(sign[a], at[a] / x[a]);
  }
}

// images are listed by particle

TEST(Images, RangesByParticle)
{
  const double near[3] = {0.5, 0, 0}, far[3] = {5.0, 0, 0}, other[3] = {0.25, 0, 0};
  const double *all[3] = {near, far, other};
  Images images;
  images.set_planes({{0, 0.0}});
  images.find(3, all, 1.0, [](int) {
    return true;
  });
  EXPECT_EQ(images.first_of(1) - images.first_of(0), 1);
  EXPECT_EQ(images.first_of(2) - images.first_of(1), 0);
  EXPECT_EQ(images.first_of(3) - images.first_of(2), 1);
  EXPECT_EQ(images.source_of(images.first_of(2)), 2);
}
