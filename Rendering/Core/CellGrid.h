// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the rays of the image, grouped into square cells, on several levels
 *
 * The finest cells are the units of work: each casts and shades its rays alone.
 * A triangle that spans more than two of them along an axis is kept once, in a
 * cell of a coarser level that is eight times as wide, instead of in every fine
 * cell below; so no triangle is kept in more than four places, and one that
 * covers the whole image costs no more memory than a small one. A fine cell reads
 * its own triangles and those of the coarser cells above it.
 *
 * Sizes are powers of two, so that a ray's cell is found by shifting.
 */
#ifndef lambent_CellGrid_h
#define lambent_CellGrid_h

#include "Window.h"

#include <vector>

namespace lambent
{
class CellGrid
{
public:
  struct Level
  {
    int shift; ///< a cell is 2^shift rays wide
    int columns, rows;
    int first;     ///< number of the level's first cell, counted over all levels
    int unitShift; ///< boxes in a cell count in 2^unitShift rays, so that 256 steps do

    int cellAt(int i, int j) const
    {
      return this->first + (j >> this->shift) * this->columns + (i >> this->shift);
    }
  };

  /// A grid over width x height rays, with finest cells of 2^shift rays. Pixels
  /// count from 0 here. There are at least two levels.
  CellGrid(int width, int height, int shift)
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

  /// A finest cell's rays are numbered row by row, 2^rayShift() a row.
  int rayShift() const { return this->Levels[0].shift; }

  const Window& whole() const { return this->Whole; }
  const std::vector<Level>& levels() const { return this->Levels; }
  bool isFinest(const Level& level) const { return level.first == 0; }

  /// Of the finest level: the units of work.
  int cellCount() const { return this->Levels[0].columns * this->Levels[0].rows; }
  /// Over all levels.
  int totalCount() const { return this->Total; }

  /// The rays of the cell of a level that (i, j) is in, clipped to the image.
  Window window(const Level& level, int i, int j) const
  {
    const int i0 = i >> level.shift << level.shift, j0 = j >> level.shift << level.shift;
    return intersection({ i0, i0 + (1 << level.shift), j0, j0 + (1 << level.shift) }, this->Whole);
  }
  /// The rays of a finest cell.
  Window window(int cell) const
  {
    const Level& finest = this->Levels[0];
    return this->window(
      finest, cell % finest.columns << finest.shift, cell / finest.columns << finest.shift);
  }

  /// The finest level, from one on, on which rays fall into at most two by two cells.
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
