// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief rays against triangles in long double, and arrays of a picture
 *
 * Moeller and Trumbore's test, which has nothing in common with the core's.
 */
#ifndef PassRays_h
#define PassRays_h

#include "Meshes.h"

#include "vtkIdList.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>
#include <vector>

/// The first hit of a ray. Near an edge it is not certain that the core finds the same.
struct LongHit
{
  long double depth = std::numeric_limits<long double>::infinity(); ///< along the viewing direction
  int input = -1;
  vtkIdType cell = -1;
  vtkIdType points[3] = {};
  long double weights[3] = {};
  bool isCertain = true;

  bool isHit() const { return this->cell >= 0; }
  /// The interpolated component of a point array.
  long double interpolate(vtkDataArray* array, int component) const
  {
    long double sum = 0;
    for (int k = 0; k < 3; ++k)
    {
      sum += this->weights[k] * array->GetComponent(this->points[k], component);
    }
    return sum;
  }
};

class LongRays
{
public:
  /// Adds the triangles of the cells, as fans.
  void add(vtkPolyData* mesh)
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      mesh->GetCellPoints(cell, ids);
      for (vtkIdType k = 2; k < ids->GetNumberOfIds(); ++k)
      {
        this->Triangles.push_back(
          { this->Inputs, cell, { ids->GetId(0), ids->GetId(k - 1), ids->GetId(k) }, {} });
        for (int corner = 0; corner < 3; ++corner)
        {
          double p[3];
          mesh->GetPoint(this->Triangles.back().points[corner], p);
          this->Triangles.back().corners[corner] = Long(p[0], p[1], p[2]);
        }
      }
    }
    ++this->Inputs;
  }

  LongHit find(const Ray& ray) const
  {
    LongHit nearest;
    for (const Triangle& triangle : this->Triangles)
    {
      LongHit hit;
      if (intersect(triangle, ray, hit) && hit.depth < nearest.depth)
      {
        const bool isCertain = nearest.isCertain && hit.isCertain;
        nearest = hit;
        nearest.isCertain = isCertain;
      }
      nearest.isCertain = nearest.isCertain && hit.isCertain;
    }
    return nearest;
  }

private:
  using Long = glm::tvec3<long double>;
  struct Triangle
  {
    int input;
    vtkIdType cell;
    vtkIdType points[3];
    Long corners[3];
  };

  /// Rays start at t = 0, and t is the depth.
  static bool intersect(const Triangle& triangle, const Ray& ray, LongHit& hit)
  {
    const Long d(ray.direction), o(ray.origin);
    const Long ab = triangle.corners[1] - triangle.corners[0];
    const Long ac = triangle.corners[2] - triangle.corners[0];
    const Long p = glm::cross(d, ac);
    const long double determinant = glm::dot(ab, p);
    const Long s = o - triangle.corners[0];
    const Long q = glm::cross(s, ab);
    hit.weights[1] = glm::dot(s, p) / determinant;
    hit.weights[2] = glm::dot(d, q) / determinant;
    hit.weights[0] = 1 - hit.weights[1] - hit.weights[2];
    const long double least = std::min({ hit.weights[0], hit.weights[1], hit.weights[2] });
    hit.isCertain = std::fabs(least) > 1e-8L;
    if (!(least >= 0))
    {
      return false;
    }
    hit.depth = glm::dot(ac, q) / determinant;
    hit.input = triangle.input;
    hit.cell = triangle.cell;
    std::copy_n(triangle.points, 3, hit.points);
    return hit.depth > 0;
  }

  int Inputs = 0;
  std::vector<Triangle> Triangles;
};

/// An array of the picture, which must exist.
inline vtkDataArray* passOf(vtkImageData* image, const char* name)
{
  vtkDataArray* const array = image->GetPointData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array;
}

/// The bits of a pixel's tuple.
inline std::string tupleBits(vtkDataArray* array, vtkIdType pixel)
{
  const int size = array->GetNumberOfComponents() * array->GetDataTypeSize();
  return { static_cast<const char*>(array->GetVoidPointer(0)) + pixel * size,
    static_cast<std::size_t>(size) };
}

/// Expects that all arrays have the same bits at a pixel of a part and at a pixel of the whole.
inline void expectSameArrays(
  vtkImageData* part, vtkIdType pixel, vtkImageData* whole, vtkIdType pixelOfWhole)
{
  ASSERT_EQ(part->GetPointData()->GetNumberOfArrays(), whole->GetPointData()->GetNumberOfArrays());
  for (int k = 0; k < whole->GetPointData()->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* const expected = whole->GetPointData()->GetArray(k);
    EXPECT_EQ(
      tupleBits(passOf(part, expected->GetName()), pixel), tupleBits(expected, pixelOfWhole))
      << expected->GetName() << ", pixel " << pixel;
  }
}

/// Adds an array of this type with random numbers from 0 to 100 to the points or the cells.
inline vtkSmartPointer<vtkDataArray> addArray(vtkPolyData* mesh, int association, int type,
  const char* name, int components, unsigned int seed = 1)
{
  const bool isOfPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(isOfPoints ? mesh->GetNumberOfPoints() : mesh->GetNumberOfCells());
  for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
  {
    for (int component = 0; component < components; ++component)
    {
      seed = seed * 1664525u + 1013904223u;
      array->SetComponent(k, component, static_cast<double>(seed >> 8) / (1 << 24) * 100.0);
    }
  }
  isOfPoints ? mesh->GetPointData()->AddArray(array) : mesh->GetCellData()->AddArray(array);
  return array;
}

/// Looks along -z, so that pixel (i, j) shows the unit square [i, i + 1] x [j, j + 1] at z = 0.
inline void lookAtUnitSquares(Studio& studio)
{
  studio.camera->ParallelProjectionOn();
  studio.camera->SetParallelScale(studio.height() / 2.0);
  studio.look({ studio.width() / 2.0, studio.height() / 2.0, 5.0 },
    { studio.width() / 2.0, studio.height() / 2.0, 0.0 });
}

inline double valueAt(Studio& studio, const char* name, vtkIdType pixel, int component = 0)
{
  return passOf(studio.tracer->GetOutput(), name)->GetComponent(pixel, component);
}

inline bool isNothing(vtkDataArray* array, vtkIdType pixel)
{
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
  {
    if (!std::isnan(array->GetComponent(pixel, k)))
    {
      return false;
    }
  }
  return true;
}

#endif
