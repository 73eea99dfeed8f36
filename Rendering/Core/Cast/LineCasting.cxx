// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineCasting.h"

#include "LineBounds.h"

namespace lambent
{
namespace
{
/// Finds the columns of a tile that lie in an interval of the image plane, and perhaps one more on
/// each side.
class Columns
{
public:
  Columns(const TileSamples& samples, double pixel)
    : First(samples.xs()[0])
    , PerPixel(1.0 / pixel)
  {
  }

  struct Range
  {
    int begin, end;
  };

  /// Within the columns of a box. All of them where positions could be off by a column.
  Range in(const Interval& x, const Window& box) const
  {
    constexpr double largest = 1e12;
    const double low = (x.low - this->First) * this->PerPixel - 1.0;
    const double high = (x.high - this->First) * this->PerPixel + 2.0;
    const double size = std::max(std::fabs(x.low), std::fabs(x.high)) + std::fabs(this->First);
    if (!(size * this->PerPixel < largest))
    {
      return { box.i0, box.i1 };
    }
    return { low > box.i0 ? static_cast<int>(std::min<double>(low, box.i1)) : box.i0,
      high < box.i1 ? static_cast<int>(std::max<double>(high, box.i0)) : box.i1 };
  }

private:
  double First, PerPixel;
};
}

template <typename Policy>
void LineCasting<Policy>::cast(const NextPrimitive* lines, int count, TileHits<Policy>& tile) const
{
  for (int k = 0; k < count; ++k)
  {
    const FrameLine line = this->Mesh.line(*lines[k].part, lines[k].waiting->number);
    if (line.isDrawn)
    {
      this->cast(*lines[k].waiting, line, tile);
    }
  }
}

template <typename Policy>
void LineCasting<Policy>::cast(
  const WaitingPrimitive& waiting, const FrameLine& line, TileHits<Policy>& tile) const
{
  const TileSamples& samples = tile.samples;
  const double *const xs = samples.xs(), *const ys = samples.ys();
  const CameraFrame& frame = this->Mesh.frame();
  const Window& box = waiting.box;
  const LineBounds bounds(line.line);
  if (bounds.misses({ xs[box.i0], xs[box.i1 - 1] }, { ys[box.j0], ys[box.j1 - 1] }))
  {
    return;
  }
  const Columns columns(samples, frame.pixel);
  for (int j = box.j0; j < box.j1; ++j)
  {
    const Columns::Range range = columns.in(bounds.inRow(ys[j]), box);
    for (int i = range.begin; i < range.end; ++i)
    {
      double depth;
      if (line.isHit(xs[i], ys[j], depth))
      {
        tile.hits.offer(static_cast<std::size_t>(j) * samples.stride() + i, waiting.number,
          nearnessOf(depth, frame.parallel), depth, depthIn(this->Mesh, samples));
      }
    }
  }
}

template class LineCasting<Nearest>;
}
