// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomOutlines.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace
{
constexpr int tries = 60;

double onGrid(double value)
{
  return std::floor(value * 65536.0) / 65536.0;
}

int sign(double value)
{
  return (value > 0.0) - (value < 0.0);
}

bool isSame(const PlanePoint& a, const PlanePoint& b)
{
  return a.x == b.x && a.y == b.y;
}

PlanePoint middle(const PlanePoint& a, const PlanePoint& b)
{
  return { 0.5 * (a.x + b.x), 0.5 * (a.y + b.y) };
}

bool isOnEdge(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p)
{
  return cross(a, b, p) == 0.0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
    std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

/// True if two segments have a point in common.
bool doMeet(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  const int s0 = sign(cross(a, b, c)), s1 = sign(cross(a, b, d));
  const int s2 = sign(cross(c, d, a)), s3 = sign(cross(c, d, b));
  return (s0 * s1 < 0 && s2 * s3 < 0) || isOnEdge(a, b, c) || isOnEdge(a, b, d) ||
    isOnEdge(c, d, a) || isOnEdge(c, d, b);
}

/// True if the segment from a corner to p meets the outline nowhere else.
bool isFree(const Outline& outline, const PlanePoint& corner, const PlanePoint& p)
{
  for (std::size_t k = 0; k < outline.size(); ++k)
  {
    const PlanePoint &a = outline.corners[k], &b = outline.after(k);
    if (isSame(a, b) ? isOnEdge(corner, p, a) && !isSame(a, corner) : false)
    {
      return false;
    }
    const bool isAtA = isSame(a, corner), isAtB = isSame(b, corner);
    if (isAtA || isAtB)
    {
      const PlanePoint& other = isAtA ? b : a;
      if (isOnEdge(corner, p, other) || isOnEdge(corner, other, p))
      {
        if (!isSame(other, corner))
        {
          return false;
        }
      }
    }
    else if (doMeet(corner, p, a, b))
    {
      return false;
    }
  }
  return true;
}

/// True if p lies to the left of the outline as it runs through corner k.
bool isLeftAt(const Outline& outline, std::size_t k, const PlanePoint& p)
{
  const std::size_t size = outline.size();
  const PlanePoint at = outline.corners[k];
  std::size_t before = k, after = k;
  do
  {
    before = (before + size - 1) % size;
  } while (isSame(outline.corners[before], at));
  do
  {
    after = (after + 1) % size;
  } while (isSame(outline.corners[after], at));
  const PlanePoint &a = outline.corners[before], &b = outline.corners[after];
  return cross(at, b, a) > 0.0 ? cross(at, b, p) > 0.0 && cross(at, p, a) > 0.0
                               : !(cross(at, a, p) >= 0.0 && cross(at, p, b) >= 0.0);
}

bool isNamedOnce(const Outline& outline, const PlanePoint& corner)
{
  return std::count_if(outline.corners.begin(), outline.corners.end(),
           [&](const PlanePoint& other) { return isSame(corner, other); }) == 1;
}

/// A corner from which a segment to p runs on the inside of the outline.
bool isInsideAt(const Outline& outline, std::size_t k, const PlanePoint& p)
{
  const int winding = outline.winding(p);
  return std::abs(winding) == 1 && isLeftAt(outline, k, p) == (winding > 0) &&
    (winding > 0 || isNamedOnce(outline, outline.corners[k]));
}

PlanePoint somewhere(RandomNumbers& random)
{
  const double x = onGrid(random.within(-2.2, 2.2));
  return { x, onGrid(random.within(-2.2, 2.2)) };
}

double distance(const Outline& outline, const PlanePoint& p)
{
  double nearest = 1e9;
  for (std::size_t k = 0; k < outline.size(); ++k)
  {
    const PlanePoint &a = outline.corners[k], &b = outline.after(k);
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    const double t =
      square > 0.0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, std::hypot(p.x - a.x - t * x, p.y - a.y - t * y));
  }
  return nearest;
}

std::vector<PlanePoint> ring(
  RandomNumbers& random, const PlanePoint& center, int size, double low, double high)
{
  std::vector<PlanePoint> corners;
  for (int k = 0; k < size; ++k)
  {
    const double angle = 6.283185307179586 * k / size, radius = random.within(low, high);
    corners.push_back(
      { onGrid(center.x + radius * std::cos(angle)), onGrid(center.y + radius * std::sin(angle)) });
  }
  return corners;
}

/// The corner's id, or a new one.
int idAgain(Outline& outline, std::size_t corner, RandomNumbers& random)
{
  return random.below(2) != 0 ? outline.ids[corner] : outline.idCount++;
}
}

double cross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double Outline::area() const
{
  double sum = 0.0;
  for (std::size_t k = 0; k < this->size(); ++k)
  {
    sum += 0.5 * cross({ 0.0, 0.0 }, this->corners[k], this->after(k));
  }
  return sum;
}

int Outline::winding(const PlanePoint& p) const
{
  int count = 0;
  for (std::size_t k = 0; k < this->size(); ++k)
  {
    const PlanePoint &a = this->corners[k], &b = this->after(k);
    if ((a.y <= p.y) != (b.y <= p.y) && (cross(a, b, p) > 0.0) == (b.y > a.y))
    {
      count += b.y > a.y ? 1 : -1;
    }
  }
  return count;
}

void Outline::insert(std::size_t at, const PlanePoint& corner, int id)
{
  this->corners.insert(this->corners.begin() + static_cast<std::ptrdiff_t>(at), corner);
  this->ids.insert(this->ids.begin() + static_cast<std::ptrdiff_t>(at), id);
}

void Outline::insert(std::size_t at, const PlanePoint& corner)
{
  this->insert(at, corner, this->idCount++);
}

Outline makeStar(RandomNumbers& random, int size)
{
  Outline outline;
  for (const PlanePoint& corner : ring(random, { 0.0, 0.0 }, size, 0.2, 2.0))
  {
    outline.insert(outline.size(), corner);
  }
  return outline;
}

Outline makeMaze(RandomNumbers& random, int size)
{
  for (;;)
  {
    std::vector<PlanePoint> points;
    std::set<std::pair<int, int>> used;
    while (static_cast<int>(points.size()) < size)
    {
      const int x = random.below(9) - 4, y = random.below(9) - 4;
      if (used.emplace(x, y).second)
      {
        points.push_back({ 0.5 * x, 0.5 * y });
      }
    }
    // Where two edges intersect, reverse the part of the outline between them.
    bool isSimple = false;
    for (int round = 0; round < 200 && !isSimple; ++round)
    {
      isSimple = true;
      for (int i = 0; i < size && isSimple; ++i)
      {
        for (int k = i + 2; k < size && isSimple; ++k)
        {
          if ((k + 1) % size != i &&
            doMeet(points[i], points[i + 1], points[k], points[(k + 1) % size]))
          {
            std::reverse(points.begin() + i + 1, points.begin() + k + 1);
            isSimple = false;
          }
        }
      }
    }
    for (int k = 0; k < size && isSimple; ++k) // no edge may run back along the previous one
    {
      const PlanePoint &a = points[k], &b = points[(k + 1) % size], &c = points[(k + 2) % size];
      isSimple = !isOnEdge(a, b, c) && !isOnEdge(b, c, a);
    }
    if (isSimple)
    {
      Outline outline;
      for (const PlanePoint& corner : points)
      {
        outline.insert(outline.size(), corner);
      }
      if (outline.area() < 0.0)
      {
        std::reverse(outline.corners.begin(), outline.corners.end());
      }
      return outline;
    }
  }
}

void doubleCorner(Outline& outline, RandomNumbers& random)
{
  const std::size_t k = random.below(static_cast<int>(outline.size()));
  const int count = 1 + random.below(4) / 2;
  for (int n = 0; n < count; ++n)
  {
    const int id = idAgain(outline, k, random);
    outline.insert(k + 1, outline.corners[k], id);
  }
}

void splitEdge(Outline& outline, RandomNumbers& random)
{
  const std::size_t k = random.below(static_cast<int>(outline.size()));
  outline.insert(k + 1, middle(outline.corners[k], outline.after(k)));
}

void addSpike(Outline& outline, RandomNumbers& random)
{
  for (int n = 0; n < tries; ++n)
  {
    const std::size_t k = random.below(static_cast<int>(outline.size()));
    const PlanePoint from = outline.corners[k], tip = somewhere(random);
    if (!isSame(from, tip) && isFree(outline, from, tip) &&
      (isNamedOnce(outline, from) || isInsideAt(outline, k, tip)))
    {
      const int idBack = idAgain(outline, k, random);
      outline.insert(k + 1, from, idBack);
      outline.insert(k + 1, tip);
      if (random.below(3) == 0) // a corner on the way there, not on the way back
      {
        outline.insert(k + 1, middle(from, tip));
      }
      return;
    }
  }
}

void addDetour(Outline& outline, RandomNumbers& random)
{
  const std::size_t k = random.below(static_cast<int>(outline.size()));
  const std::size_t next = (k + 1) % outline.size();
  const PlanePoint to = outline.corners[next];
  const PlanePoint half = middle(outline.corners[k], to);
  const int idBack = idAgain(outline, next, random);
  outline.insert(next + 1, to, idBack);
  outline.insert(next + 1, half);
}

void addHole(Outline& outline, RandomNumbers& random)
{
  for (int n = 0; n < tries; ++n)
  {
    const PlanePoint center = somewhere(random);
    const double room = distance(outline, center);
    if (std::abs(outline.winding(center)) != 1 || room < 0.02)
    {
      continue;
    }
    std::vector<PlanePoint> hole =
      ring(random, center, 3 + random.below(5), 0.2 * room, 0.9 * room);
    if (outline.winding(center) > 0)
    {
      std::reverse(hole.begin(), hole.end());
    }
    const std::size_t k = random.below(static_cast<int>(outline.size()));
    const PlanePoint from = outline.corners[k];
    Outline rim;
    rim.corners = hole;
    if (!isFree(outline, from, hole[0]) || !isFree(rim, hole[0], from) ||
      !isInsideAt(outline, k, hole[0]))
    {
      continue;
    }
    const int idBack = idAgain(outline, k, random), rimId = outline.idCount++;
    outline.insert(k + 1, from, idBack);
    const int middles = random.below(4);
    if ((middles & 1) != 0)
    {
      outline.insert(k + 1, middle(from, hole[0]));
    }
    outline.insert(k + 1, hole[0], random.below(2) != 0 ? rimId : outline.idCount++);
    for (std::size_t h = hole.size() - 1; h > 0; --h)
    {
      outline.insert(k + 1, hole[h]);
    }
    outline.insert(k + 1, hole[0], rimId);
    if ((middles & 2) != 0)
    {
      outline.insert(k + 1, middle(from, hole[0]));
    }
    return;
  }
}

void addTouchingHole(Outline& outline, RandomNumbers& random)
{
  for (int n = 0; n < tries; ++n)
  {
    const std::size_t k = random.below(static_cast<int>(outline.size()));
    const PlanePoint from = outline.corners[k];
    const double size = random.within(0.1, 0.7);
    const auto nearby = [&]()
    {
      const double x = onGrid(from.x + random.within(-size, size));
      return PlanePoint{ x, onGrid(from.y + random.within(-size, size)) };
    };
    PlanePoint p = nearby(), q = nearby();
    const double way = cross(from, p, q);
    const PlanePoint inside = middle(from, middle(p, q));
    const int winding = outline.winding(inside);
    if (way == 0.0 || std::abs(winding) != 1 || !isFree(outline, from, p) ||
      !isFree(outline, from, q) || !isInsideAt(outline, k, p) || !isInsideAt(outline, k, q))
    {
      continue;
    }
    bool isClear = true;
    for (std::size_t e = 0; e < outline.size(); ++e)
    {
      isClear = isClear && !doMeet(p, q, outline.corners[e], outline.after(e)) &&
        !isOnEdge(from, p, outline.corners[e]) == !isSame(from, outline.corners[e]);
    }
    if (!isClear)
    {
      continue;
    }
    if ((way > 0.0) == (winding > 0)) // opposite to the outline
    {
      std::swap(p, q);
    }
    const int idBack = idAgain(outline, k, random);
    outline.insert(k + 1, from, idBack);
    outline.insert(k + 1, q);
    outline.insert(k + 1, p);
    return;
  }
}

void turnRound(Outline& outline, RandomNumbers& random)
{
  const auto by = static_cast<std::ptrdiff_t>(random.below(static_cast<int>(outline.size())));
  std::rotate(outline.corners.begin(), outline.corners.begin() + by, outline.corners.end());
  std::rotate(outline.ids.begin(), outline.ids.begin() + by, outline.ids.end());
  if (random.below(2) != 0)
  {
    std::reverse(outline.corners.begin(), outline.corners.end());
    std::reverse(outline.ids.begin(), outline.ids.end());
  }
}
