// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

#include <algorithm>
#include <map>
#include <utility>

void Shape::add(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const auto first = static_cast<std::int64_t>(this->points.size());
  this->points.insert(this->points.end(), { a, b, c });
  this->cells.push_back({ first, first + 1, first + 2 });
}

Shape triangle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  Shape shape;
  shape.add(a, b, c);
  return shape;
}

Shape box(const Vec3& half)
{
  Shape shape;
  for (int k = 0; k < 8; ++k)
  {
    shape.points.emplace_back(
      k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z);
  }
  shape.cells = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
    { 4, 5, 7, 6 } };
  return shape;
}

Shape ball(int levels)
{
  Shape shape;
  shape.points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 } };
  shape.cells = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> middles;
    const auto middle = [&](std::int64_t p, std::int64_t q)
    {
      const auto next = static_cast<std::int64_t>(shape.points.size());
      const auto place = middles.emplace(std::minmax(p, q), next);
      if (place.second)
      {
        shape.points.push_back(lambent::normalized(shape.points[p] + shape.points[q]));
      }
      return place.first->second;
    };
    std::vector<std::vector<std::int64_t>> finer;
    for (const auto& cell : shape.cells)
    {
      const std::int64_t a = cell[0], b = cell[1], c = cell[2];
      const std::int64_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
    }
    shape.cells = finer;
  }
  return shape;
}

Shape square(int n)
{
  Shape shape;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      shape.points.emplace_back((2.0 * i) / n - 1.0, (2.0 * j) / n - 1.0, 0.0);
    }
  }
  for (std::int64_t j = 0; j < n; ++j)
  {
    for (std::int64_t i = 0; i < n; ++i)
    {
      const std::int64_t a = j * (n + 1) + i;
      shape.cells.push_back({ a, a + 1, a + n + 2, a + n + 1 });
    }
  }
  return shape;
}

Shape hills(int n)
{
  Shape quads = square(n);
  Shape shape;
  for (Vec3& p : quads.points)
  {
    const double x = p.x * p.x, y = p.y * p.y;
    p.z = ((1.0 - x) * (1.0 - y)) * ((3.0 * p.x) * p.y + (p.x - p.y));
  }
  shape.points = quads.points;
  for (const auto& q : quads.cells)
  {
    shape.cells.push_back({ q[0], q[1], q[2] });
    shape.cells.push_back({ q[0], q[2], q[3] });
  }
  return shape;
}

Shape cylinder(int n)
{
  Shape shape;
  for (int quadrant = 0; quadrant < 4; ++quadrant)
  {
    for (int k = 0; k < n; ++k)
    {
      const double t = static_cast<double>(k) / n, square = t * t;
      double x = (1.0 - square) / (1.0 + square), z = (2.0 * t) / (1.0 + square);
      for (int turn = 0; turn < quadrant; ++turn)
      {
        std::swap(x, z);
        x = -x;
      }
      shape.points.emplace_back(x, -1.0, z);
      shape.points.emplace_back(x, 1.0, z);
    }
  }
  const auto count = static_cast<std::int64_t>(shape.points.size());
  for (std::int64_t a = 0; a < count; a += 2)
  {
    const std::int64_t b = (a + 2) % count;
    shape.cells.push_back({ a, a + 1, b + 1, b });
  }
  return shape;
}

Shape star(int n)
{
  const Shape round = cylinder(n);
  Shape shape;
  shape.cells.emplace_back();
  for (std::size_t k = 0; k < round.points.size(); k += 2)
  {
    const double radius = k % 4 == 0 ? 1.0 : 0.375;
    shape.cells.back().push_back(static_cast<std::int64_t>(shape.points.size()));
    shape.points.emplace_back(radius * round.points[k].x, radius * round.points[k].z, 0.0);
  }
  return shape;
}

Shape ribbons(int n)
{
  Shape shape;
  shape.points = square(n).points;
  for (std::int64_t j = 0; j < n; ++j)
  {
    shape.cells.emplace_back();
    for (std::int64_t i = 0; i <= n; ++i)
    {
      shape.cells.back().push_back((j + 1) * (n + 1) + i);
      shape.cells.back().push_back(j * (n + 1) + i);
    }
  }
  return shape;
}

Shape soup(RandomNumbers& random, int count, double size)
{
  Shape shape;
  for (int k = 0; k < count; ++k)
  {
    const Vec3 center = random.inBox(1.0);
    const Vec3 a = random.inBox(size), b = random.inBox(size), c = random.inBox(size);
    shape.add(center + a, center + b, center + c);
  }
  return shape;
}

Shape needles(RandomNumbers& random, int count, double width)
{
  Shape shape;
  for (int k = 0; k < count; ++k)
  {
    const Vec3 a = random.inBox(1.25), b = random.inBox(1.25), c = random.inBox(width);
    shape.add(a, b, b + c);
  }
  return shape;
}

Shape layers(int count)
{
  Shape shape;
  for (int k = 0; k < count; ++k)
  {
    shape = joined(shape, moved(square(1), Vec3(0.0, 0.0, 0.5 - static_cast<double>(k) / count)));
  }
  return shape;
}

Shape scaled(Shape shape, const Vec3& factors)
{
  for (Vec3& p : shape.points)
  {
    p = p * factors;
  }
  return shape;
}

Shape moved(Shape shape, const Vec3& by)
{
  for (Vec3& p : shape.points)
  {
    p = p + by;
  }
  return shape;
}

Shape turned(Shape shape)
{
  for (auto& cell : shape.cells)
  {
    std::reverse(cell.begin(), cell.end());
  }
  return shape;
}

Shape apart(const Shape& shape)
{
  Shape result;
  for (const auto& cell : shape.cells)
  {
    for (std::size_t k = 2; k < cell.size(); ++k)
    {
      result.add(shape.points[cell[0]], shape.points[cell[k - 1]], shape.points[cell[k]]);
    }
  }
  return result;
}

Shape joined(Shape a, const Shape& b)
{
  const auto first = static_cast<std::int64_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& cell : b.cells)
  {
    a.cells.emplace_back();
    for (std::int64_t id : cell)
    {
      a.cells.back().push_back(first + id);
    }
  }
  return a;
}
