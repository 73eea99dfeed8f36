// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief typed views of cells and points
 *
 * CellSpan and TupleSpan know their number types only at run time. visit() calls a loop with
 * views of the right types, so the choice is made once and not for each cell.
 */
#ifndef lambent_CellView_h
#define lambent_CellView_h

#include "Spans.h"

#include <cstddef>
#include <cstdint>

namespace lambent
{
inline std::size_t cellCount(const CellSpan& cells)
{
  return cells.offsets.size > 0 ? cells.offsets.size - 1 : 0;
}

/// Cell i has the corners offsets[i] to offsets[i + 1] - 1; each uses a point.
template <typename Id>
struct CellView
{
  const Id* offsets;
  const Id* corners;

  const Id* cell(std::size_t i) const { return this->corners + this->offsets[i]; }
  std::size_t cellSize(std::size_t i) const
  {
    return static_cast<std::size_t>(this->offsets[i + 1] - this->offsets[i]);
  }
};

/// Points of three floats or doubles; all arithmetic is done in double.
template <typename Coordinate>
struct PointView
{
  const Coordinate* coordinates;

  template <typename Id>
  Vec3 operator[](Id i) const
  {
    const Coordinate* p = this->coordinates + 3 * static_cast<std::size_t>(i);
    return { static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]) };
  }
};

/// Calls loop(CellView<Id>).
template <typename Loop>
void visit(const CellSpan& cells, Loop&& loop)
{
  if (cells.offsets.is64Bit)
  {
    loop(CellView<std::int64_t>{ static_cast<const std::int64_t*>(cells.offsets.data),
      static_cast<const std::int64_t*>(cells.connectivity.data) });
  }
  else
  {
    loop(CellView<std::int32_t>{ static_cast<const std::int32_t*>(cells.offsets.data),
      static_cast<const std::int32_t*>(cells.connectivity.data) });
  }
}

/// Calls loop(PointView<Coordinate>, CellView<Id>).
template <typename Loop>
void visit(const TupleSpan& points, const CellSpan& cells, Loop&& loop)
{
  visit(cells,
    [&](auto cellView)
    {
      if (points.isDouble)
      {
        loop(PointView<double>{ static_cast<const double*>(points.data) }, cellView);
      }
      else
      {
        loop(PointView<float>{ static_cast<const float*>(points.data) }, cellView);
      }
    });
}
}

#endif
