// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Edges of polygons: which edges of triangles they are, and which samples show them.
#include "CellArrays.h"
#include "CellEdgeFlags.h"
#include "DrawnTriangles.h"
#include "FilmPicture.h"
#include "RandomNumbers.h"
#include "ThreadedParallel.h"

#include <array>
#include <cmath>
#include <set>

using namespace lambent;

namespace
{
struct Cells : CellArrays
{
  std::vector<Vec3> points;

  /// Adds a polygon with new points.
  void addPolygon(const std::vector<Vec3>& corners)
  {
    std::vector<std::int64_t> ids;
    for (const Vec3& p : corners)
    {
      ids.push_back(static_cast<std::int64_t>(this->points.size()));
      this->points.push_back(p);
    }
    this->add(ids);
  }
  TupleSpan pointSpan() const { return { this->points.data(), true, this->points.size() }; }
  std::size_t size(std::size_t cell) const
  {
    return static_cast<std::size_t>(this->offsets[cell + 1] - this->offsets[cell]);
  }
  /// The k-th point of a cell, going round.
  std::int64_t id(std::size_t cell, std::size_t k) const
  {
    return this->connectivity[static_cast<std::size_t>(this->offsets[cell]) + k % this->size(cell)];
  }
};

/// A polygon around the origin, whose corners have distances in a range.
std::vector<Vec3> around(RandomNumbers& random, int count, double nearest)
{
  std::vector<Vec3> result;
  for (int k = 0; k < count; ++k)
  {
    const double angle = 2.0 * 3.14159265358979323846 * (k + random.within(0.0, 0.3)) / count;
    const double distance = random.within(nearest, 1.0);
    result.emplace_back(distance * std::cos(angle), distance * std::sin(angle), 0.0);
  }
  return result;
}

/// Expects the flags of all triangles by looking for each edge among those of the cell.
void expectOutlines(
  const Cells& cells, const TriangleList& list, const UnwrittenVector<unsigned char>& flags)
{
  ASSERT_EQ(flags.size(), list.cells.size());
  std::size_t marked = 0, edges = 0;
  for (std::size_t t = 0; t < flags.size(); ++t)
  {
    const auto cell = static_cast<std::size_t>(list.cells[t]);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::set<std::int64_t> edge{ list.corners[3 * t + k],
        list.corners[3 * t + (k + 1) % 3] };
      bool isOfCell = false;
      for (std::size_t i = 0; i < cells.size(cell); ++i)
      {
        isOfCell =
          isOfCell || std::set<std::int64_t>{ cells.id(cell, i), cells.id(cell, i + 1) } == edge;
      }
      EXPECT_EQ((flags[t] >> k & 1) != 0, isOfCell) << "triangle " << t << ", edge " << k;
      marked += isOfCell;
    }
  }
  for (std::size_t cell = 0; cell + 1 < cells.offsets.size(); ++cell)
  {
    edges += cells.size(cell) < 3 ? 0 : cells.size(cell);
  }
  EXPECT_EQ(marked, edges); // each edge of a cell is one of a triangle
}

/// A polygon with edges on the screen, and the lines of its edges.
struct Screen
{
  RandomScene random;
  Cells cells;
  TriangleList list;
  UnwrittenVector<unsigned char> flags;

  Screen(
    const std::vector<Vec3>& corners, double width, double scale, const Vec3& offset, bool parallel)
  {
    this->random.width = 61;
    this->random.height = 47;
    std::vector<Vec3> placed;
    for (const Vec3& p : corners)
    {
      placed.push_back(offset + p * scale);
    }
    this->cells.addPolygon(placed);
    this->list = triangulate(this->cells.span(), this->cells.pointSpan(), 0, Parallel());
    this->flags = findCellEdges(this->cells.span(), this->list, Parallel());
    Surface surface;
    surface.points = this->cells.pointSpan();
    surface.corners = { this->list.corners.data(), false, this->list.corners.size() };
    surface.cells = this->list.cells.data();
    surface.cellEdges = this->flags.data();
    surface.appearance.shading = Shading::Unlit;
    surface.appearance.edges.areVisible = true;
    surface.appearance.edges.width = width;
    this->random.scene.surfaces.push_back(surface);
    Camera& camera = this->random.scene.camera;
    camera.position = offset + Vec3(0.5, -0.25, 4.0) * scale;
    camera.focalPoint = offset;
    camera.parallel = parallel;
    camera.parallelScale = 1.05 * scale;
  }

  /// The squared distance of a pixel's centre to the outline, in pixels.
  long double squaredDistance(const CameraFrame& frame, int i, int j) const
  {
    long double least = 1e30L;
    const auto project = [&](std::int64_t id) -> std::array<long double, 2>
    {
      const FramePoint p = frame.toFrame(this->cells.points[static_cast<std::size_t>(id)]);
      return { static_cast<long double>(p.x) / p.w, static_cast<long double>(p.y) / p.w };
    };
    for (std::size_t k = 0; k < this->cells.size(0); ++k)
    {
      const auto a = project(this->cells.id(0, k)), b = project(this->cells.id(0, k + 1));
      const long double dx = b[0] - a[0], dy = b[1] - a[1];
      const long double px = frame.x(i) - a[0], py = frame.y(j) - a[1];
      const long double t =
        std::min(std::max((px * dx + py * dy) / (dx * dx + dy * dy), 0.0L), 1.0L);
      const long double ex = px - t * dx, ey = py - t * dy;
      least = std::min(least, ex * ex + ey * ey);
    }
    return least / frame.pixel / frame.pixel;
  }

  /// Expects edges exactly at the pixels that see the cell near its outline. Returns their number.
  int expectEdges(double width) const
  {
    const CameraFrame frame(this->random.scene.camera, this->random.width, this->random.height);
    const FilmPicture picture = makePicture(this->random, {}, whole(this->random), Settings());
    int count = 0;
    for (int j = 0; j < this->random.height; ++j)
    {
      for (int i = 0; i < this->random.width; ++i)
      {
        const auto pixel = static_cast<std::size_t>(j * this->random.width + i);
        const long double beyond = this->squaredDistance(frame, i, j) - 0.25L * width * width;
        if (picture.primitives[pixel] != noPrimitive && std::fabs(beyond) > 1e-6L)
        {
          EXPECT_EQ(picture.floats[3 * pixel], beyond < 0.0L ? 0.0f : 1.0f) << i << ", " << j;
          count += beyond < 0.0L ? 1 : 0;
        }
      }
    }
    return count;
  }
};
}

TEST(CellEdges, OfPolygonsAreTheirOutlines)
{
  RandomNumbers random(3);
  Cells cells;
  for (int k = 0; k < 1500; ++k)
  {
    cells.addPolygon(around(random, 3 + k % 40, k % 2 ? 0.1 : 1.0));
  }
  cells.add({ 0, 1 });
  cells.addPolygon(around(random, 5, 0.5));
  const TriangleList list = triangulate(cells.span(), cells.pointSpan(), 0, Parallel());
  expectOutlines(cells, list, findCellEdges(cells.span(), list, Parallel()));
  EXPECT_EQ(findCellEdges(cells.span(), list, ThreadedParallel(3)),
    findCellEdges(cells.span(), list, Parallel()));
}

// The outline goes to a hole and back.
TEST(CellEdges, OfPolygonsWithASlitIncludeIt)
{
  Cells cells;
  cells.points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 }, { 1, 1, 0 }, { 1, 2, 0 },
    { 2, 1, 0 } };
  cells.add({ 0, 1, 2, 3, 0, 4, 5, 6, 4 });
  const TriangleList list = triangulate(cells.span(), cells.pointSpan(), 0, Parallel());
  expectOutlines(cells, list, findCellEdges(cells.span(), list, Parallel()));
}

TEST(CellEdges, OfStripsAreAllOfTheirTriangles)
{
  RandomNumbers random(4);
  Cells cells;
  cells.addPolygon(around(random, 5, 1.0));
  CellArrays strips;
  strips.add({ 0, 1, 2, 3, 4 });
  const MergedFaces faces = mergeFaces(cells.span(), strips.span(), Parallel());
  const TriangleList list = triangulate(faces, cells.pointSpan(), 0, Parallel());
  const auto flags = findCellEdges(faces.span(), list, Parallel());
  ASSERT_EQ(flags.size(), 6u);
  EXPECT_EQ(int(flags[0] == 7) + int(flags[1] == 7) + int(flags[2] == 7), 0);
  EXPECT_EQ(std::vector<int>(flags.begin() + 3, flags.end()), std::vector<int>({ 7, 7, 7 }));
}

TEST(CellEdges, ArePickedAndMirroredWithTheirTriangles)
{
  const UnwrittenVector<unsigned char> all{ 1, 2, 4, 3, 6, 5, 7, 0 };
  UnwrittenVector<CellUse> uses(8, CellUse::Drawn);
  using List = std::vector<int>;
  const auto pick = [&](const UnwrittenVector<CellUse>& which, bool isMirrored)
  {
    const auto picked = DrawnTriangles(8, nullptr, 0, which, isMirrored, Parallel())
                          .pickEdges(all, ThreadedParallel(2));
    return List(picked.begin(), picked.end());
  };
  EXPECT_EQ(pick({}, true), List({ 4, 2, 1, 6, 3, 5, 7, 0 }));
  uses[0] = uses[3] = CellUse::None;
  uses[7] = CellUse::ForNormals;
  EXPECT_EQ(pick(uses, false), List({ 2, 4, 6, 5, 7 }));
  EXPECT_EQ(pick(uses, true), List({ 2, 1, 3, 5, 7 }));
}

// Where two edges meet at a corner, the pixels of other triangles show them, too.
TEST(CellEdges, HaveNoNotches)
{
  RandomNumbers random(5);
  for (int count = 3; count <= 12; ++count)
  {
    for (const bool parallel : { false, true })
    {
      for (const double width : { 0.75, 1.0, 4.0, 9.5 })
      {
        SCOPED_TRACE(count);
        const Screen screen(
          around(random, count, count % 2 ? 0.3 : 0.9), width, 1.0, Vec3(0.0), parallel);
        EXPECT_GT(screen.expectEdges(width), 10);
      }
    }
  }
}

TEST(CellEdges, AreNeverHiddenByTheirFacesAtAnyScale)
{
  RandomNumbers random(6);
  const std::vector<Vec3> corners = around(random, 7, 0.7);
  for (const double scale : { 1e-6, 1.0, 1e7 })
  {
    for (const bool parallel : { false, true })
    {
      SCOPED_TRACE(scale);
      EXPECT_GT(Screen(corners, 2.0, scale, Vec3(0.0), parallel).expectEdges(2.0), 100);
    }
  }
  for (const double scale : { 1.0, 1e7 })
  {
    EXPECT_GT(Screen(corners, 2.0, scale, Vec3(5e6), false).expectEdges(2.0), 100);
  }
}

// A pixel with n x n samples has lines of the same width.
TEST(CellEdges, HaveTheSameWidthWithSeveralSamples)
{
  const std::vector<Vec3> square{ { -9, -9, 0 }, { 0, -9, 0 }, { 0, 9, 0 }, { -9, 9, 0 } };
  for (const int samples : { 2, 4, 8 })
  {
    Screen screen(square, 6.0, 1.0, Vec3(0.0), true);
    screen.random.scene.camera.position = { 0.0, 0.0, 4.0 };
    screen.random.scene.camera.parallelScale = 23.5; // pixels are 1 wide
    FilmRequest request;
    request.samples = samples;
    const FilmPicture picture =
      makePicture(screen.random, request, whole(screen.random), Settings());
    const auto at = [&](std::size_t i) { return picture.floats[3 * (23 * 61 + i)]; };
    EXPECT_EQ(at(26), 1.0f); // x = -4
    EXPECT_EQ(at(27), 0.5f); // the line begins in the middle of a pixel
    EXPECT_EQ(at(28), 0.0f);
    EXPECT_EQ(at(29), 0.0f);
  }
}
