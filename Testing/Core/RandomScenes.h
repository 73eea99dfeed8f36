// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief seeded random scenes of the kinds that trip up ray tracers
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
    std::vector<float> floatRadii; ///< of spheres
    std::vector<double> doubleRadii;
  };

  std::string name;
  int width = 0, height = 0;
  std::vector<std::unique_ptr<MeshData>> meshes;
  lambent::Scene scene;
};

/// The number of kinds of geometry; the remainder of the seed selects one.
constexpr int randomSceneKinds = 10;

/// The scene for a seed, the same on every platform.
RandomScene makeRandomScene(unsigned int seed);

#endif
