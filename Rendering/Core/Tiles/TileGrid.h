// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief groups the samples of the image into square tiles, on several levels
 *
 * The finest tiles are the units of work: the samples of each are cast and shaded independently. A
 * primitive that spans more than two of them along an axis is stored on a coarser level, whose
 * tiles are eight times as wide, instead of in every fine tile below. So no primitive is stored in
 * more than four places, and one that covers the whole image needs no more memory than a small one.
 * A fine tile reads its own primitives and those of the coarser tiles above it. So tiles must
 * consist of whole finer tiles. The coarsest is only two or four times as wide where eight times
 * would not fit an int.
 *
 * A tile holds whole pixels. If its size is a power of two, a shift finds the tile of a sample.
 */
#ifndef lambent_TileGrid_h
#define lambent_TileGrid_h

#include "Window.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace lambent
{
class TileGrid
{
public:
  struct Level
  {
    int size;  ///< of a tile, in samples
    int shift; ///< log2 of the size, or -1 if it is no power of two
    int columns, rows;
    int first;     ///< number of the level's first tile, counted over all levels
    int unitShift; ///< boxes use units of 2^unitShift samples, so that 256 steps suffice

    /// Along an axis: the tile of a sample, and the first sample of that tile.
    int tileOf(int k) const { return this->shift >= 0 ? k >> this->shift : k / this->size; }
    int beginOf(int k) const { return this->tileOf(k) * this->size; }

    int tileAt(int i, int j) const
    {
      return this->first + this->tileOf(j) * this->columns + this->tileOf(i);
    }
  };

  /// A grid over width x height samples, with finest tiles of size x size samples. Samples are
  /// counted from 0 here. There are at least two levels.
  TileGrid(int width, int height, int size)
    : Whole{ 0, width, 0, height }
  {
    constexpr int coarser = 8;
    for (std::int64_t next = size, first = 0;
         this->Levels.size() < 2 || this->Levels.back().columns > 2 || this->Levels.back().rows > 2;
         next *= coarser)
    {
      while (next > std::numeric_limits<int>::max())
      {
        next /= 2;
      }
      this->addLevel(static_cast<int>(next), static_cast<int>(first));
      first += static_cast<std::int64_t>(this->Levels.back().columns) * this->Levels.back().rows;
      this->Total = static_cast<int>(first);
    }
    while (1 << this->RowShift < size)
    {
      ++this->RowShift;
    }
  }

  /// The samples of a finest tile are numbered row by row, 2^rowShift() per row.
  int rowShift() const { return this->RowShift; }

  const Window& whole() const { return this->Whole; }
  const std::vector<Level>& levels() const { return this->Levels; }
  bool isFinest(const Level& level) const { return level.first == 0; }

  /// The number of finest tiles, the units of work.
  int tileCount() const { return this->Levels[0].columns * this->Levels[0].rows; }
  /// The number of tiles on all levels.
  int totalCount() const { return this->Total; }

  /// The samples of the tile that contains (i, j) on a level, clipped to the image.
  Window window(const Level& level, int i, int j) const
  {
    return this->windowFrom(level, level.beginOf(i), level.beginOf(j));
  }
  /// The samples of a finest tile.
  Window window(int tile) const
  {
    const Level& finest = this->Levels[0];
    return this->windowFrom(
      finest, tile % finest.columns * finest.size, tile / finest.columns * finest.size);
  }

  /// The finest level, starting at `from`, on which the samples fall into at most two by two tiles.
  const Level& levelFor(const Window& samples, std::size_t from = 0) const
  {
    while (spans(samples, this->Levels[from]))
    {
      ++from;
    }
    return this->Levels[from];
  }

private:
  void addLevel(int size, int first)
  {
    Level level{ size, -1, (this->Whole.i1 - 1) / size + 1, (this->Whole.j1 - 1) / size + 1, first,
      0 };
    for (int shift = 0; shift < 31; ++shift)
    {
      level.shift = 1 << shift == size ? shift : level.shift;
    }
    while ((size - 1) >> level.unitShift > 255)
    {
      ++level.unitShift;
    }
    this->Levels.push_back(level);
  }

  Window windowFrom(const Level& level, int i0, int j0) const
  {
    return { i0, i0 + std::min(level.size, this->Whole.i1 - i0), j0,
      j0 + std::min(level.size, this->Whole.j1 - j0) };
  }

  static bool spans(const Window& samples, const Level& level)
  {
    return level.tileOf(samples.i1 - 1) - level.tileOf(samples.i0) > 1 ||
      level.tileOf(samples.j1 - 1) - level.tileOf(samples.j0) > 1;
  }

  Window Whole;
  std::vector<Level> Levels;
  int Total = 0;
  int RowShift = 0;
};
}

#endif
