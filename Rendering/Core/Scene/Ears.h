// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief ear clipping: cuts a concave polygon into triangles
 *
 * An ear is a convex corner whose triangle contains no other corner.
 *
 * 1. Cut off the first ear, in the order of the outline, until three corners are left or none is an
 *    ear. After the first cut, the last remaining corner is not tried: an outline that does not
 *    cross itself has two ears.
 * 2. Try a rejected corner again only after one of its neighbours was cut off, or the corner found
 *    in its triangle (its witness). Nothing else can make it an ear.
 *
 * So most corners are tried only a few times, each against all corners: O(n^2) in practice. The
 * result is the same as when all corners are tried again after each cut, which takes O(n^3).
 *
 * Meisters, Polygons Have Ears, American Mathematical Monthly 82 (1975).
 */
#ifndef lambent_Ears_h
#define lambent_Ears_h

#include "Polygon.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

namespace lambent
{
class Ears
{
public:
  /// Writes the cut-off triangles to `out` and advances it. `polygon` keeps the remaining corners.
  void cut(Polygon& polygon, std::int32_t*& out)
  {
    this->start(polygon);
    std::size_t left = this->Corners.size();
    while (left > 3 && !this->Untried.empty())
    {
      const std::size_t k = this->Untried.top();
      const bool isLast = this->Corners[k].next < k;
      if (isLast && left < this->Corners.size())
      {
        break;
      }
      this->Untried.pop();
      this->Corners[k].isUntried = false;
      if (this->isEar(polygon, k))
      {
        putTriangle(out, polygon.ids[this->Corners[k].previous], polygon.ids[k],
          polygon.ids[this->Corners[k].next]);
        this->remove(k);
        --left;
      }
    }
    this->keepOthers(polygon);
  }

private:
  static constexpr std::size_t none = -1;

  struct Corner
  {
    std::size_t previous, next;
    std::size_t witness;     ///< the corner found in the triangle of this one when last tried
    std::size_t firstWaiter; ///< in Waiters: corners whose witness is or was this one
    bool isUntried, isCut;
  };

  struct Waiter
  {
    std::size_t corner, next;
  };

  void start(const Polygon& polygon)
  {
    const std::size_t size = polygon.size();
    this->Corners.clear();
    this->Waiters.clear();
    this->Untried = {};
    for (std::size_t k = 0; k < size; ++k)
    {
      this->Corners.push_back({ polygon.previous(k), polygon.next(k), none, none, true, false });
      this->Untried.push(k);
    }
  }

  /// If k is not an ear, records its witness.
  bool isEar(const Polygon& polygon, std::size_t k)
  {
    Corner& corner = this->Corners[k];
    const Vec3& a = polygon.points[corner.previous];
    const Vec3& b = polygon.points[k];
    const Vec3& c = polygon.points[corner.next];
    corner.witness = none;
    if (!(turn(a, b, c, polygon.normal) > 0.0))
    {
      return false;
    }
    for (std::size_t other = this->Corners[corner.next].next; other != corner.previous;
         other = this->Corners[other].next)
    {
      const Vec3& p = polygon.points[other];
      if (p != a && p != b && p != c && turn(a, b, p, polygon.normal) >= 0.0 &&
        turn(b, c, p, polygon.normal) >= 0.0 && turn(c, a, p, polygon.normal) >= 0.0)
      {
        corner.witness = other;
        this->Waiters.push_back({ k, this->Corners[other].firstWaiter });
        this->Corners[other].firstWaiter = this->Waiters.size() - 1;
        return false;
      }
    }
    return true;
  }

  void remove(std::size_t k)
  {
    Corner& corner = this->Corners[k];
    corner.isCut = true;
    this->Corners[corner.previous].next = corner.next;
    this->Corners[corner.next].previous = corner.previous;
    this->tryAgain(corner.previous);
    this->tryAgain(corner.next);
    for (std::size_t w = corner.firstWaiter; w != none; w = this->Waiters[w].next)
    {
      if (this->Corners[this->Waiters[w].corner].witness == k)
      {
        this->tryAgain(this->Waiters[w].corner);
      }
    }
  }

  void tryAgain(std::size_t k)
  {
    if (!this->Corners[k].isUntried && !this->Corners[k].isCut)
    {
      this->Corners[k].isUntried = true;
      this->Untried.push(k);
    }
  }

  void keepOthers(Polygon& polygon) const
  {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < this->Corners.size(); ++k)
    {
      if (!this->Corners[k].isCut)
      {
        polygon.ids[kept] = polygon.ids[k];
        polygon.points[kept] = polygon.points[k];
        ++kept;
      }
    }
    polygon.ids.resize(kept);
    polygon.points.resize(kept);
  }

  std::vector<Corner> Corners;
  std::vector<Waiter> Waiters;
  std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<std::size_t>> Untried;
};
}

#endif
