// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Polygons whose outlines touch themselves: the triangles must cover each place that the outline
// encloses exactly once, and nothing else.
#include "RandomOutlines.h"
#include "Triangulation.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace lambent;

namespace
{
struct Plane
{
  Vec3 origin, u, v;

  Vec3 at(const PlanePoint& p) const { return this->origin + this->u * p.x + this->v * p.y; }
};

/// Three planes in which an outline's coordinates are exact, and two in which they are not.
Plane makePlane(int kind, RandomNumbers& random)
{
  switch (kind)
  {
    case 0:
      return { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
    case 1:
      return { { 0, 0, 3 }, { 0, 0, 1 }, { 0, -1, 0 } };
    case 2:
      return { { 100, 200, 300 }, { 1, 2, 3 }, { -1, 1, 2 } };
    default:
      const Vec3 u = normalized(random.inBox(1.0));
      return { random.inBox(kind == 3 ? 3.0 : 1e6), u, normalized(cross(u, random.inBox(1.0))) };
  }
}

std::vector<std::int32_t> cut(const Outline& outline, const Plane& plane, bool isDouble)
{
  const std::vector<std::int64_t> ids(outline.ids.begin(), outline.ids.end());
  const std::vector<std::int64_t> offsets{ 0, static_cast<std::int64_t>(ids.size()) };
  std::vector<double> doubles(3 * outline.idCount);
  for (std::size_t k = 0; k < outline.size(); ++k)
  {
    const Vec3 p = plane.at(outline.corners[k]);
    std::copy(&p.x, &p.x + 3, doubles.begin() + 3 * outline.ids[k]);
  }
  const std::vector<float> floats(doubles.begin(), doubles.end());
  const auto count = static_cast<std::size_t>(outline.idCount);
  const CellSpan polygon{ { offsets.data(), true, 2 }, { ids.data(), true, ids.size() } };
  const auto corners = triangulate(polygon,
    isDouble ? TupleSpan{ doubles.data(), true, count } : TupleSpan{ floats.data(), false, count },
    0, Parallel())
                         .corners;
  return { corners.begin(), corners.end() };
}

/// The positions of the triangles' corners in the plane, three for each triangle.
std::vector<PlanePoint> place(const Outline& outline, const std::vector<std::int32_t>& triangles)
{
  std::vector<PlanePoint> points(outline.idCount), placed;
  for (std::size_t k = 0; k < outline.size(); ++k)
  {
    points[outline.ids[k]] = outline.corners[k];
  }
  for (std::int32_t id : triangles)
  {
    placed.push_back(points[id]);
  }
  return placed;
}

/// The number of triangles that contain a point, or -1 if it is too close to an edge to decide.
int countOver(const std::vector<PlanePoint>& triangles, const PlanePoint& p)
{
  int count = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    const double a = cross(triangles[t], triangles[t + 1], p);
    const double b = cross(triangles[t + 1], triangles[t + 2], p);
    const double c = cross(triangles[t + 2], triangles[t], p);
    if (std::fabs(a) < 1e-6 || std::fabs(b) < 1e-6 || std::fabs(c) < 1e-6)
    {
      return -1;
    }
    count += (a > 0.0) == (b > 0.0) && (b > 0.0) == (c > 0.0) ? 1 : 0;
  }
  return count;
}

void expectCovered(const Outline& outline, const Plane& plane, bool isDouble, RandomNumbers& random)
{
  const std::vector<std::int32_t> corners = cut(outline, plane, isDouble);
  ASSERT_EQ(corners.size(), 3 * (outline.size() - 2));
  const std::vector<PlanePoint> triangles = place(outline, corners);
  double area = 0.0;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    area += 0.5 * std::fabs(cross(triangles[t], triangles[t + 1], triangles[t + 2]));
  }
  EXPECT_NEAR(area, std::fabs(outline.area()), isDouble ? 1e-7 : 1e-4);
  for (int k = 0; k < 40; ++k)
  {
    const double x = random.within(-2.2, 2.2);
    const PlanePoint p{ x, random.within(-2.2, 2.2) };
    const int count = countOver(triangles, p);
    EXPECT_TRUE(count < 0 || count == std::abs(outline.winding(p)))
      << count << " triangles over " << p.x << ", " << p.y;
  }
}

using Change = void (*)(Outline&, RandomNumbers&);

void expectCovered(unsigned int seed, const std::vector<Change>& changes)
{
  RandomNumbers random(seed);
  for (int n = 0; n < 1500 && !testing::Test::HasFailure(); ++n)
  {
    Outline outline =
      n % 2 != 0 ? makeStar(random, 3 + random.below(14)) : makeMaze(random, 4 + random.below(10));
    for (Change change : changes)
    {
      change(outline, random);
    }
    turnRound(outline, random);
    const int kind = n % 5;
    expectCovered(outline, makePlane(kind, random), kind != 3 || random.below(2) != 0, random);
    std::string text;
    for (std::size_t k = 0; testing::Test::HasFailure() && k < outline.size(); ++k)
    {
      text += " (" + std::to_string(outline.corners[k].x) + ", " +
        std::to_string(outline.corners[k].y) + ") of id " + std::to_string(outline.ids[k]);
    }
    EXPECT_EQ(text, "") << "outline " << n << " in plane " << kind;
  }
}

std::vector<std::int32_t> cutInPlane(
  const std::vector<PlanePoint>& corners, const std::vector<int>& ids)
{
  Outline outline;
  outline.corners = corners;
  outline.ids = ids;
  outline.idCount = *std::max_element(ids.begin(), ids.end()) + 1;
  return cut(outline, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, true);
}

/// The definition for outlines that do not touch themselves: a fan, or the first ear repeatedly.
std::vector<std::int32_t> cutSimple(const Outline& outline)
{
  std::vector<PlanePoint> left = outline.corners;
  std::vector<std::int32_t> ids(outline.ids.begin(), outline.ids.end()), triangles;
  const double side = outline.area() > 0.0 ? 1.0 : -1.0;
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c)
  { return side * cross(left[a % left.size()], left[b % left.size()], left[c % left.size()]); };
  const auto isEar = [&](std::size_t k)
  {
    const std::size_t n = left.size(), a = k + n - 1, c = k + 1;
    bool isFree = turn(a, k, c) > 0.0;
    for (std::size_t p = 2; p < n - 1; ++p)
    {
      isFree = isFree &&
        !(turn(a, k, k + p) >= 0.0 && turn(k, c, k + p) >= 0.0 && turn(c, a, k + p) >= 0.0);
    }
    return isFree;
  };
  bool isConvex = true;
  for (std::size_t k = 0; k < left.size(); ++k)
  {
    isConvex = isConvex && turn(k + left.size() - 1, k, k + 1) >= 0.0;
  }
  while (left.size() > 3 && !isConvex)
  {
    std::size_t k = 0;
    while (k < left.size() && !isEar(k))
    {
      ++k;
    }
    const std::size_t n = left.size();
    triangles.insert(triangles.end(), { ids[(k + n - 1) % n], ids[k % n], ids[(k + 1) % n] });
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
    ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(k));
  }
  for (std::size_t k = 2; k < left.size(); ++k)
  {
    triangles.insert(triangles.end(), { ids[0], ids[k - 1], ids[k] });
  }
  return triangles;
}
}

TEST(TouchingPolygons, SimpleOutlinesKeepTheirTriangles)
{
  RandomNumbers random(101);
  for (int n = 0; n < 4000; ++n)
  {
    Outline outline =
      n % 2 != 0 ? makeStar(random, 3 + random.below(25)) : makeMaze(random, 4 + random.below(12));
    for (int k = random.below(4); k > 0; --k)
    {
      splitEdge(outline, random);
    }
    turnRound(outline, random);
    for (int plane = 0; plane < 2; ++plane)
    {
      EXPECT_EQ(cut(outline, makePlane(plane, random), true), cutSimple(outline));
    }
  }
}

TEST(TouchingPolygons, SimpleOutlinesAreCovered)
{
  expectCovered(102, { splitEdge, splitEdge });
}

TEST(TouchingPolygons, DoubledCornersAreCovered)
{
  expectCovered(103, { doubleCorner });
  expectCovered(104, { doubleCorner, doubleCorner, splitEdge, doubleCorner });
}

TEST(TouchingPolygons, SpikesAreCovered)
{
  expectCovered(105, { addSpike });
  expectCovered(106, { addSpike, addDetour, addSpike, splitEdge, addSpike });
}

TEST(TouchingPolygons, HolesAreLeftOpen)
{
  expectCovered(107, { addHole });
  expectCovered(108, { addHole, addHole, splitEdge, addHole });
  expectCovered(109, { addTouchingHole, addHole, addTouchingHole });
}

TEST(TouchingPolygons, CombinationsAreCovered)
{
  expectCovered(110,
    { splitEdge, splitEdge, addHole, addTouchingHole, addSpike, addHole, addDetour, doubleCorner,
      doubleCorner });
}

TEST(TouchingPolygons, AnArrowWithADoubledNotchKeepsItsNotch)
{
  const std::vector<PlanePoint> arrow{ { 40.1, 20.2 }, { -7.3, 8.4 }, { 5.2, -38.1 },
    { 10.3, -0.2 }, { 10.3, -0.2 } };
  for (int last : { 3, 4 }) // the same point, or another one at its position
  {
    double area = 0.0;
    const std::vector<std::int32_t> triangles = cutInPlane(arrow, { 0, 1, 2, 3, last });
    ASSERT_EQ(triangles.size(), 9u);
    for (std::size_t t = 0; t < triangles.size(); t += 3)
    {
      area += 0.5 *
        std::fabs(cross(arrow[triangles[t]], arrow[triangles[t + 1]], arrow[triangles[t + 2]]));
    }
    EXPECT_NEAR(area, 663.11, 1e-9);
  }
}

// A fan is right for them, as for the outline without the doubled corner.
TEST(TouchingPolygons, ConvexPolygonsWithADoubledCornerStayFans)
{
  EXPECT_EQ(cutInPlane({ { 0, 0 }, { 2, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } }, { 0, 1, 1, 2, 3 }),
    (std::vector<std::int32_t>{ 0, 1, 1, 0, 1, 2, 0, 2, 3 }));
}

// No triangles are right for these; they keep the fan or the ears that they had before.
TEST(TouchingPolygons, OutlinesThatCrossThemselvesKeepTheirTriangles)
{
  EXPECT_EQ(cutInPlane({ { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 1 } }, { 0, 1, 2, 3 }),
    (std::vector<std::int32_t>{ 0, 1, 2, 0, 2, 3 }));
  EXPECT_EQ(
    cutInPlane({ { 0, 2 }, { -1.5, -2 }, { 2, 0.5 }, { -2, 0.5 }, { 1.5, -2 } }, { 0, 1, 2, 3, 4 }),
    (std::vector<std::int32_t>{ 0, 1, 2, 0, 2, 3, 0, 3, 4 }));
}

// It crosses itself when seen along its normal, but not when seen along an axis.
TEST(TouchingPolygons, BentOutlinesThatCrossThemselvesKeepTheirTriangles)
{
  const std::vector<Vec3> points{ { -4, 1, 1 }, { 4, -3, 1 }, { 4, 2, -1 }, { -4, -3, 0 } };
  const std::vector<std::int64_t> ids{ 0, 1, 2, 3 }, offsets{ 0, 4 };
  const CellSpan polygon{ { offsets.data(), true, 2 }, { ids.data(), true, 4 } };
  EXPECT_EQ(triangulate(polygon, { points.data(), true, 4 }, 0, Parallel()).corners,
    (UnwrittenVector<std::int32_t>{ 0, 1, 2, 0, 2, 3 }));
}

// Near four million, floats are half a unit apart; whole units are still distinct.
TEST(TouchingPolygons, LargeIntegerCoordinatesAreExact)
{
  Outline arrow;
  arrow.corners = { { 40, 20 }, { -7, 8 }, { 5, -38 }, { 10, 0 }, { 10, 0 } };
  arrow.ids = { 0, 1, 2, 3, 4 };
  arrow.idCount = 5;
  RandomNumbers random(112);
  expectCovered(arrow, { { 4194304, 4194304, 4194304 }, { 1, 0, 0 }, { 0, 1, 0 } }, false, random);
}

TEST(TouchingPolygons, OutlinesWithoutAreaKeepTheirTriangleCount)
{
  const std::vector<std::vector<PlanePoint>> outlines{
    { { 1, 1 }, { 1, 1 }, { 1, 1 }, { 1, 1 }, { 1, 1 }, { 1, 1 } },     // a point
    { { 0, 0 }, { 1, 2 }, { 3, 6 }, { 3, 6 }, { 2, 4 }, { 0, 0 } },     // there and back
    { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 1, 0 }, { 0, 0 }, { 0, -1 } },    // a tree
    { { 0, 0 }, { 1, 1 }, { 1, -1 }, { 0, 0 }, { -1, 1 }, { -1, -1 } }, // a figure of eight
    { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, 0 }, { 0, 1 }, { 1, 0 } }      // once in each orientation
  };
  for (const std::vector<PlanePoint>& outline : outlines)
  {
    for (int kind = 0; kind < 5; ++kind)
    {
      RandomNumbers random(111);
      Outline whole;
      for (const PlanePoint& corner : outline)
      {
        whole.insert(whole.size(), corner);
      }
      const std::vector<std::int32_t> triangles = cut(whole, makePlane(kind, random), true);
      ASSERT_EQ(triangles.size(), 12u);
      for (std::int32_t id : triangles)
      {
        EXPECT_TRUE(id >= 0 && id < 6);
      }
    }
  }
}

// Triangulation also ends for polygons too large or too small for products of lengths.
TEST(TouchingPolygons, EndsForCoordinatesOfAnySize)
{
  for (double size : { 1e-300, 1e-160, 1e-50, 1e50, 1e150, 1e308 })
  {
    const auto at = [size](double x, double y) { return PlanePoint{ size * x, size * y }; };
    EXPECT_EQ(cutInPlane({ at(1, 0.5), at(-0.2, 0.2), at(0.1, -1), at(0.25, 0), at(0.25, 0) },
                { 0, 1, 2, 3, 3 })
                .size(),
      9u);
  }
}
