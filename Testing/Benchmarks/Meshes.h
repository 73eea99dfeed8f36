// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief ordinary meshes: read, contoured, and of any number of triangles
 */
#ifndef Meshes_h
#define Meshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

/// Triangles as they are made, before they are polydata.
struct MeshArrays
{
  std::vector<float> points;
  std::vector<float> normals; ///< none: those of the triangles around each point
  std::vector<vtkIdType> corners;

  vtkIdType addPoint(const std::array<double, 3>& point);
  vtkIdType addPoint(const std::array<double, 3>& point, const std::array<double, 3>& normal);
  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c);
  vtkSmartPointer<vtkPolyData> toPolyData();
};

/// A PLY file with point normals added; nullptr if there is no such file.
vtkSmartPointer<vtkPolyData> readMesh(const std::string& path);

/// The isosurface 120 of vtkRTAnalyticSource over the extent +-half in each direction,
/// waves in proportion, by vtkFlyingEdges3D. Kept in the cache, as it takes a minute.
vtkSmartPointer<vtkPolyData> makeWave(int half, const std::string& cache);

/// A bumpy ball of nearly the given number of nearly equal triangles.
vtkSmartPointer<vtkPolyData> makeBumps(std::size_t triangles);

#endif
