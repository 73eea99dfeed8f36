// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief an attribute at many points of one triangle
 */
#ifndef lambent_TriangleAttribute_h
#define lambent_TriangleAttribute_h

#include "PointBatch.h"
#include "SceneMesh.h"

namespace lambent
{
/// Calls store(valueOf), where valueOf(place, k) is component k of an attribute at a place of the
/// triangle. The same as TrianglePoints::attribute().
template <typename Store>
void visitTriangleAttribute(const AttributeSpan& values, const SceneMesh::Part& part,
  std::uint32_t number, const PointBatch& points, const Store& store)
{
  const Surface& surface = *part.surface;
  const std::size_t triangle = number - part.firstPrimitive;
  const auto components = static_cast<std::size_t>(values.components);
  values.visit(
    [&](const auto* all)
    {
      if (values.isPerCell)
      {
        const auto* const cell =
          all + components * static_cast<std::size_t>(surface.cellOf(triangle));
        store([cell](int, int k) { return static_cast<double>(cell[k]); });
        return;
      }
      const auto corner = [&](std::size_t k)
      { return all + components * surface.corners[3 * triangle + k]; };
      const auto *const a = corner(0), *const b = corner(1), *const c = corner(2);
      store(
        [&points, a, b, c](int place, int k)
        {
          const auto weighted = [&](const auto* values, int corner)
          { return static_cast<double>(values[k]) * points.weights[corner][place]; };
          return (weighted(a, 0) + weighted(b, 1)) + weighted(c, 2);
        });
    });
}
}

#endif
