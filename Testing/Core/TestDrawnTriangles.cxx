// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnTriangles.h"

#include "CellArrays.h"
#include "CheckedFaces.h"
#include "RandomNumbers.h"
#include "ThreadedParallel.h"

#include <gtest/gtest.h>

#include <vector>

using namespace lambent;

namespace
{
constexpr unsigned char duplicate = 1, refined = 8, hidden = 32, hiddenPoint = 2;

std::vector<CellUse> list(const UnwrittenVector<CellUse>& uses)
{
  return { uses.begin(), uses.end() };
}

std::vector<std::int64_t> list(const IndexSpan& span)
{
  std::vector<std::int64_t> result;
  for (std::size_t k = 0; k < span.size; ++k)
  {
    result.push_back(static_cast<std::int64_t>(span[k]));
  }
  return result;
}
}

TEST(DrawnTriangles, UsesFollowTheFlags)
{
  CellArrays polygons, strips;
  for (int k = 0; k < 5; ++k)
  {
    polygons.add({ 0, 1, 2 });
  }
  strips.add({ 0, 1, 2, 3 });
  strips.add({ 0, 1, 2, 3 });
  const unsigned char flags[] = { 0, duplicate, hidden, refined, hidden | duplicate, 4, duplicate };
  const auto uses = findCellUses(polygons.span(), strips.span(), 4, { nullptr, flags }, Parallel());
  EXPECT_EQ(list(uses),
    (std::vector<CellUse>{ CellUse::Drawn, CellUse::ForNormals, CellUse::None, CellUse::None,
      CellUse::None, CellUse::Drawn, CellUse::ForNormals }));
}

TEST(DrawnTriangles, CellsWithAHiddenPointHaveNoUse)
{
  CellArrays polygons, strips;
  polygons.add({ 0, 1, 2 });
  polygons.add({ 4, 1, 2, 3 });
  polygons.add({ 0, 3, 99 }); // has a point that does not exist
  polygons.add({ 0, 3, -1 });
  strips.add({ 0, 1, 2, 3 });
  strips.add({ 0, 1, 2, 4 });
  const unsigned char points[] = { 0, 1, 4, 1, hiddenPoint };
  const unsigned char cells[] = { 0, duplicate, 0, 0, 0, 0 };
  const auto uses = findCellUses(polygons.span(), strips.span(), 5, { points, cells }, Parallel());
  EXPECT_EQ(list(uses),
    (std::vector<CellUse>{ CellUse::Drawn, CellUse::None, CellUse::Drawn, CellUse::Drawn,
      CellUse::Drawn, CellUse::None }));
}

TEST(DrawnTriangles, FlagsThatExcludeNothingCostNothing)
{
  CellArrays polygons, strips;
  polygons.add({ 0, 1, 2 });
  const unsigned char points[] = { 1, 1, 1 }, cells[] = { 4 };
  EXPECT_TRUE(
    findCellUses(polygons.span(), strips.span(), 3, { points, cells }, Parallel()).empty());
  EXPECT_TRUE(findCellUses(polygons.span(), strips.span(), 3, {}, Parallel()).empty());
  EXPECT_TRUE(DrawnTriangles(1, nullptr, 0, {}, false, Parallel()).areUnchanged());
  EXPECT_FALSE(DrawnTriangles(1, nullptr, 0, {}, true, Parallel()).areUnchanged());
}

TEST(DrawnTriangles, MirroringSwapsTheLastTwoCorners)
{
  const std::int32_t narrow[] = { 0, 1, 2, 5, 4, 3 };
  const std::int64_t wide[] = { 0, 1, 2, 5, 4, 3 };
  const DrawnTriangles drawn(2, nullptr, 0, {}, true, Parallel());
  const std::vector<std::int64_t> expected{ 0, 2, 1, 5, 3, 4 };
  EXPECT_EQ(list(drawn.pick({ narrow, false, 6 }, Parallel()).span()), expected);
  EXPECT_EQ(list(drawn.pick({ wide, true, 6 }, Parallel()).span()), expected);
  EXPECT_TRUE(drawn.cells().empty());
}

// Compared with a plain loop.
TEST(DrawnTriangles, AreThoseOfDrawnCellsInOrder)
{
  RandomNumbers random(6);
  const std::int64_t firstCell = 7;
  for (const bool isMirrored : { false, true })
  {
    for (const bool hasCells : { false, true })
    {
      UnwrittenVector<CellUse> uses;
      std::vector<std::int64_t> cells, corners, expectedCells, expected;
      for (std::int64_t cell = 0; cell < 20000; ++cell)
      {
        uses.push_back(static_cast<CellUse>(random.below(3)));
        const int triangles = hasCells ? random.below(4) : 1;
        for (int k = 0; k < triangles; ++k)
        {
          const std::int64_t a = random.below(1000), b = random.below(1000), c = random.below(1000);
          corners.insert(corners.end(), { a, b, c });
          cells.push_back(firstCell + cell);
          if (uses.back() == CellUse::Drawn)
          {
            expected.insert(expected.end(), { a, isMirrored ? c : b, isMirrored ? b : c });
            expectedCells.push_back(firstCell + cell);
          }
        }
      }
      const ThreadedParallel parallel(3);
      const DrawnTriangles drawn(
        cells.size(), hasCells ? cells.data() : nullptr, firstCell, uses, isMirrored, parallel);
      EXPECT_FALSE(drawn.areUnchanged());
      EXPECT_EQ(
        list(drawn.pick({ corners.data(), true, corners.size() }, parallel).span()), expected);
      EXPECT_EQ(
        std::vector<std::int64_t>(drawn.cells().begin(), drawn.cells().end()), expectedCells);
    }
  }
}

TEST(DrawnTriangles, NoneMayBeLeft)
{
  const std::int64_t corners[] = { 0, 1, 2 };
  const UnwrittenVector<CellUse> uses(1, CellUse::None);
  const DrawnTriangles drawn(1, nullptr, 0, uses, false, Parallel());
  EXPECT_EQ(drawn.pick({ corners, true, 3 }, Parallel()).span().size, 0u);
}

TEST(DrawnTriangles, NormalsIgnoreUnusedFacesOnly)
{
  const double points[] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0 };
  CellArrays polygons, strips;
  polygons.add({ 0, 1, 2 });
  polygons.add({ 1, 3, 2 });
  strips.add({ 0, 1, 2, 3 });
  const TupleSpan span{ points, true, 4 };
  CheckedFaces faces = checkFaces(span, polygons.span(), strips.span(), Parallel());
  UnwrittenVector<CellUse> uses;
  skipUnused(uses, faces);
  EXPECT_TRUE(faces.faces.skip.empty());
  uses.assign({ CellUse::None, CellUse::ForNormals, CellUse::None });
  skipUnused(uses, faces);
  EXPECT_EQ(faces.faces.skip, (std::vector<unsigned char>{ 1, 0, 1, 1 }));
}
