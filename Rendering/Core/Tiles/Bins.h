// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the primitives that each tile must test, and its certain hits
 *
 * Each worker fills its own bins, without a lock. A bin is a list of pages, so that it grows
 * without moving its contents, and an empty bin has no page. The order of the items in a bin is
 * arbitrary. The nearest hit does not depend on it.
 */
#ifndef lambent_Bins_h
#define lambent_Bins_h

#include "HugePages.h"
#include "Nearness.h"
#include "TileGrid.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace lambent
{
/// A primitive by its number in the scene, and its box within the tile: the first and last step
/// along each axis, in units of the level.
struct BinEntry
{
  std::uint32_t primitive;
  std::uint8_t i0, i1, j0, j1;
  float nearest; ///< no hit is nearer
};

/// A certain hit.
struct Fragment
{
  std::uint32_t primitive;
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
    this->Pages = this->UsedBlocks = 0;
    this->Next = this->End = nullptr;
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
    if (this->Next == this->End)
    {
      this->nextBlock();
    }
    ++this->Pages;
    return this->Next++;
  }

  // The first block is small, since few pictures need more.
  void nextBlock()
  {
    const std::size_t count = this->UsedBlocks == 0 ? 256 : 4096;
    if (this->UsedBlocks == this->Blocks.size())
    {
      // make_unique would write to all of it.
      this->Blocks.emplace_back(new Page<Item>[count]);
      useHugePages(this->Blocks.back().get(), count * sizeof(Page<Item>));
    }
    this->Next = this->Blocks[this->UsedBlocks++].get();
    this->End = this->Next + count;
  }

  std::vector<Head> Heads;
  std::vector<std::unique_ptr<Page<Item>[]>> Blocks;
  std::size_t UsedBlocks = 0, Pages = 0;
  Page<Item>* Next = nullptr; ///< of the last block used
  Page<Item>* End = nullptr;
};

/// The bins of one worker: primitives for the tiles of all levels, hits for the finest tiles.
class Bins
{
public:
  explicit Bins(const TileGrid& grid)
    : Grid(&grid)
    , Finest(grid.levels().front())
    , RowShift(grid.rowShift())
    , Primitives(grid.totalCount())
    , Hits(grid.tileCount())
  {
  }

  const PagedBins<BinEntry>& primitives() const { return this->Primitives; }
  const PagedBins<Fragment>& hits() const { return this->Hits; }
  std::size_t pageCount() const { return this->Primitives.pageCount() + this->Hits.pageCount(); }

  void clear()
  {
    this->Primitives.clear();
    this->Hits.clear();
  }

  /// Adds a primitive to the tiles that contain samples of its box; `nearest` as in BinEntry. If
  /// the box is exact, these may be finest tiles, where the boxes of triangles are all exact.
  /// Otherwise they are tiles of a coarser level. Boxes of spheres and lines count as exact.
  void insert(std::uint32_t primitive, const Window& samples, bool isExact, float nearest)
  {
    const TileGrid::Level level = this->Grid->levelFor(samples, isExact ? 0 : 1);
    const int firstColumn = level.tileOf(samples.i0), lastColumn = level.tileOf(samples.i1 - 1);
    const int firstRow = level.tileOf(samples.j0), lastRow = level.tileOf(samples.j1 - 1);
    const auto step = [&level](int sample)
    { return static_cast<std::uint8_t>(sample >> level.unitShift); };
    for (int row = firstRow; row <= lastRow; ++row)
    {
      const int j = row * level.size;
      const std::uint8_t j0 = step(std::max(samples.j0 - j, 0));
      const std::uint8_t j1 = step(std::min(samples.j1 - j, level.size) - 1);
      for (int column = firstColumn; column <= lastColumn; ++column)
      {
        const int i = column * level.size;
        this->Primitives.append(level.first + row * level.columns + column,
          { primitive, step(std::max(samples.i0 - i, 0)),
            step(std::min(samples.i1 - i, level.size) - 1), j0, j1, nearest });
      }
    }
  }

  /// A certain hit of the sample (i, j).
  struct SampleHit
  {
    int i, j;
    std::uint32_t primitive;
    Nearness nearness;
  };

  /// Adds the hits hitOf(0) to hitOf(count - 1) to their tiles.
  template <typename HitOf>
  void insertHits(int count, const HitOf& hitOf)
  {
    const TileGrid::Level level = this->Finest; // a copy, so that it stays in registers
    if (level.shift >= 0)
    {
      const int columns = level.columns, shift = level.shift, inTile = level.size - 1;
      for (int k = 0; k < count; ++k)
      {
        const SampleHit hit = hitOf(k);
        const int sample = ((hit.j & inTile) << shift) + (hit.i & inTile);
        this->Hits.append((hit.j >> shift) * columns + (hit.i >> shift),
          { hit.primitive, static_cast<std::uint32_t>(sample), hit.nearness });
      }
      return;
    }
    const int rowShift = this->RowShift;
    for (int k = 0; k < count; ++k)
    {
      const SampleHit hit = hitOf(k);
      const int sample =
        ((hit.j - level.beginOf(hit.j)) << rowShift) + (hit.i - level.beginOf(hit.i));
      this->Hits.append(level.tileAt(hit.i, hit.j),
        { hit.primitive, static_cast<std::uint32_t>(sample), hit.nearness });
    }
  }
  void insertHit(const SampleHit& hit)
  {
    this->insertHits(1, [&hit](int) { return hit; });
  }

private:
  const TileGrid* Grid;
  const TileGrid::Level Finest;
  const int RowShift;
  PagedBins<BinEntry> Primitives;
  PagedBins<Fragment> Hits;
};
}

#endif
