// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the triangles that each tile must test, and its certain hits
 *
 * Each worker fills its own bins, without a lock. A bin is a list of pages, so that it grows
 * without moving its contents, and an empty bin has no page. The order of the items in a bin is
 * arbitrary. The nearest hit does not depend on it.
 */
#ifndef lambent_Bins_h
#define lambent_Bins_h

#include "Nearness.h"
#include "TileGrid.h"

#include <hwy/cache_control.h>

#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace lambent
{
/// A triangle by its number in the scene, and its box within the tile: the first and last step
/// along each axis, in units of the level.
struct BinEntry
{
  std::uint32_t triangle;
  std::uint8_t i0, i1, j0, j1;
};

/// A certain hit.
struct Fragment
{
  std::uint32_t triangle;
  std::uint32_t sample; ///< number within the tile
  Nearness nearness;
};

/// In bytes. Reading a page of this size hides the latency of fetching the next.
constexpr std::size_t pageSize = 1024;

template <typename Item>
struct Page
{
  static_assert(std::is_trivially_default_constructible_v<Item>, "new pages are not written to");

  static constexpr int capacity = static_cast<int>((pageSize - 8) / sizeof(Item));

  Page* next;
  Item items[capacity];
};

/// Numbered bins of items.
template <typename Item>
class PagedBins
{
public:
  static constexpr int pageCapacity = Page<Item>::capacity;

  explicit PagedBins(int bins)
    : Heads(bins)
  {
  }

  std::size_t pageCount(int bin) const { return this->Heads[bin].pages; }
  /// The number of pages in all bins.
  std::size_t pageCount() const { return this->Pages; }

  void clear()
  {
    std::fill(this->Heads.begin(), this->Heads.end(), Head{});
    this->Pages = 0;
  }

  // Only the item is written, since pages are seldom in the first-level cache.
  void append(int bin, const Item& item)
  {
    Head& head = this->Heads[bin];
    if (head.used == pageCapacity)
    {
      Page<Item>* page = this->newPage();
      page->next = head.page;
      head.page = page;
      head.used = 0;
      ++head.pages;
    }
    hwy::Prefetch(head.page->items + head.used + 8); // the next items are not in the cache yet
    head.page->items[head.used++] = item;
  }

  /// Calls body(items, count) for each page of a bin.
  template <typename Body>
  void forPages(int bin, Body&& body) const
  {
    const Head& head = this->Heads[bin];
    int count = head.used;
    for (const Page<Item>* page = head.page; page; page = page->next)
    {
      const auto* next = reinterpret_cast<const char*>(page->next);
      for (std::size_t line = 0; next && line < sizeof(Page<Item>); line += 64)
      {
        hwy::Prefetch(next + line);
      }
      body(page->items, count);
      count = pageCapacity;
    }
  }

private:
  struct Head
  {
    Page<Item>* page = nullptr;
    int used = pageCapacity; ///< items in the page; "full" while there is no page
    int pages = 0;
  };

  Page<Item>* newPage()
  {
    constexpr std::size_t pagesPerBlock = 256;
    const std::size_t block = this->Pages / pagesPerBlock;
    if (block == this->Blocks.size())
    {
      // make_unique would write to all of it.
      this->Blocks.emplace_back(new Page<Item>[pagesPerBlock]);
    }
    return &this->Blocks[block][this->Pages++ % pagesPerBlock];
  }

  std::vector<Head> Heads;
  std::vector<std::unique_ptr<Page<Item>[]>> Blocks;
  std::size_t Pages = 0;
};

/// The bins of one worker: triangles for the tiles of all levels, hits for the finest tiles.
class Bins
{
public:
  explicit Bins(const TileGrid& grid)
    : Grid(&grid)
    , Finest(grid.levels().front())
    , RowShift(grid.rowShift())
    , Triangles(grid.totalCount())
    , Hits(grid.tileCount())
  {
  }

  const PagedBins<BinEntry>& triangles() const { return this->Triangles; }
  const PagedBins<Fragment>& hits() const { return this->Hits; }
  std::size_t pageCount() const { return this->Triangles.pageCount() + this->Hits.pageCount(); }

  void clear()
  {
    this->Triangles.clear();
    this->Hits.clear();
  }

  /// Adds a triangle to the tiles that contain the samples of its box. If the box is exact, these
  /// may be finest tiles, so all boxes there are exact. Otherwise they are tiles of a coarser
  /// level.
  void insert(std::uint32_t triangle, const Window& rays, bool isExact)
  {
    const TileGrid::Level& level = this->Grid->levelFor(rays, isExact ? 0 : 1);
    const int size = level.size;
    for (int j = level.beginOf(rays.j0); j < rays.j1; j += size)
    {
      for (int i = level.beginOf(rays.i0); i < rays.i1; i += size)
      {
        const Window part = intersection(rays, this->Grid->window(level, i, j));
        const auto step = [&level](int ray)
        { return static_cast<std::uint8_t>(ray >> level.unitShift); };
        this->Triangles.append(level.tileAt(i, j),
          { triangle, step(part.i0 - i), step(part.i1 - 1 - i), step(part.j0 - j),
            step(part.j1 - 1 - j) });
      }
    }
  }

  /// Adds a hit of the sample (i, j) to its tile.
  void insertHit(int i, int j, std::uint32_t triangle, const Nearness& nearness)
  {
    const TileGrid::Level& level = this->Finest;
    if (level.shift >= 0)
    {
      const int inTile = level.size - 1;
      const int sample = ((j & inTile) << level.shift) + (i & inTile);
      this->Hits.append(
        level.tileAt(i, j), { triangle, static_cast<std::uint32_t>(sample), nearness });
      return;
    }
    const int sample = ((j - level.beginOf(j)) << this->RowShift) + (i - level.beginOf(i));
    this->Hits.append(
      level.tileAt(i, j), { triangle, static_cast<std::uint32_t>(sample), nearness });
  }

private:
  const TileGrid* Grid;
  const TileGrid::Level Finest;
  const int RowShift;
  PagedBins<BinEntry> Triangles;
  PagedBins<Fragment> Hits;
};
}

#endif
