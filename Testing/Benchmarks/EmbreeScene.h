// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a scene in the data types that suit Embree best
 */
#ifndef EmbreeScene_h
#define EmbreeScene_h

#include "Scenes.h"

#include <cstdint>
#include <vector>

struct Float3
{
  float x, y, z;
};

/// Triples, padded with four more numbers: Embree loads 16 bytes per triple.
struct EmbreeMesh
{
  explicit EmbreeMesh(vtkPolyData* polyData);

  std::size_t pointCount() const { return this->points.size() / 3 - 1; }
  std::size_t triangleCount() const { return this->corners.size() / 3 - 1; }

  std::vector<float> points, normals;
  std::vector<std::uint32_t> corners;
};

/// View in floats, with the light relative to the eye.
struct EmbreeView
{
  explicit EmbreeView(const View& view);

  Float3 eye, right, up, forward, light;
  float pixel;
  bool parallel;
};

#endif
