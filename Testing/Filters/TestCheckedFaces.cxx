// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Polygons and strips as one list of faces: its contents, the first wrong cell, and the marks of
// faces that are not finite.
#include "CheckedFaces.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <utility>

using namespace lambent;

namespace
{
/// A list of cells, with the memory of its span.
struct List
{
  std::vector<std::int64_t> offsets{ 0 }, corners;

  List(std::initializer_list<std::vector<std::int64_t>> cells)
  {
    for (const auto& cell : cells)
    {
      this->corners.insert(this->corners.end(), cell.begin(), cell.end());
      this->offsets.push_back(static_cast<std::int64_t>(this->corners.size()));
    }
  }
  CellSpan span() const
  {
    return { { this->offsets.data(), true, this->offsets.size() },
      { this->corners.data(), true, this->corners.size() } };
  }
};

/// Six points; the last is not finite.
const std::vector<double> coordinates{ 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2,
  std::numeric_limits<double>::quiet_NaN() };
const TupleSpan points{ coordinates.data(), true, 6 };

CheckedFaces check(const List& polygons, const List& strips, MergedFaces merged = MergedFaces())
{
  return checkFaces(points, polygons.span(), strips.span(), Parallel(), std::move(merged));
}

std::vector<std::vector<std::int64_t>> facesOf(const CheckedFaces& checked)
{
  const CellSpan& cells = checked.faces.cells;
  std::vector<std::vector<std::int64_t>> result(cellCount(cells));
  for (std::size_t face = 0; face < result.size(); ++face)
  {
    for (std::size_t k = cells.offsets[face]; k < cells.offsets[face + 1]; ++k)
    {
      result[face].push_back(static_cast<std::int64_t>(cells.connectivity[k]));
    }
  }
  return result;
}

using CellList = std::vector<std::vector<std::int64_t>>;
}

TEST(CheckedFaces, PolygonsWithoutStripsAreUsedInPlace)
{
  const List polygons{ { 0, 1, 3, 2 }, { 2, 3, 4 } };
  const CheckedFaces checked = check(polygons, {});
  EXPECT_FALSE(checked.defect);
  EXPECT_TRUE(checked.merged.isEmpty());
  EXPECT_EQ(checked.faces.cells.connectivity.data, polygons.corners.data());
  EXPECT_EQ(checked.cellOf(1), 1);
  EXPECT_TRUE(checked.faces.skip.empty());
  ASSERT_EQ(checked.faces.blocks.size(), 1u);
  EXPECT_EQ(checked.faces.blocks[0].end, 2u);
  EXPECT_EQ(checked.faces.blocks[0].lastPoint, 4);
}

TEST(CheckedFaces, StripsFollowThePolygons)
{
  const List polygons{ { 2, 3, 4 } }, strips{ { 0, 1 }, { 0, 1, 2, 3, 4 } };
  const CheckedFaces checked = check(polygons, strips);
  EXPECT_EQ(facesOf(checked), (CellList{ { 2, 3, 4 }, { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 } }));
  EXPECT_EQ(checked.cellOf(0), 0);
  EXPECT_EQ(checked.cellOf(1), 2);
  EXPECT_EQ(checked.cellOf(3), 2);
  ASSERT_EQ(checked.faces.blocks.size(), 1u);
  EXPECT_EQ(checked.faces.blocks[0].end, 4u);
  EXPECT_EQ(checked.faces.blocks[0].firstPoint, 0);

  // The result is the same if the faces have been merged before.
  const CheckedFaces again =
    check(polygons, strips, mergeFaces(polygons.span(), strips.span(), Parallel()));
  EXPECT_EQ(facesOf(again), facesOf(checked));
  EXPECT_EQ(again.faces.blocks.size(), 1u);
}

TEST(CheckedFaces, TheFirstWrongCellIsFound)
{
  const auto defectOf = [](const List& polygons, const List& strips)
  { return check(polygons, strips).defect; };
  CellDefect defect = defectOf({ { 0, 1, 2 }, { 0, 6, 2 } }, { { 0, 1, 7 } });
  EXPECT_EQ(defect.kind, CellDefect::Point);
  EXPECT_EQ(defect.cell, 1u);
  EXPECT_EQ(defect.point, 6);
  defect = defectOf({ { 0, 1, 2 }, { 0, 1, 2 } }, { { 0, 1, 2 }, { 0, -1 } });
  EXPECT_EQ(defect.kind, CellDefect::Point);
  EXPECT_EQ(defect.cell, 3u);
  EXPECT_EQ(defect.point, -1);
  List broken{ { 0, 1, 2 } };
  broken.offsets[1] = 4;
  EXPECT_EQ(defectOf(broken, {}).kind, CellDefect::Offsets);
  EXPECT_EQ(defectOf({}, broken).kind, CellDefect::Offsets);
}

// All triangles of a strip are marked, also those with only finite points.
TEST(CheckedFaces, FacesOfNonFiniteCellsAreMarked)
{
  const CheckedFaces checked =
    check({ { 0, 1, 2 }, { 0, 1, 5 } }, { { 0, 1, 2, 3 }, { 0, 1, 2, 5 } });
  EXPECT_EQ(checked.notFinite, 2u);
  EXPECT_EQ(checked.firstNotFinite, 1u);
  EXPECT_EQ(checked.faces.skip, (std::vector<unsigned char>{ 0, 1, 0, 0, 1, 1 }));
  EXPECT_EQ(check({ { 0, 1, 2 } }, { { 0, 1, 5 } }).firstNotFinite, 1u);
  EXPECT_EQ(check({ { 0, 1, 2 } }, { { 0, 1, 2 } }).notFinite, 0u);
}
