// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VisibleTriangles_h
#define VisibleTriangles_h

#include "Render.h"

#include <vector>

/// The triangle that each pixel of an image of side x side pixels shows, or none.
inline std::vector<std::uint32_t> visibleTriangles(
  const lambent::Scene& scene, int side, const lambent::Settings& settings)
{
  std::vector<std::uint32_t> triangles(side * side);
  std::vector<float> floats(3 * side * side);
  lambent::Image image;
  image.width = image.height = side;
  image.part = { 0, side, 0, side };
  image.floats = floats.data();
  image.primitives = triangles.data();
  render(scene, image, lambent::Parallel(), nullptr, settings);
  return triangles;
}

#endif
