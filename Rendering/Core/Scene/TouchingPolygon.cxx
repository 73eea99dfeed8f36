// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchingPolygon.h"

#include <algorithm>

namespace lambent
{
namespace
{
struct Corner
{
  double x, y;
  std::size_t previous, next;
  bool isConvex, isCut, isListed;
};

class Outline
{
public:
  Outline(const std::vector<Vec3>& points, const Vec3& normal, double tolerance,
    std::vector<std::size_t>& triangles)
    : Tolerance(tolerance)
    , Triangles(triangles)
    , Left(points.size())
  {
    this->project(points, normal);
    for (std::size_t k = 0; k < this->Corners.size(); ++k)
    {
      this->judge(k);
    }
  }

  bool cut()
  {
    for (std::size_t k = 0; k < this->Corners.size(); ++k)
    {
      this->cutDull(k);
    }
    while (this->Left > 3)
    {
      if (!this->cutFirstEar())
      {
        return false;
      }
    }
    const std::size_t last = this->Start;
    this->write(last);
    return this->side(last) >= 0;
  }

private:
  void project(const std::vector<Vec3>& points, const Vec3& normal)
  {
    const double nx = std::fabs(normal.x), ny = std::fabs(normal.y), nz = std::fabs(normal.z);
    const int axis = nz >= nx && nz >= ny ? 2 : (ny >= nx ? 1 : 0);
    const bool isTurned = normal[axis] < 0.0;
    const int u = (axis + (isTurned ? 2 : 1)) % 3, v = (axis + (isTurned ? 1 : 2)) % 3;
    const std::size_t size = points.size();
    for (std::size_t k = 0; k < size; ++k)
    {
      this->Corners.push_back({ points[k][u], points[k][v], k == 0 ? size - 1 : k - 1,
        k + 1 == size ? 0 : k + 1, false, false, false });
    }
  }

  /// The side of the line from a to b on which p lies: 1 left, -1 right, 0 on it.
  int side(std::size_t a, std::size_t b, std::size_t p) const
  {
    const Corner &from = this->Corners[a], &to = this->Corners[b], &at = this->Corners[p];
    const double x = to.x - from.x, y = to.y - from.y;
    const double area = x * (at.y - from.y) - y * (at.x - from.x);
    const double zero = this->Tolerance * (std::fabs(x) + std::fabs(y));
    return area > zero ? 1 : (area < -zero ? -1 : 0);
  }

  /// The direction in which the outline turns at a corner.
  int side(std::size_t k) const
  {
    return this->side(this->Corners[k].previous, k, this->Corners[k].next);
  }

  void judge(std::size_t k)
  {
    Corner& corner = this->Corners[k];
    corner.isConvex = this->side(k) > 0;
    if (!corner.isConvex && !corner.isListed)
    {
      corner.isListed = true;
      this->NotConvex.push_back(k);
    }
  }

  /// Removes the corners from the list that have become convex or were cut off.
  void cleanList()
  {
    const auto isOff = [this](std::size_t k)
    {
      Corner& corner = this->Corners[k];
      corner.isListed = !corner.isConvex && !corner.isCut;
      return !corner.isListed;
    };
    this->NotConvex.erase(
      std::remove_if(this->NotConvex.begin(), this->NotConvex.end(), isOff), this->NotConvex.end());
  }

  bool isSamePlace(std::size_t a, std::size_t b) const
  {
    const Corner &p = this->Corners[a], &q = this->Corners[b];
    return std::fabs(p.x - q.x) <= this->Tolerance && std::fabs(p.y - q.y) <= this->Tolerance;
  }

  void write(std::size_t k)
  {
    const Corner& corner = this->Corners[k];
    this->Triangles.insert(this->Triangles.end(), { corner.previous, k, corner.next });
  }

  void remove(std::size_t k)
  {
    this->write(k);
    Corner& corner = this->Corners[k];
    corner.isCut = true;
    this->Corners[corner.previous].next = corner.next;
    this->Corners[corner.next].previous = corner.previous;
    this->judge(corner.previous);
    this->judge(corner.next);
    this->Start = corner.next;
    --this->Left;
    if (++this->CutSince * 8 > this->NotConvex.size()) // only now and then: it takes a full pass
    {
      this->cleanList();
      this->CutSince = 0;
    }
  }

  /// True if a corner encloses nothing: it coincides with a neighbour, or is a tip.
  bool isDull(std::size_t k) const
  {
    const std::size_t a = this->Corners[k].previous, c = this->Corners[k].next;
    if (this->isSamePlace(a, k) || this->isSamePlace(k, c))
    {
      return true;
    }
    const Corner &from = this->Corners[a], &at = this->Corners[k], &to = this->Corners[c];
    return this->side(k) == 0 &&
      (at.x - from.x) * (to.x - at.x) + (at.y - from.y) * (to.y - at.y) < 0.0;
  }

  /// Cuts off k if it is dull, and any corner that becomes dull as a result.
  void cutDull(std::size_t k)
  {
    while (this->Left > 3 && !this->Corners[k].isCut && this->isDull(k))
    {
      const std::size_t before = this->Corners[k].previous, after = this->Corners[k].next;
      this->remove(k);
      k = this->isDull(before) ? before : after;
    }
  }

  /// Tries the corners from the last cut on. Returns false if none is an ear.
  bool cutFirstEar()
  {
    std::size_t k = this->Start;
    for (std::size_t tried = 0; tried < this->Left; ++tried, k = this->Corners[k].next)
    {
      if (this->isEar(k))
      {
        const std::size_t before = this->Corners[k].previous, after = this->Corners[k].next;
        this->remove(k);
        this->cutDull(before);
        this->cutDull(after);
        return true;
      }
    }
    return false;
  }

  bool isEar(std::size_t b) const
  {
    if (!this->Corners[b].isConvex)
    {
      return false;
    }
    const std::size_t a = this->Corners[b].previous, c = this->Corners[b].next;
    const auto low = [&](double Corner::*x) {
      return std::min({ this->Corners[a].*x, this->Corners[b].*x, this->Corners[c].*x });
    };
    const auto high = [&](double Corner::*x) {
      return std::max({ this->Corners[a].*x, this->Corners[b].*x, this->Corners[c].*x });
    };
    const double margin = 2.0 * this->Tolerance;
    const double left = low(&Corner::x) - margin, right = high(&Corner::x) + margin;
    const double bottom = low(&Corner::y) - margin, top = high(&Corner::y) + margin;
    for (const std::size_t p : this->NotConvex)
    {
      const Corner& corner = this->Corners[p];
      if (corner.x >= left && corner.x <= right && corner.y >= bottom && corner.y <= top &&
        p != a && p != c && !corner.isConvex && !corner.isCut && this->isInTheWay(a, b, c, p))
      {
        return false;
      }
    }
    return true;
  }

  bool isInTheWay(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const
  {
    const int ca = this->side(c, a, p);
    if (ca < 0 || this->side(a, b, p) < 0 || this->side(b, c, p) < 0)
    {
      return false;
    }
    const bool isOnNewEdge = ca == 0 && !this->isSamePlace(p, a) && !this->isSamePlace(p, c);
    return isOnNewEdge || this->leadsInto(a, b, c, p);
  }

  /// True if p, a corner in the closed triangle a b c, lies inside, or on its boundary
  /// with an edge that leads inside.
  bool leadsInto(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const
  {
    const bool isOnAB = this->side(a, b, p) <= 0, isOnBC = this->side(b, c, p) <= 0,
               isOnCA = this->side(c, a, p) <= 0;
    for (const std::size_t q : { this->Corners[p].previous, this->Corners[p].next })
    {
      if ((!isOnAB || this->side(a, b, q) > 0) && (!isOnBC || this->side(b, c, q) > 0) &&
        (!isOnCA || this->side(c, a, q) > 0))
      {
        return true;
      }
    }
    return false;
  }

  double Tolerance;
  std::vector<std::size_t>& Triangles;
  std::vector<Corner> Corners;
  std::vector<std::size_t> NotConvex; ///< may contain corners that have become convex
  std::size_t CutSince = 0;           ///< corners cut off since the list was cleaned
  std::size_t Start = 0;
  std::size_t Left;
};
}

bool cutTouchingPolygon(const std::vector<Vec3>& points, const Vec3& normal, double tolerance,
  std::vector<std::size_t>& triangles)
{
  triangles.clear();
  return Outline(points, normal, tolerance, triangles).cut();
}
}
