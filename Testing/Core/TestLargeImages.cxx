// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Images of the largest size, 2147483647 samples along an axis, whose numbers of samples just fit
// an int. Some errors show only in a build with the sanitizer of undefined behaviour.
#include "Casting.h"
#include "VisibleTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

using namespace lambent;

namespace
{
constexpr int largest = std::numeric_limits<int>::max();

/// A triangle that covers a very wide image.
struct WideScene
{
  double points[9] = { -9e9, -9.0, 0.0, 9e9, -9.0, 0.0, 0.0, 9.0, 0.0 };
  std::int32_t corners[3] = { 0, 1, 2 };
  Scene scene;

  WideScene()
  {
    Surface surface;
    surface.points = { this->points, true, 3 };
    surface.corners = { this->corners, false, 3 };
    this->scene.surfaces.push_back(surface);
    this->scene.camera.parallel = true;
    this->scene.camera.parallelScale = 1.0;
  }
};

int hitsIn(const TileHits<Nearest>& tile)
{
  int hits = 0;
  const Window& window = tile.samples.window();
  for (int j = 0; j < window.height(); ++j)
  {
    const std::uint32_t* const row = tile.hits.triangles() + j * tile.samples.stride();
    hits += static_cast<int>(std::count(row, row + window.width(), 0u));
  }
  return hits;
}
}

TEST(LargeImages, CoarseTilesConsistOfWholeFinerTiles)
{
  for (const int size : { 1, 2, 11, 16, 21, 24, 25, 26, 27, 28, 30, 32, 63, 1023 })
  {
    for (const int width : { 1, 33, 1000, 123456789, (1 << 30) + 1, largest })
    {
      const std::vector<TileGrid::Level> levels = TileGrid(width, 3, size).levels();
      ASSERT_GE(levels.size(), 2u);
      for (std::size_t k = 1; k < levels.size(); ++k)
      {
        EXPECT_GT(levels[k].size, levels[k - 1].size);
        EXPECT_EQ(levels[k].size % levels[k - 1].size, 0) << size << ", level " << k;
        EXPECT_LE((levels[k].size - 1) >> levels[k].unitShift, 255) << size << ", level " << k;
      }
      EXPECT_LE(levels.back().columns, 2) << size << ", " << width;
    }
  }
}
