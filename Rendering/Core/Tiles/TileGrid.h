// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the rays of the image, grouped into square tiles, on several levels
 *
 * The finest tiles are the units of work: each casts and shades its rays alone.
 * A triangle that spans more than two of them along an axis is kept once, in a
 * tile of a coarser level that is eight times as wide, instead of in every fine
 * tile below; so no triangle is kept in more than four places, and one that
 * covers the whole image costs no more memory than a small one. A fine tile reads
 * its own triangles and those of the coarser tiles above it.
 *
 * Sizes are powers of two, so that a ray's tile is found by shifting.
 */
#ifndef lambent_TileGrid_h
#define lambent_TileGrid_h

#include "Window.h"

#include <vector>

namespace lambent
{
class TileGrid
{
public:
  struct Level
  {
    int shift; ///< a tile is 2^shift rays wide
    int columns, rows;
    int first;     ///< number of the level's first tile, counted over all levels
    int unitShift; ///< boxes in a tile count in 2^unitShift rays, so that 256 steps do

    int tileAt(int i, int j) const
    {
      return this->first + (j >> this->shift) * this->columns + (i >> this->shift);
    }
  };

  /// A grid over width x height rays, with finest tiles of 2^shift rays. Pixels
  /// count from 0 here. There are at least two levels.
  TileGrid(int width, int height, int shift)
    : Whole{ 0, width, 0, height }
  {
    constexpr int coarser = 3;
    for (int first = 0;
         this->Levels.size() < 2 || this->Levels.back().columns > 2 || this->Levels.back().rows > 2;
         shift += coarser)
    {
      const int columns = ((width - 1) >> shift) + 1, rows = ((height - 1) >> shift) + 1;
      this->Levels.push_back({ shift, columns, rows, first, std::max(0, shift - 8) });
      first += columns * rows;
      this->Total = first;
    }
  }

  /// A finest tile's rays are numbered row by row, 2^rayShift() a row.
  int rayShift() const { return this->Levels[0].shift; }

  const Window& whole() const { return this->Whole; }
  const std::vector<Level>& levels() const { return this->Levels; }
  bool isFinest(const Level& level) const { return level.first == 0; }

  /// Of the finest level: the units of work.
  int tileCount() const { return this->Levels[0].columns * this->Levels[0].rows; }
  /// Over all levels.
  int totalCount() const { return this->Total; }

  /// The rays of the tile of a level that (i, j) is in, clipped to the image.
  Window window(const Level& level, int i, int j) const
  {
    const int i0 = i >> level.shift << level.shift, j0 = j >> level.shift << level.shift;
    return intersection({ i0, i0 + (1 << level.shift), j0, j0 + (1 << level.shift) }, this->Whole);
  }
  /// The rays of a finest tile.
  Window window(int tile) const
  {
    const Level& finest = this->Levels[0];
    return this->window(
      finest, tile % finest.columns << finest.shift, tile / finest.columns << finest.shift);
  }

  /// The finest level, from one on, on which rays fall into at most two by two tiles.
  const Level& levelFor(const Window& rays, std::size_t from = 0) const
  {
    while (spans(rays, this->Levels[from].shift))
    {
      ++from;
    }
    return this->Levels[from];
  }

private:
  static bool spans(const Window& rays, int shift)
  {
    return ((rays.i1 - 1) >> shift) - (rays.i0 >> shift) > 1 ||
      ((rays.j1 - 1) >> shift) - (rays.j0 >> shift) > 1;
  }

  Window Whole;
  std::vector<Level> Levels;
  int Total = 0;
};
}

#endif
