// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief composite data for tests, and arrays of ids of a picture
 */
#ifndef Blocks_h
#define Blocks_h

#include "Meshes.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"

#include <string>
#include <vector>

using Blocks = vtkSmartPointer<vtkMultiBlockDataSet>;

inline Blocks makeBlocks(const std::vector<vtkDataObject*>& children)
{
  auto blocks = Blocks::New();
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(children.size()));
  for (std::size_t k = 0; k < children.size(); ++k)
  {
    blocks->SetBlock(static_cast<unsigned int>(k), children[k]);
  }
  return blocks;
}

inline void setName(vtkMultiBlockDataSet* blocks, unsigned int child, const char* name)
{
  blocks->GetMetaData(child)->Set(vtkCompositeDataSet::NAME(), name);
}

/// The mesh, moved.
inline Mesh makeMoved(vtkPolyData* mesh, const Vec& by)
{
  std::vector<Vec> points = pointsOf(mesh);
  for (Vec& point : points)
  {
    point += by;
  }
  Mesh moved = Mesh::New();
  moved->DeepCopy(mesh);
  moved->SetPoints(makeMesh(points, {})->GetPoints());
  return moved;
}

/// Empty if the picture has no such array.
inline std::vector<vtkIdType> idsOf(vtkImageData* image, const char* name)
{
  auto* array = vtkIdTypeArray::SafeDownCast(image->GetPointData()->GetArray(name));
  std::vector<vtkIdType> list;
  for (vtkIdType k = 0; array && k < array->GetNumberOfTuples(); ++k)
  {
    list.push_back(array->GetValue(k));
  }
  return list;
}

inline std::vector<vtkIdType> renderIds(Studio& studio, const char* name)
{
  studio.tracer->GenerateIdsOn();
  studio.tracer->Update();
  return idsOf(studio.tracer->GetOutput(), name);
}

/// Looks along -z at the unit squares [i, i + 1] x [0, 1], one for each of the pixels of a row.
inline void lookAtRow(Studio& studio)
{
  studio.camera->ParallelProjectionOn();
  studio.camera->SetParallelScale(0.5);
  studio.look({ studio.width() / 2.0, 0.5, 5.0 }, { studio.width() / 2.0, 0.5, 0.0 });
}

/// The unit squares of the columns [first, last).
inline Mesh makeRow(int first, int last, double z = 0.0)
{
  std::vector<Vec> points;
  Polygons squares;
  for (int x = first; x < last; ++x)
  {
    const auto n = static_cast<vtkIdType>(points.size());
    points.insert(points.end(), { Vec(x, 0, z), Vec(x + 1, 0, z), Vec(x + 1, 1, z), Vec(x, 1, z) });
    squares.push_back({ n, n + 1, n + 2, n + 3 });
  }
  return makeMesh(points, squares);
}

using Ids = std::vector<vtkIdType>;

#endif
