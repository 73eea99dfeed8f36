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
    int cellSize; ///< in rays
    int columns, rows;
    int first; ///< number of the level's first cell, counted over all levels
    int unit;  ///< rays to a step of the boxes in a cell, so that 256 steps do
  };

  /// A grid over width x height rays. Pixels count from 0 here.
  CellGrid(int width, int height, int cellSize)
    : Whole{ 0, width, 0, height }
  {
    constexpr int coarser = 8;
    int first = 0;
    for (int size = cellSize;; size *= coarser)
    {
      const int columns = (width + size - 1) / size, rows = (height + size - 1) / size;
      this->Levels.push_back({ size, columns, rows, first, (size + 255) / 256 });
      first += columns * rows;
      if (columns <= 2 && rows <= 2)
      {
        break;
      }
    }
    this->Total = first;
  }

  const Window& whole() const { return this->Whole; }
  const std::vector<Level>& levels() const { return this->Levels; }

  /// Of the finest level: the units of work.
  int cellCount() const { return this->Levels[0].columns * this->Levels[0].rows; }
  /// Over all levels.
  int totalCount() const { return this->Total; }

  /// The rays of a cell, clipped to the image.
  Window window(const Level& level, int column, int row) const
  {
    const int i0 = column * level.cellSize, j0 = row * level.cellSize;
    return intersection({ i0, i0 + level.cellSize, j0, j0 + level.cellSize }, this->Whole);
  }
  Window window(int cell) const
  {
    const Level& finest = this->Levels[0];
    return this->window(finest, cell % finest.columns, cell / finest.columns);
  }

  /// The finest level on which rays fall into at most two by two cells.
  const Level& levelFor(const Window& rays) const
  {
    std::size_t l = 0;
    while (spans(rays, this->Levels[l].cellSize))
    {
      ++l;
    }
    return this->Levels[l];
  }

private:
  static bool spans(const Window& rays, int size)
  {
    return (rays.i1 - 1) / size - rays.i0 / size > 1 || (rays.j1 - 1) / size - rays.j0 / size > 1;
  }

  Window Whole;
  std::vector<Level> Levels;
  int Total = 0;
};
}

#endif
