// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineBinning.h"

#include "LineBounds.h"

#include <limits>

namespace lambent
{
namespace
{
/// The samples of an interval along an axis: from the first up to, but not including, the end. All
/// of them for NaN.
struct Samples
{
  int begin, end;

  Samples(const PointLattice::Axis& axis, double perUnit, const Interval& interval)
  {
    const double last = axis.count;
    const double left = (interval.low * perUnit + axis.origin) - axis.margin;
    const double right = (interval.high * perUnit + axis.origin) + axis.margin;
    this->begin = static_cast<int>(left > 0.0 ? std::min(std::ceil(left), last) : 0.0);
    this->end =
      static_cast<int>(right < last - 1.0 ? std::max(std::floor(right) + 1.0, 0.0) : last);
  }
};

bool hasFiniteEnds(const Surface& surface, std::size_t line)
{
  return isFinite(surface.points[surface.corners[2 * line]]) &&
    isFinite(surface.points[surface.corners[2 * line + 1]]);
}

/// Whether no line before this one belongs to the same cell and is not finite, either.
bool isFirstOfCell(const Surface& surface, std::size_t line)
{
  const std::int64_t cell = surface.cellOf(line);
  while (line > 0 && surface.cellOf(line - 1) == cell)
  {
    --line;
    const bool exists =
      std::max(surface.corners[2 * line], surface.corners[2 * line + 1]) < surface.points.size;
    if (!exists || !hasFiniteEnds(surface, line))
    {
      return false;
    }
  }
  return true;
}
}

void LineBinning::add(
  const SceneMesh::Part& part, std::size_t begin, std::size_t end, BinningResult& result) const
{
  const Surface& surface = *part.surface;
  for (std::size_t line = begin; line < end; ++line)
  {
    const auto number = static_cast<std::uint32_t>(part.firstPrimitive + line);
    if (std::max(surface.corners[2 * line], surface.corners[2 * line + 1]) >= surface.points.size)
    {
      result.defects.wrongCorner = std::min(result.defects.wrongCorner, number);
    }
    else if (!hasFiniteEnds(surface, line))
    {
      result.defects.notFinite += isFirstOfCell(surface, line);
      result.defects.firstNotFinite = std::min(result.defects.firstNotFinite, number);
    }
    else
    {
      this->insert(number, this->Mesh.line(part, number), result);
    }
  }
}

void LineBinning::insert(std::uint32_t number, const FrameLine& line, BinningResult& result) const
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  if (!this->HasBoxes)
  {
    result.bins.insert(number, this->Grid.whole(), true, infinity);
    return;
  }
  if (!line.isDrawn || (line.line.az <= 0.0 && line.line.bz <= 0.0))
  {
    return;
  }
  const LineBounds bounds(line.line);
  const double perUnit = this->Lattice.samplesPerUnit();
  const Samples columns(this->Lattice.columns(), perUnit, bounds.x());
  const Samples rows(this->Lattice.rows(), perUnit, bounds.y());
  const Window box{ columns.begin, columns.end, rows.begin, rows.end };
  if (!box.empty())
  {
    result.shallowArea -= static_cast<std::int64_t>(box.width()) * box.height();
    result.bins.insert(number, box, true,
      result.shallowArea < 0 ? nearnessOf(bounds.nearest(), this->Mesh.frame().parallel).high
                             : infinity);
  }
}
}
