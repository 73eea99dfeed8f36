// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief convert the contents of a stage to VTK's objects
 */
#ifndef StageToVTK_h
#define StageToVTK_h

#include "Stage.h"

#include "vtkSmartPointer.h"

class vtkCamera;
class vtkDataArray;
class vtkImageData;
class vtkLight;
class vtkLookupTable;
class vtkMatrix4x4;
class vtkPolyData;
class vtkProperty;
class vtkTexture;

/// The point array with the radii of spheres.
constexpr const char* radiiName = "Radii";

vtkSmartPointer<vtkPolyData> toPolyData(const Body& body);
/// nullptr for the identity.
vtkSmartPointer<vtkMatrix4x4> toMatrix(const lambent::Transform& transform);
vtkSmartPointer<vtkDataArray> toArray(const StageArray& array);
/// The background image; nullptr if there is none.
vtkSmartPointer<vtkImageData> toBackgroundImage(const Stage& stage);
/// nullptr if there is none.
vtkSmartPointer<vtkTexture> toTexture(const StageTexture& texture);
vtkSmartPointer<vtkLookupTable> toTable(const StageColors& colors);
vtkSmartPointer<vtkProperty> toProperty(const Body& body);
vtkSmartPointer<vtkCamera> toCamera(const lambent::Camera& camera);

/// VTK stores a direction as two points. Throws std::runtime_error if the direction of a cone would
/// be rounded.
vtkSmartPointer<vtkLight> toLight(const lambent::Light& light);

/// A light that is switched off; without any lights the ray tracer would use a headlight.
vtkSmartPointer<vtkLight> noLight();

/// The normals from vtkLambentNormals, one per point.
std::vector<Vec3> computeNormals(const Body& body);

#endif
