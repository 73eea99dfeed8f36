// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what stands on a stage, as VTK's objects
 */
#ifndef StageToVTK_h
#define StageToVTK_h

#include "Stage.h"

#include "vtkSmartPointer.h"

class vtkCamera;
class vtkLight;
class vtkPolyData;
class vtkProperty;

vtkSmartPointer<vtkPolyData> toPolyData(const Body& body);
vtkSmartPointer<vtkProperty> toProperty(const lambent::Appearance& appearance);
vtkSmartPointer<vtkCamera> toCamera(const lambent::Camera& camera);

/// Throws std::runtime_error if VTK, which has two points and no direction, cannot
/// tell it exactly.
vtkSmartPointer<vtkLight> toLight(const lambent::Light& light);

/// A light that is switched off; without any the ray tracer takes a headlight.
vtkSmartPointer<vtkLight> noLight();

/// By vtkLambentNormals; one a point.
std::vector<Vec3> computeNormals(const Body& body);

#endif
