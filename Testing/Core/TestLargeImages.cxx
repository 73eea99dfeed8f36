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
    const std::uint32_t* const row = tile.hits.primitives() + j * tile.samples.stride();
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

TEST(LargeImages, LastTileIsHitOnAllLevels)
{
  constexpr int height = 3;
  const WideScene wide;
  const SceneMesh mesh(wide.scene.surfaces);
  const CameraFrame frame(wide.scene.camera, largest, height);
  const FrameMesh inFrame(mesh, frame);
  const auto memory = std::make_unique<CastingMemory>();
  for (const int size : { 16, 30, 32, 1023 })
  {
    const TileGrid grid(largest, height, size);
    const Casting<Nearest> casting(inFrame, grid);
    for (const TileGrid::Level& level : grid.levels())
    {
      const auto last = static_cast<std::uint8_t>((level.size - 1) >> level.unitShift);
      const BinEntry entry{ 0, 0, last, 0, last, std::numeric_limits<float>::infinity() };
      TileHits<Nearest> tile;
      tile.reset(frame, grid.whole(), grid, grid.window((largest - 1) / size));
      const int expected = tile.samples.window().width() * height;
      casting.castPlainly(&entry, 1, level, tile);
      EXPECT_EQ(hitsIn(tile), expected) << size << ", level of " << level.size;
      tile.reset(frame, grid.whole(), grid, grid.window((largest - 1) / size));
      casting.cast(&entry, 1, level, tile, *memory);
      casting.flush(tile, *memory);
      EXPECT_EQ(hitsIn(tile), expected) << size << ", level of " << level.size;
    }
  }
}

TEST(LargeImages, PartsAtTheRightEdgeAreRendered)
{
  constexpr int width = 47, height = 3;
  const WideScene wide;
  for (const int samples : { 1, 2, 3, 16 })
  {
    for (const bool hasKernels : { false, true })
    {
      std::vector<float> floats(3 * width * height);
      std::vector<std::uint32_t> triangles(width * height, noPrimitive);
      Image image;
      image.width = largest / samples;
      image.height = height;
      image.part = { image.width - width, image.width, 0, height };
      image.samples = samples;
      image.floats = floats.data();
      image.primitives = triangles.data();
      Settings settings;
      settings.kernels = hasKernels;
      EXPECT_EQ(render(wide.scene, image, Parallel(), nullptr, settings).outcome, Outcome::Done);
      EXPECT_EQ(std::count(triangles.begin(), triangles.end(), 0u), width * height);
    }
  }
}
