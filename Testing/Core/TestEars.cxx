// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ears.h"
#include "RandomNumbers.h"

#include <gtest/gtest.h>

using namespace lambent;

namespace
{
bool isEar(const Polygon& polygon, std::size_t k)
{
  const std::size_t before = polygon.previous(k), after = polygon.next(k);
  const Vec3 &a = polygon.points[before], &b = polygon.points[k], &c = polygon.points[after];
  bool isFree = turn(a, b, c, polygon.normal) > 0.0;
  for (std::size_t other = 0; other < polygon.size(); ++other)
  {
    const Vec3& p = polygon.points[other];
    const bool isOther = other != before && other != k && other != after;
    isFree = isFree &&
      !(isOther && p != a && p != b && p != c && turn(a, b, p, polygon.normal) >= 0.0 &&
        turn(b, c, p, polygon.normal) >= 0.0 && turn(c, a, p, polygon.normal) >= 0.0);
  }
  return isFree;
}

/// The definition: after each cut, try all corners but the last again, from the first on.
std::vector<std::int32_t> cutPlainly(Polygon& polygon)
{
  std::vector<std::int32_t> triangles;
  std::size_t tried = polygon.size(), k = 0;
  while (polygon.size() > 3 && k < tried)
  {
    if (!isEar(polygon, k))
    {
      ++k;
      continue;
    }
    triangles.insert(triangles.end(),
      { polygon.ids[polygon.previous(k)], polygon.ids[k], polygon.ids[polygon.next(k)] });
    polygon.ids.erase(polygon.ids.begin() + static_cast<std::ptrdiff_t>(k));
    polygon.points.erase(polygon.points.begin() + static_cast<std::ptrdiff_t>(k));
    tried = polygon.size() - 1;
    k = 0;
  }
  return triangles;
}

void expectTheSame(const Polygon& polygon, Ears& ears)
{
  Polygon expected = polygon, found = polygon;
  const std::vector<std::int32_t> triangles = cutPlainly(expected);
  std::vector<std::int32_t> cut(3 * polygon.size());
  std::int32_t* out = cut.data();
  ears.cut(found, out);
  cut.resize(static_cast<std::size_t>(out - cut.data()));
  EXPECT_EQ(cut, triangles);
  EXPECT_EQ(found.ids, expected.ids);
  EXPECT_EQ(found.points, expected.points);
}
}

// Outlines on a small grid that cross and touch themselves, with doubled corners and collinear
// corners, and outlines of random points in space. The same ears must be cut in the same order.
TEST(Ears, EqualTryingAllCornersAgain)
{
  RandomNumbers random(77);
  Ears ears;
  for (int n = 0; n < 20000 && !HasFailure(); ++n)
  {
    const int size = 4 + random.below(20), kind = n % 3, width = 3 + random.below(6);
    Polygon polygon;
    for (int k = 0; k < size; ++k)
    {
      const double angle = 6.283185307179586 * k / size, radius = random.within(0.1, 1.0);
      polygon.ids.push_back(100 + k);
      polygon.points.push_back(kind == 0 ? Vec3(random.below(width), random.below(width), 0.0)
                                         : Vec3(radius * std::cos(angle), radius * std::sin(angle),
                                             kind == 1 ? 0.0 : random.within(-0.4, 0.4)));
    }
    polygon.findNormal();
    expectTheSame(polygon, ears);
  }
}

// A crescent: its inner side blocks nearly all corners of its outer side.
TEST(Ears, EqualTryingAllCornersAgainOnACrescent)
{
  Ears ears;
  for (int size : { 40, 300 })
  {
    Polygon polygon;
    for (int k = 0; k < size; ++k)
    {
      const double angle = 3.0 * (k < size / 2 ? k : size - 1 - k) / (size / 2);
      const double radius = k < size / 2 ? 1.0 : 0.9;
      polygon.ids.push_back(k);
      polygon.points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
    }
    polygon.findNormal();
    expectTheSame(polygon, ears);
  }
}
