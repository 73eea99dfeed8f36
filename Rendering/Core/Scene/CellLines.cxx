// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellLines.h"

#include "CellView.h"

#include <algorithm>

namespace lambent
{
namespace
{
/// Calls body(begin, end, cell) for each cell that is drawn; its points are those from begin to end
/// - 1 in the connectivity.
template <typename Body>
void forDrawn(const CellGroup& group, const Body& body)
{
  const std::size_t count = cellCount(group.cells);
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    if (group.isDrawn(cell))
    {
      body(group.cells.offsets[cell], group.cells.offsets[cell + 1],
        group.firstCell + static_cast<std::int64_t>(cell));
    }
  }
}

/// Keeps the first of several equal edges. The edges of each point that is the smaller one of two
/// are sorted on their own.
class UniqueEdges
{
public:
  explicit UniqueEdges(std::size_t pointCount)
    : Begins(pointCount + 2)
  {
  }

  void add(std::uint64_t a, std::uint64_t b, std::int64_t cell)
  {
    if (a != b)
    {
      this->All.add(a, b, cell);
      ++this->Begins[std::min(a, b) + 2];
    }
  }

  void append(LineList& list)
  {
    const std::vector<bool> isFirst = this->findFirst();
    for (std::size_t k = 0; k < isFirst.size(); ++k)
    {
      if (isFirst[k])
      {
        list.add(this->All.corners[2 * k], this->All.corners[2 * k + 1], this->All.cells[k]);
      }
    }
  }

private:
  struct Edge
  {
    std::int64_t larger; ///< of its two points
    std::size_t number;

    bool operator<(const Edge& other) const
    {
      return this->larger != other.larger ? this->larger < other.larger
                                          : this->number < other.number;
    }
  };

  std::vector<bool> findFirst()
  {
    for (std::size_t point = 1; point < this->Begins.size(); ++point)
    {
      this->Begins[point] += this->Begins[point - 1];
    }
    std::vector<Edge> edges(this->All.cells.size());
    for (std::size_t k = 0; k < edges.size(); ++k)
    {
      const auto [smaller, larger] =
        std::minmax(this->All.corners[2 * k], this->All.corners[2 * k + 1]);
      edges[this->Begins[static_cast<std::size_t>(smaller) + 1]++] = { larger, k };
    }
    std::vector<bool> isFirst(edges.size(), true);
    for (std::size_t point = 0; point + 1 < this->Begins.size(); ++point)
    {
      const std::size_t begin = this->Begins[point], end = this->Begins[point + 1];
      std::sort(edges.data() + begin, edges.data() + end);
      for (std::size_t k = begin + 1; k < end; ++k)
      {
        isFirst[edges[k].number] = edges[k].larger != edges[k - 1].larger;
      }
    }
    return isFirst;
  }

  LineList All;
  /// Counts; then where the edges of each point begin.
  std::vector<std::size_t> Begins;
};
}

void addVertices(const CellGroup& vertices, LineList& list)
{
  const IndexSpan& points = vertices.cells.connectivity;
  forDrawn(vertices,
    [&](std::size_t begin, std::size_t end, std::int64_t cell)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        list.add(points[k], points[k], cell);
      }
    });
}

void addPolylines(const CellGroup& polylines, LineList& list)
{
  const IndexSpan& points = polylines.cells.connectivity;
  forDrawn(polylines,
    [&](std::size_t begin, std::size_t end, std::int64_t cell)
    {
      for (std::size_t k = begin; k + 1 < end; ++k)
      {
        list.add(points[k], points[k + 1], cell);
      }
    });
}

void addEdges(
  const CellGroup& polygons, const CellGroup& strips, std::size_t pointCount, LineList& list)
{
  UniqueEdges edges(pointCount);
  forDrawn(polygons,
    [&](std::size_t begin, std::size_t end, std::int64_t cell)
    {
      const IndexSpan& points = polygons.cells.connectivity;
      for (std::size_t k = begin; k < end; ++k)
      {
        edges.add(points[k], points[k + 1 < end ? k + 1 : begin], cell);
      }
    });
  forDrawn(strips,
    [&](std::size_t begin, std::size_t end, std::int64_t cell)
    {
      const IndexSpan& points = strips.cells.connectivity;
      for (std::size_t k = begin; k + 1 < end; ++k)
      {
        edges.add(points[k], points[k + 1], cell);
        if (k + 2 < end)
        {
          edges.add(points[k], points[k + 2], cell);
        }
      }
    });
  edges.append(list);
}

void addUsedPoints(const std::vector<CellGroup>& groups, std::size_t pointCount, LineList& list)
{
  std::vector<bool> isUsed(pointCount, false);
  for (const CellGroup& group : groups)
  {
    const IndexSpan& points = group.cells.connectivity;
    forDrawn(group,
      [&](std::size_t begin, std::size_t end, std::int64_t cell)
      {
        for (std::size_t k = begin; k < end; ++k)
        {
          if (!isUsed[points[k]])
          {
            isUsed[points[k]] = true;
            list.add(points[k], points[k], cell);
          }
        }
      });
  }
}
}
