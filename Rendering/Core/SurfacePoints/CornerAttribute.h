// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief an attribute at many points of one triangle or line
 */
#ifndef lambent_CornerAttribute_h
#define lambent_CornerAttribute_h

#include "PointBatch.h"
#include "SceneMesh.h"

namespace lambent
{
/// Calls store(valueOf), where valueOf(place, k) is component k of an attribute at a place of a
/// primitive with so many corners. The same as TrianglePoints::attribute() and
/// LinePoints::attribute().
template <std::size_t Corners, typename Store>
void visitCornerAttribute(const AttributeSpan& values, const SceneMesh::Part& part,
  std::uint32_t number, const PointBatch& points, const Store& store)
{
  static_assert(Corners == 2 || Corners == 3);
  const Surface& surface = *part.surface;
  const std::size_t primitive = number - part.firstPrimitive;
  const auto components = static_cast<std::size_t>(values.components);
  values.visit(
    [&](const auto* all)
    {
      if (values.isPerCell)
      {
        const auto* const cell =
          all + components * static_cast<std::size_t>(surface.cellOf(primitive));
        store([cell](int, int k) { return static_cast<double>(cell[k]); });
        return;
      }
      const auto corner = [&](std::size_t k)
      { return all + components * surface.corners[Corners * primitive + k]; };
      const auto *const a = corner(0), *const b = corner(1), *const c = corner(Corners - 1);
      store(
        [&points, a, b, c](int place, int k)
        {
          const auto weighted = [&](const auto* values, int corner)
          { return static_cast<double>(values[k]) * points.weights[corner][place]; };
          const double ofTwo = weighted(a, 0) + weighted(b, 1);
          return Corners == 2 ? ofTwo : ofTwo + weighted(c, 2);
        });
    });
}
}

#endif
