// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief ordinary meshes: from files, contoured, and with any number of triangles
 */
#ifndef Meshes_h
#define Meshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

/// Triangles under construction, before conversion to polydata.
struct MeshArrays
{
  std::vector<float> points;
  std::vector<float> normals; ///< if empty, computed from the triangles around each point
  std::vector<vtkIdType> corners;

  vtkIdType addPoint(const std::array<double, 3>& point);
  vtkIdType addPoint(const std::array<double, 3>& point, const std::array<double, 3>& normal);
  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c);
  vtkSmartPointer<vtkPolyData> toPolyData();
};

/// Reads a PLY file and adds point normals. Returns nullptr if there is no such file.
vtkSmartPointer<vtkPolyData> readMesh(const std::string& path);

/// The isosurface at 120 of vtkRTAnalyticSource over the extent +-half in each direction, with
/// waves in proportion, from vtkFlyingEdges3D. It takes a minute, so it is kept in the cache.
vtkSmartPointer<vtkPolyData> makeWave(int half, const std::string& cache);

/// A bumpy ball with about this number of triangles of nearly equal size.
vtkSmartPointer<vtkPolyData> makeBumps(std::size_t triangles);

#endif
