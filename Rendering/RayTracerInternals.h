// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what vtkLambentRayTracer hides from its header: its lights, and settings of single inputs
 */
#ifndef RayTracerInternals_h
#define RayTracerInternals_h

#include "vtkLambentRayTracer.h"

#include "InputSettings.h"
#include "SceneSettings.h"

#include "vtkLightCollection.h"
#include "vtkNew.h"

struct vtkLambentRayTracer::Internals
{
  vtkNew<vtkLightCollection> Lights;
  lambent::adapters::InputSettings Inputs;

  /// While modification times are computed. A texture may show the picture of the filter itself.
  bool IsComputingMTime = false;

  /// Adds the meshes of a connection to the scene.
  void addInput(vtkDataObject* data, int connection, lambent::adapters::SceneSettings& scene) const;
};

#endif
