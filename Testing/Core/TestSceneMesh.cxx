// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that several workers read are numbered as if one had read them in order.
#include "SceneMesh.h"

#include "RandomNumbers.h"
#include "ThreadedParallel.h"

#include <gtest/gtest.h>

using namespace lambent;

namespace
{
/// Surfaces of up to three triangles and points. Neighbours often have the same appearance.
std::vector<Surface> makeSurfaces(std::size_t count)
{
  static const std::int32_t corners[9] = {};
  static const float points[9] = {};
  RandomNumbers random(static_cast<unsigned int>(count));
  std::vector<Surface> surfaces(count);
  double diffuse = 1.0;
  for (Surface& surface : surfaces)
  {
    surface.corners = { corners, false, 3 * static_cast<std::size_t>(random.below(4)) };
    surface.points = { points, false, static_cast<std::size_t>(random.below(4)) };
    diffuse = random.below(3000) == 0 ? random.within(0.0, 1.0) : diffuse;
    surface.appearance.diffuse = diffuse;
  }
  return surfaces;
}

void compare(const std::vector<Surface>& surfaces, const Parallel& parallel)
{
  const SceneMesh mesh(surfaces, parallel);
  std::size_t primitive = 0, point = 0;
  const Appearance* appearance = nullptr;
  for (const Surface& surface : surfaces)
  {
    if (!appearance || !appearance->isSameAs(surface.appearance))
    {
      appearance = &surface.appearance;
    }
    for (std::size_t k = 0; k < surface.primitiveCount(); ++k, ++primitive)
    {
      const SceneMesh::Part& part = mesh.partOf(primitive);
      ASSERT_EQ(part.surface, &surface) << primitive;
      ASSERT_EQ(part.firstPrimitive, primitive - k);
      ASSERT_EQ(part.firstPoint, point) << primitive;
      ASSERT_EQ(part.appearance, appearance) << primitive;
    }
    point += surface.points.size;
  }
  EXPECT_EQ(mesh.primitiveCount(), primitive);
  EXPECT_EQ(mesh.pointCount(), point);
}
}

TEST(SceneMesh, NumbersPrimitivesAndPointsInOrder)
{
  for (const std::size_t count : { 0, 1, 2, 4096, 4097, 20000 })
  {
    SCOPED_TRACE(count);
    const std::vector<Surface> surfaces = makeSurfaces(count);
    compare(surfaces, Parallel());
    compare(surfaces, ThreadedParallel(3));
  }
}
