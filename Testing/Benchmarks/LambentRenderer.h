// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief time vtkLambentRayTracer, and vtkLambentNormals with its peers
 */
#ifndef LambentRenderer_h
#define LambentRenderer_h

#include "Scenes.h"

#include "vtkImageData.h"
#include "vtkLambentRayTracer.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

/// What is drawn on the surface.
enum class Look
{
  Colors,  ///< a point array through a table
  Texture, ///< an image of 1024 x 1024 pixels, interpolated
  Edges    ///< the edges of all triangles
};

class LambentRenderer
{
public:
  explicit LambentRenderer(const BenchmarkScene& scene);

  /// The seconds from the mesh in memory to the bytes of a newly allocated image, with
  /// samples x samples samples per pixel. The filter is modified before, so it must render.
  double render(int samples = 1);

  /// The same with another look.
  double renderLook(Look look);

  /// The same with transparent surfaces.
  double renderLayers();

  vtkImageData* picture() { return this->Filter->GetOutput(); }

private:
  void addArrays(vtkPolyData* mesh);

  vtkNew<vtkLambentRayTracer> Filter;
  vtkNew<vtkProperty> Property;
  vtkNew<vtkTexture> Texture;
};

enum class NormalsFilter
{
  Lambent,          ///< vtkLambentNormals, angle-weighted
  PolyData,         ///< vtkPolyDataNormals, splitting and consistency off
  TriangleMeshPoint ///< vtkTriangleMeshPointNormals
};

/// The seconds that a filter takes to compute the point normals of a mesh without any.
double computeNormals(NormalsFilter filter, vtkPolyData* meshWithoutNormals);

/// A mesh that shares the points and triangles of another, without its normals.
vtkSmartPointer<vtkPolyData> withoutNormals(vtkPolyData* mesh);

#endif
