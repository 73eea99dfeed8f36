// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which triangles each cell has to test
 *
 * Each worker fills bins of its own, one for each cell of each level, without a
 * lock. A bin is a list of small pages, so that it grows without moving what it
 * holds and an empty one costs a pointer. The order in which triangles stand in a
 * bin is left to chance; the nearest hit does not depend on it.
 */
#ifndef lambent_Bins_h
#define lambent_Bins_h

#include "CellGrid.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace lambent
{
/// A triangle by its number in the scene, and its box within the cell: first and
/// last step along each axis, in the level's units.
struct BinEntry
{
  std::uint32_t triangle;
  std::uint8_t i0, i1, j0, j1;
};

struct BinPage
{
  static constexpr int capacity = 30; // 256 bytes

  BinPage* next;
  int count;
  BinEntry entries[capacity];
};

/// The bins of one worker.
class Bins
{
public:
  explicit Bins(const CellGrid& grid)
    : Grid(&grid)
    , Heads(grid.totalCount())
  {
  }

  const BinPage* pages(int cell) const { return this->Heads[cell].page; }
  std::size_t pageCount(int cell) const { return this->Heads[cell].count; }
  /// Over all cells.
  std::size_t pageCount() const { return this->Pages; }

  void clear()
  {
    std::fill(this->Heads.begin(), this->Heads.end(), Head{});
    this->Pages = 0;
  }

  /// Hand a triangle to the cells that its rays fall into: of the finest level if
  /// the box of rays is exact, so that there each entry's box is; else of a coarser.
  void insert(std::uint32_t triangle, const Window& rays, bool isExact)
  {
    const CellGrid::Level& finest = this->Grid->levels().front();
    const int cell = finest.cellAt(rays.i0, rays.j0), mask = (1 << finest.shift) - 1;
    if (isExact && cell == finest.cellAt(rays.i1 - 1, rays.j1 - 1) && finest.shift <= 8)
    {
      const auto step = [mask](int ray) { return static_cast<std::uint8_t>(ray & mask); };
      this->append(
        cell, { triangle, step(rays.i0), step(rays.i1 - 1), step(rays.j0), step(rays.j1 - 1) });
      return;
    }
    const CellGrid::Level& level = this->Grid->levelFor(rays, isExact ? 0 : 1);
    const int size = 1 << level.shift;
    for (int j = rays.j0 >> level.shift << level.shift; j < rays.j1; j += size)
    {
      for (int i = rays.i0 >> level.shift << level.shift; i < rays.i1; i += size)
      {
        const Window part = intersection(rays, { i, i + size, j, j + size });
        const auto step = [&level](int ray)
        { return static_cast<std::uint8_t>(ray >> level.unitShift); };
        this->append(level.cellAt(i, j),
          { triangle, step(part.i0 - i), step(part.i1 - 1 - i), step(part.j0 - j),
            step(part.j1 - 1 - j) });
      }
    }
  }

private:
  struct Head
  {
    BinPage* page = nullptr;
    std::uint32_t count = 0; ///< of pages
  };

  void append(int cell, const BinEntry& entry)
  {
    Head& head = this->Heads[cell];
    if (!head.page || head.page->count == BinPage::capacity)
    {
      BinPage* page = this->newPage();
      page->next = head.page;
      page->count = 0;
      head.page = page;
      ++head.count;
    }
    head.page->entries[head.page->count++] = entry;
  }

  BinPage* newPage()
  {
    constexpr std::size_t pagesPerBlock = 1024;
    const std::size_t block = this->Pages / pagesPerBlock;
    if (block == this->Blocks.size())
    {
      // Not make_unique, which would write over all of it.
      this->Blocks.emplace_back(new BinPage[pagesPerBlock]);
    }
    return &this->Blocks[block][this->Pages++ % pagesPerBlock];
  }

  const CellGrid* Grid;
  std::vector<Head> Heads;
  std::vector<std::unique_ptr<BinPage[]>> Blocks;
  std::size_t Pages = 0;
};
}

#endif
