// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the surfaces of a scene, numbered through
 *
 * Triangles and points are counted over all surfaces in order, so that (input,
 * cell, triangle within the cell) becomes one number: of two hits at the same
 * depth the one with the smaller number is kept.
 */
#ifndef lambent_SceneMesh_h
#define lambent_SceneMesh_h

#include "Scene.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lambent
{
/// The number of no triangle, and the most triangles that a scene can have.
constexpr std::uint32_t noTriangle = 0xFFFFFFFFu;

class SceneMesh
{
public:
  struct Part
  {
    const Surface* surface;
    std::size_t firstTriangle;
    std::size_t firstPoint;

    /// Whether a triangle, counted over all surfaces, is one of this part's.
    bool holds(std::size_t triangle) const
    {
      return triangle - this->firstTriangle < this->surface->triangleCount();
    }
  };

  explicit SceneMesh(const std::vector<Surface>& surfaces)
  {
    for (const Surface& surface : surfaces)
    {
      this->Parts.push_back({ &surface, this->Triangles, this->Points });
      this->Triangles += surface.triangleCount();
      this->Points += surface.points.size;
    }
  }

  std::size_t triangleCount() const { return this->Triangles; }
  std::size_t pointCount() const { return this->Points; }

  /// The part that holds a triangle.
  const Part& partOf(std::size_t triangle) const
  {
    if (this->Parts.size() == 1)
    {
      return this->Parts.front();
    }
    return *(std::upper_bound(this->Parts.begin(), this->Parts.end(), triangle,
               [](std::size_t t, const Part& part) { return t < part.firstTriangle; }) -
      1);
  }

  /// Calls body(part, begin, end) for the pieces of [begin, end), counted over all
  /// surfaces, that lie in one surface each; begin and end then count within it.
  template <typename Body>
  void forTriangles(std::size_t begin, std::size_t end, Body&& body) const
  {
    this->forPieces(begin, end, &Part::firstTriangle, this->Triangles, body);
  }
  template <typename Body>
  void forPoints(std::size_t begin, std::size_t end, Body&& body) const
  {
    this->forPieces(begin, end, &Part::firstPoint, this->Points, body);
  }

private:
  template <typename Body>
  void forPieces(std::size_t begin, std::size_t end, std::size_t Part::*first, std::size_t total,
    Body&& body) const
  {
    auto part = std::upper_bound(this->Parts.begin(), this->Parts.end(), begin,
                  [first](std::size_t t, const Part& p) { return t < p.*first; }) -
      1;
    while (begin < end)
    {
      const std::size_t stop = part + 1 == this->Parts.end() ? total : (*(part + 1)).*first;
      const std::size_t pieceEnd = std::min(end, stop);
      if (begin < pieceEnd)
      {
        body(*part, begin - (*part).*first, pieceEnd - (*part).*first);
      }
      begin = pieceEnd;
      ++part;
    }
  }

  std::vector<Part> Parts;
  std::size_t Triangles = 0;
  std::size_t Points = 0;
};
}

#endif
