// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compares the test for opposite rings of points with a search through all rotations.

#include "OppositePolygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace
{
using Ring = std::vector<std::int64_t>;

struct Rings
{
  std::vector<Ring> all;

  std::size_t cellSize(std::int64_t face) const { return this->all[face].size(); }
  const std::int64_t* cell(std::int64_t face) const { return this->all[face].data(); }
};

bool haveOppositeRotations(const Ring& a, Ring b)
{
  std::reverse(b.begin(), b.end());
  for (std::size_t turn = 0; turn < b.size(); ++turn)
  {
    std::rotate(b.begin(), b.begin() + 1, b.end());
    if (a == b)
    {
      return true;
    }
  }
  return false;
}

// Rings of few distinct points, so that many are periodic or nearly so. Half of the rings are
// rotated copies of others; some of these are also reversed.
Rings makeRings(unsigned int seed, std::size_t size)
{
  std::mt19937 random(seed);
  Rings rings;
  for (int i = 0; i < 48; ++i)
  {
    Ring ring(size);
    const std::size_t period = 1 + random() % size;
    for (std::size_t k = 0; k < size; ++k)
    {
      ring[k] = k < period ? random() % 3 : ring[k - period];
    }
    if (i % 2)
    {
      ring = rings.all[random() % rings.all.size()];
      std::rotate(ring.begin(), ring.begin() + random() % size, ring.end());
      std::reverse(ring.begin(), random() % 2 ? ring.end() : ring.begin());
    }
    rings.all.push_back(ring);
  }
  return rings;
}
}

TEST(OppositePolygons, EqualAllRotations)
{
  int found = 0, others = 0;
  for (const std::size_t size : { 3, 4, 16, 17, 18, 24, 31, 36 })
  {
    for (unsigned int seed = 1; seed <= 4; ++seed)
    {
      const Rings rings = makeRings(seed, size);
      lambent::OppositePolygons<Rings> opposites(rings);
      for (int time = 0; time < 2; ++time) // the second time from the cache
      {
        for (std::int64_t a = 0; a < 48; ++a)
        {
          for (std::int64_t b = 0; b < 48; ++b)
          {
            const bool expected = haveOppositeRotations(rings.all[a], rings.all[b]);
            ASSERT_EQ(opposites.areOpposite(a, b), expected) << a << " and " << b << " of " << size;
            ++(expected ? found : others);
          }
        }
      }
    }
  }
  EXPECT_GT(found, 4000);
  EXPECT_GT(others, 4000);
}

TEST(OppositePolygons, HaveTheSameSize)
{
  const Rings rings{ { Ring(20, 1), Ring(21, 1), Ring(3, 1), Ring(4, 1), Ring(20, 1) } };
  lambent::OppositePolygons<Rings> opposites(rings);
  EXPECT_FALSE(opposites.areOpposite(0, 1));
  EXPECT_FALSE(opposites.areOpposite(2, 3));
  EXPECT_TRUE(opposites.areOpposite(0, 4));
}
