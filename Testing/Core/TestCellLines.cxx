// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines and points that show cells.
#include "CellLines.h"
#include "RandomNumbers.h"

#include <gtest/gtest.h>

#include <set>

using namespace lambent;

namespace
{
using Cells = std::vector<std::vector<std::int64_t>>;

/// A group and the memory of its cells.
struct Group
{
  std::vector<std::int64_t> offsets{ 0 }, ids;
  CellGroup group;

  explicit Group(const Cells& cells, std::int64_t firstCell = 0)
  {
    for (const auto& cell : cells)
    {
      this->ids.insert(this->ids.end(), cell.begin(), cell.end());
      this->offsets.push_back(static_cast<std::int64_t>(this->ids.size()));
    }
    this->group.cells = { { this->offsets.data(), true, this->offsets.size() },
      { this->ids.data(), true, this->ids.size() } };
    this->group.firstCell = firstCell;
  }
};

const CellUse drawn = CellUse::Drawn, none = CellUse::None;
}

TEST(CellLines, VerticesAndPolylines)
{
  LineList list;
  addVertices(Group({ { 4, 2 }, {}, { 4 } }, 10).group, list);
  EXPECT_EQ(list.corners, (std::vector<std::int64_t>{ 4, 4, 2, 2, 4, 4 }));
  EXPECT_EQ(list.cells, (std::vector<std::int64_t>{ 10, 10, 12 }));
  list = LineList();
  addPolylines(Group({ { 0, 1, 2 }, { 3 }, {}, { 2, 0 } }, 5).group, list);
  EXPECT_EQ(list.corners, (std::vector<std::int64_t>{ 0, 1, 1, 2, 2, 0 }));
  EXPECT_EQ(list.cells, (std::vector<std::int64_t>{ 5, 5, 8 }));
}

TEST(CellLines, CellsThatAreNotDrawnAreLeftOut)
{
  const CellUse uses[] = { none, drawn, CellUse::ForNormals, drawn };
  Group lines({ { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 4 } });
  lines.group.uses = uses;
  LineList list;
  addPolylines(lines.group, list);
  EXPECT_EQ(list.cells, (std::vector<std::int64_t>{ 1, 3 }));
  list = LineList();
  addUsedPoints({ lines.group }, 5, list);
  EXPECT_EQ(list.corners, (std::vector<std::int64_t>{ 1, 1, 2, 2, 3, 3, 4, 4 }));
  EXPECT_EQ(list.cells, (std::vector<std::int64_t>{ 1, 1, 3, 3 }));
}

TEST(CellLines, EdgesAreThoseOfCellsAndEachIsThereOnce)
{
  LineList list;
  const Group polygons({ { 0, 1, 2, 3 }, { 1, 4, 2 }, { 5 }, { 3, 2 }, { 6, 6, 7 } }, 2);
  const Group strips({ { 2, 4, 7, 8 } }, 7);
  addEdges(polygons.group, strips.group, 9, list);
  EXPECT_EQ(list.corners,
    (std::vector<std::int64_t>{
      0, 1, 1, 2, 2, 3, 3, 0, 1, 4, 4, 2, 6, 7, 2, 7, 4, 7, 4, 8, 7, 8 }));
  EXPECT_EQ(list.cells, (std::vector<std::int64_t>{ 2, 2, 2, 2, 3, 3, 6, 7, 7, 7, 7 }));
}

TEST(CellLines, EdgesOfRandomCellsEqualThoseOfASet)
{
  RandomNumbers random(5);
  for (int round = 0; round < 200; ++round)
  {
    const int points = 1 + random.below(30);
    Cells cells(random.below(60));
    for (auto& cell : cells)
    {
      cell.resize(random.below(7));
      for (std::int64_t& point : cell)
      {
        point = random.below(points);
      }
    }
    std::set<std::pair<std::int64_t, std::int64_t>> seen;
    LineList expected, found;
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
    {
      for (std::size_t k = 0; k < cells[cell].size(); ++k)
      {
        const std::int64_t a = cells[cell][k], b = cells[cell][(k + 1) % cells[cell].size()];
        if (a != b && seen.insert(std::minmax(a, b)).second)
        {
          expected.add(a, b, static_cast<std::int64_t>(cell));
        }
      }
    }
    addEdges(Group(cells).group, CellGroup(), points, found);
    EXPECT_EQ(found.corners, expected.corners);
    EXPECT_EQ(found.cells, expected.cells);
  }
}

TEST(CellLines, UsedPointsBelongToTheFirstCell)
{
  LineList list;
  const Group first({ { 3, 1 } }, 0), second({ { 1, 0, 5 }, { 5, 2 } }, 1);
  addUsedPoints({ first.group, second.group }, 6, list);
  EXPECT_EQ(list.corners, (std::vector<std::int64_t>{ 3, 3, 1, 1, 0, 0, 5, 5, 2, 2 }));
  EXPECT_EQ(list.cells, (std::vector<std::int64_t>{ 0, 0, 1, 1, 2 }));
}
