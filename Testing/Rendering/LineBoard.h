// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cells of all kinds on a grid of pixels
 */
#ifndef LineBoard_h
#define LineBoard_h

#include "Meshes.h"

/// A parallel view along -z with pixels of size 1: the centre of pixel (i, j) is at (i + 0.5, j +
/// 0.5). Plain colours, since there is no light.
struct Board : Studio
{
  Board()
    : Studio(32, 24)
  {
    this->look({ 16.0, 12.0, 5.0 }, { 16.0, 12.0, 0.0 });
    this->camera->ParallelProjectionOn();
    this->camera->SetParallelScale(12.0);
    this->property->LightingOff();
    this->tracer->GenerateIdsOn();
  }

  vtkDataArray* array(const char* name)
  {
    this->tracer->Update();
    return this->tracer->GetOutput()->GetPointData()->GetArray(name);
  }
  double at(const char* name, int i, int j)
  {
    return this->array(name)->GetComponent(32 * j + i, 0);
  }
  int id(int i, int j) { return static_cast<int>(this->at("CellIds", i, j)); }

  /// The number of pixels that show a cell.
  int count(vtkIdType cell)
  {
    vtkDataArray* const ids = this->array("CellIds");
    int pixels = 0;
    for (vtkIdType k = 0; k < ids->GetNumberOfTuples(); ++k)
    {
      pixels += ids->GetComponent(k, 0) == static_cast<double>(cell);
    }
    return pixels;
  }
};

/// Cell 0: a vertex of two points. 1 and 2: lines of two segments and of one. 3 and 4: squares with
/// a common edge. 5: a strip of two triangles. The last point is not used.
inline Mesh makeAll()
{
  Mesh mesh =
    makeMesh({ { 2.5, 2.5, 0.0 }, { 5.5, 2.5, 0.0 }, { 2.5, 20.5, 0.0 }, { 10.5, 20.5, 0.0 },
               { 10.5, 16.5, 0.0 }, { 2.5, 6.5, 0.0 }, { 2.5, 10.5, 0.0 }, { 14.5, 4.5, 0.0 },
               { 20.5, 4.5, 0.0 }, { 26.5, 4.5, 0.0 }, { 14.5, 10.5, 0.0 }, { 20.5, 10.5, 0.0 },
               { 26.5, 10.5, 0.0 }, { 16.5, 14.5, 0.0 }, { 16.5, 20.5, 0.0 }, { 24.5, 14.5, 0.0 },
               { 24.5, 20.5, 0.0 }, { 30.5, 22.5, 0.0 } },
      { { 7, 8, 11, 10 }, { 8, 9, 12, 11 } });
  mesh->SetVerts(makeCells({ { 0, 1 } }));
  mesh->SetLines(makeCells({ { 2, 3, 4 }, { 5, 6 } }));
  mesh->SetStrips(makeCells({ { 13, 14, 15, 16 } }));
  return mesh;
}

#endif
