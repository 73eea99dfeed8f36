// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLambentRayTracer against the clock, and vtkLambentNormals with its peers
 */
#ifndef LambentRenderer_h
#define LambentRenderer_h

#include "Scenes.h"

#include "vtkImageData.h"
#include "vtkLambentRayTracer.h"

class LambentRenderer
{
public:
  explicit LambentRenderer(const BenchmarkScene& scene);

  /// Seconds from the mesh in memory to the bytes of a newly allocated image. The filter
  /// is told that all has changed, so it cannot but make the picture.
  double render();

  vtkImageData* picture() { return this->Filter->GetOutput(); }

private:
  vtkNew<vtkLambentRayTracer> Filter;
};

enum class NormalsFilter
{
  Lambent,          ///< vtkLambentNormals, angle-weighted
  PolyData,         ///< vtkPolyDataNormals, splitting and consistency off
  TriangleMeshPoint ///< vtkTriangleMeshPointNormals
};

/// Seconds that a filter takes for the point normals of a mesh without.
double computeNormals(NormalsFilter filter, vtkPolyData* meshWithoutNormals);

/// The points and triangles of a mesh, shared with it, without its normals.
vtkSmartPointer<vtkPolyData> withoutNormals(vtkPolyData* mesh);

#endif
