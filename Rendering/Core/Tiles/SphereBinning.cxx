// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SphereBinning.h"

#include <algorithm>
#include <limits>

namespace lambent
{
namespace
{
/// Copies a batch of spheres.
template <typename Coordinate>
void copy(const Coordinate* points, const Surface& surface, std::size_t begin,
  std::size_t perSphere, SphereBoxes& boxes)
{
  for (int k = 0; k < boxes.count; ++k)
  {
    const std::size_t sphere = (begin + k) / perSphere;
    const Coordinate* const point = points + 3 * sphere;
    for (int axis = 0; axis < 3; ++axis)
    {
      boxes.centers[axis][k] = point[axis];
    }
    boxes.radii[k] = surface.radiusOf(sphere);
  }
}
}

void SphereBinning::add(const SceneMesh::Part& part, std::size_t begin, std::size_t end,
  SphereBoxes& boxes, BinningResult& result) const
{
  const TupleSpan points = part.points();
  const std::size_t sides = part.surface->primitivesPerSphere();
  for (std::size_t next = begin; begin < end; begin = next)
  {
    next = std::min<std::size_t>(end, begin + SphereBoxes::capacity);
    boxes.count = static_cast<int>(next - begin);
    points.isDouble
      ? copy(static_cast<const double*>(points.data), *part.surface, begin, sides, boxes)
      : copy(static_cast<const float*>(points.data), *part.surface, begin, sides, boxes);
    if (this->HasBoxes)
    {
      findSphereBoxes(this->Lattice, boxes);
    }
    for (int k = 0; k < boxes.count; ++k)
    {
      this->insert(part, begin + k, boxes, k, result);
    }
  }
}

void SphereBinning::insert(const SceneMesh::Part& part, std::size_t primitive,
  const SphereBoxes& boxes, int place, BinningResult& result) const
{
  const auto number = static_cast<std::uint32_t>(part.firstPrimitive + primitive);
  if (this->HasBoxes && !std::isnan(boxes.nearest[place]))
  {
    const Window box{ boxes.i0[place], boxes.i1[place], boxes.j0[place], boxes.j1[place] };
    if (!box.empty() && boxes.radii[place] > 0.0)
    {
      result.shallowArea -= static_cast<std::int64_t>(box.width()) * box.height();
      result.bins.insert(number, box, true,
        result.shallowArea < 0 ? nearnessOf(boxes.nearest[place], this->Frame.parallel).high
                               : std::numeric_limits<float>::infinity());
    }
  }
  else if (!isFinite(part.points()[part.sphereOf(number)]))
  {
    // An outside and an inside count once.
    result.defects.notFinite += !part.isTransparent() || primitive % 2 == 0;
    result.defects.firstNotFinite = std::min(result.defects.firstNotFinite, number);
  }
  else if (boxes.radii[place] > 0.0)
  {
    result.bins.insert(number, this->Grid.whole(), true, std::numeric_limits<float>::infinity());
  }
}
}
