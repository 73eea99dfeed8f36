// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellArrays.h"
#include "CellSizes.h"
#include "RandomNumbers.h"
#include "ThreadedParallel.h"
#include "Triangulation.h"

#include <gtest/gtest.h>

using namespace lambent;

namespace
{
/// Cells and points, with the memory of their spans.
struct Cells : CellArrays
{
  std::vector<Vec3> points;

  TupleSpan pointSpan() const { return { this->points.data(), true, this->points.size() }; }

  TriangleList cut(std::int64_t firstCell = 0, const Parallel& p = Parallel()) const
  {
    return triangulate(this->span(), this->pointSpan(), firstCell, p);
  }
  /// The same cells as strips, after the polygons.
  TriangleList cutStrips(
    const CellSpan& polygons, std::int64_t firstCell = 0, const Parallel& p = Parallel()) const
  {
    return triangulate(mergeFaces(polygons, this->span(), p), this->pointSpan(), firstCell, p);
  }
};

/// The points of a plane polygon, numbered from 0, as one cell.
Cells makePolygon(const std::vector<Vec3>& points)
{
  Cells cells;
  std::vector<std::int64_t> ids;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    ids.push_back(static_cast<std::int64_t>(k));
  }
  cells.points = points;
  cells.add(ids);
  return cells;
}

double area(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal)
{
  return 0.5 * dot(cross(b - a, c - a), normal);
}

UnwrittenVector<std::int32_t> corners(std::initializer_list<std::int32_t> ids)
{
  return ids;
}
}

TEST(Triangulation, ConvexPolygonsAreFans)
{
  Cells cells = makePolygon({ { 0, 0, 0 }, { 2, 0, 0 }, { 3, 1, 0 }, { 2, 2, 0 }, { 0, 2, 0 } });
  cells.add({ 2, 3, 4 });
  const TriangleList list = cells.cut(10);
  EXPECT_EQ(list.corners, corners({ 0, 1, 2, 0, 2, 3, 0, 3, 4, 2, 3, 4 }));
  EXPECT_EQ(list.cells, (UnwrittenVector<std::int64_t>{ 10, 10, 10, 11 }));
}

TEST(Triangulation, StripsAlternate)
{
  Cells cells = makePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 2, 0 } });
  const TriangleList list = cells.cutStrips(CellSpan(), 3);
  EXPECT_EQ(list.corners, corners({ 0, 1, 2, 2, 1, 3, 2, 3, 4 }));
  EXPECT_EQ(list.cells, (UnwrittenVector<std::int64_t>{ 3, 3, 3 }));
}

// Stars with teeth of random depth, in a tilted plane, seen from either side.
TEST(Triangulation, ConcavePolygonsAreCoveredExactlyOnce)
{
  RandomNumbers random(5);
  const Vec3 u = normalized(Vec3(1.0, 2.0, 0.5)), v = normalized(cross(u, Vec3(0.3, -1.0, 2.0)));
  const Vec3 normal = cross(u, v);
  for (int k = 0; k < 500; ++k)
  {
    const int size = 4 + random.below(30);
    const bool isTurned = random.below(2) != 0;
    std::vector<Vec3> points;
    for (int p = 0; p < size; ++p)
    {
      const double angle = (isTurned ? -1.0 : 1.0) * 6.283185307179586 * p / size;
      const double radius = random.within(0.2, 2.0);
      points.push_back(u * (radius * std::cos(angle)) + v * (radius * std::sin(angle)));
    }
    double whole = 0.0;
    for (int p = 0; p < size; ++p)
    {
      whole += area(Vec3(0.0), points[p], points[(p + 1) % size], normal);
    }
    const TriangleList list = makePolygon(points).cut();
    ASSERT_EQ(list.cells.size(), size - 2u);
    double sum = 0.0;
    for (std::size_t t = 0; t < list.cells.size(); ++t)
    {
      const double part = area(points[list.corners[3 * t]], points[list.corners[3 * t + 1]],
        points[list.corners[3 * t + 2]], normal);
      EXPECT_GE(isTurned ? -part : part, -1e-12); // all have the polygon's orientation
      sum += part;
    }
    EXPECT_NEAR(sum, whole, 1e-10);
  }
}

// A polygon of n points gives n - 2 triangles, whatever its shape.
TEST(Triangulation, DegenerateShapesKeepTheirTriangleCount)
{
  const std::vector<std::vector<Vec3>> shapes{
    { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } },                // crosses itself
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } },                // collinear
    { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } },   // a point
    { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 1, 0.5, 0 } }, // a repeated point
    { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 }, { 0, 0, 0 }, { 1, 1, 0 }, { 1, 3, 0 },
      { 3, 3, 0 }, { 3, 1, 0 }, { 1, 1, 0 } } // a hole, connected by a bridge
  };
  for (const auto& shape : shapes)
  {
    const TriangleList list = makePolygon(shape).cut();
    EXPECT_EQ(list.cells.size(), shape.size() - 2);
    EXPECT_EQ(list.corners.size(), 3 * list.cells.size());
    for (std::int32_t id : list.corners)
    {
      EXPECT_TRUE(id >= 0 && id < static_cast<std::int32_t>(shape.size()));
    }
  }
}

TEST(Triangulation, AHoleStaysOpen)
{
  const std::vector<Vec3> shape{ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 }, { 0, 0, 0 },
    { 1, 1, 0 }, { 1, 3, 0 }, { 3, 3, 0 }, { 3, 1, 0 }, { 1, 1, 0 } };
  const TriangleList list = makePolygon(shape).cut();
  double sum = 0.0;
  for (std::size_t t = 0; t < list.cells.size(); ++t)
  {
    sum += std::fabs(area(shape[list.corners[3 * t]], shape[list.corners[3 * t + 1]],
      shape[list.corners[3 * t + 2]], Vec3(0.0, 0.0, 1.0)));
  }
  EXPECT_NEAR(sum, 12.0, 1e-12);
}

TEST(Triangulation, CellsWithFewerThanThreePointsGiveNothing)
{
  Cells cells = makePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  cells.add({});
  cells.add({ 1 });
  cells.add({ 1, 2 });
  cells.add({ 2, 1, 0 });
  const TriangleList list = cells.cut();
  EXPECT_EQ(list.corners, corners({ 0, 1, 2, 2, 1, 0 }));
  EXPECT_EQ(list.cells, (UnwrittenVector<std::int64_t>{ 0, 4 }));
}

// Bad points are reported where triangles are streamed. Here their cells only keep the number of
// triangles.
TEST(Triangulation, BadPointsReplaceAllCornersOfTheirCell)
{
  Cells cells;
  cells.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
    { std::numeric_limits<double>::infinity(), 0, 0 } };
  cells.add({ 0, 1, 2, 4 });
  cells.add({ 0, 1, -7, 2 });
  cells.add({ 0, 3, 1, 2 });
  EXPECT_EQ(cells.cut().corners,
    corners({ -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 3, 3, 3, 3, 3, 3 }));
  EXPECT_EQ(cells.cutStrips(CellSpan()).corners, cells.cut().corners);
  cells = Cells();
  cells.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 },
    { std::numeric_limits<double>::infinity(), 0, 0 } };
  cells.add({ 0, 1, 2, 3 });
  cells.add({ 0, 1, 2, 4 }); // the first of its triangles is good, the second is not
  cells.add({ 0, 1, 4, 2, 9 });
  EXPECT_EQ(cells.cutStrips(CellSpan()).corners,
    corners({ 0, 1, 2, 2, 1, 3, 4, 4, 4, 4, 4, 4, -1, -1, -1, -1, -1, -1, -1, -1, -1 }));
}

TEST(Triangulation, DoesNotDependOnThreads)
{
  RandomNumbers random(6);
  Cells cells;
  for (int k = 0; k < 1000; ++k)
  {
    cells.points.push_back(random.inBox(1.0));
  }
  for (int k = 0; k < 5000; ++k)
  {
    std::vector<std::int64_t> ids(random.below(8));
    for (std::int64_t& id : ids)
    {
      id = random.below(1000);
    }
    cells.add(ids);
  }
  const TriangleList once = cells.cut(100);
  const TriangleList strips = cells.cutStrips(CellSpan(), 100);
  for (int threads : { 2, 3, 8 })
  {
    const ThreadedParallel parallel(threads);
    const TriangleList list = cells.cut(100, parallel);
    EXPECT_EQ(list.corners, once.corners);
    EXPECT_EQ(list.cells, once.cells);
    const TriangleList stripList = cells.cutStrips(CellSpan(), 100, parallel);
    EXPECT_EQ(stripList.corners, strips.corners);
    EXPECT_EQ(stripList.cells, strips.cells);
    // Polygons come first; strips continue the numbering.
    TriangleList both = cells.cutStrips(cells.span(), 100, parallel);
    const std::size_t polygons = once.cells.size();
    EXPECT_TRUE(std::equal(once.corners.begin(), once.corners.end(), both.corners.begin()));
    EXPECT_TRUE(std::equal(once.cells.begin(), once.cells.end(), both.cells.begin()));
    both.corners.erase(both.corners.begin(), both.corners.begin() + 3 * polygons);
    both.cells.erase(both.cells.begin(), both.cells.begin() + polygons);
    EXPECT_EQ(both.corners, strips.corners);
    for (std::int64_t& cell : both.cells)
    {
      cell -= 5000;
    }
    EXPECT_EQ(both.cells, strips.cells);
  }
}

TEST(Triangulation, CellSizesAreClassified)
{
  Cells cells;
  const Parallel parallel;
  EXPECT_EQ(inspect(CellSpan(), parallel), CellSizes::Triangles);
  EXPECT_EQ(inspect(cells.span(), parallel), CellSizes::Triangles);
  for (int k = 0; k < 3000; ++k)
  {
    cells.add({ 0, 1, 2 });
  }
  EXPECT_EQ(inspect(cells.span(), parallel), CellSizes::Triangles);
  cells.offsets[2500] -= 1;
  EXPECT_EQ(inspect(cells.span(), ThreadedParallel(3)), CellSizes::Mixed);
  cells.offsets[2500] -= 3;
  EXPECT_EQ(inspect(cells.span(), ThreadedParallel(3)), CellSizes::Broken); // they decrease
  cells.offsets[2500] += 4;
  cells.offsets.back() += 1;
  EXPECT_EQ(inspect(cells.span(), ThreadedParallel(3)), CellSizes::Broken); // beyond the end
  cells.offsets.back() -= 1;
  cells.offsets.front() = -3;
  EXPECT_EQ(inspect(cells.span(), ThreadedParallel(3)), CellSizes::Broken); // before the start
}
