// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief seeded random scenes of every kind that ray tracers stumble over
 */
#ifndef RandomScenes_h
#define RandomScenes_h

#include "Scene.h"

#include <memory>
#include <string>
#include <vector>

/// A scene and the memory that its spans point to.
struct RandomScene
{
  struct MeshData
  {
    std::vector<float> floatPoints;
    std::vector<double> doublePoints;
    std::vector<std::int32_t> corners32;
    std::vector<std::int64_t> corners64;
    std::vector<float> normals;
  };

  std::string name;
  int width = 0, height = 0;
  std::vector<std::unique_ptr<MeshData>> meshes;
  lambent::Scene scene;
};

/// How many kinds of geometry there are; the seed's remainder chooses one.
constexpr int randomSceneKinds = 10;

/// The scene of a seed: always the same, on every platform.
RandomScene makeRandomScene(unsigned int seed);

#endif
