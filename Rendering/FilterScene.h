// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the scene that a filter's settings and inputs describe
 */
#ifndef FilterScene_h
#define FilterScene_h

#include "InputSurfaces.h"

class vtkLambentRayTracer;

namespace lambent::adapters
{
class FilterScene
{
public:
  /// Surfaces, camera, lights and background. The filter and the inputs must
  /// outlive this object. Throws std::runtime_error with a message for the user, and what
  /// the checkpoints of parallel throw while normals are computed.
  FilterScene(
    vtkLambentRayTracer* filter, const std::vector<vtkPolyData*>& inputs, const Parallel& parallel);

  const Scene& scene() const { return this->Description; }
  const InputSurfaces& surfaces() const { return this->Surfaces; }

private:
  static std::vector<Appearance> appearances(vtkLambentRayTracer* filter, std::size_t count);
  void addCamera(const Parallel& parallel);
  void addLights();
  void addBackground();

  vtkLambentRayTracer* Filter;
  InputSurfaces Surfaces;
  Scene Description;
};
}

#endif
