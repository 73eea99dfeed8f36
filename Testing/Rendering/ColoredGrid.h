// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief an unlit grid of squares, with a camera that puts one point or cell into each pixel
 */
#ifndef ColoredGrid_h
#define ColoredGrid_h

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLambentRayTracer.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

struct ColoredGrid
{
  static constexpr int side = 12; ///< squares
  static constexpr vtkIdType points = (side + 1) * (side + 1), cells = side * side;

  bool isOfCells;
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkCamera> camera;
  vtkNew<vtkProperty> property;
  vtkNew<vtkLambentRayTracer> tracer;

  explicit ColoredGrid(bool showsCells)
    : isOfCells(showsCells)
  {
    vtkNew<vtkPoints> coordinates;
    vtkNew<vtkCellArray> squares;
    for (int j = 0; j <= side; ++j)
    {
      for (int i = 0; i <= side; ++i)
      {
        coordinates->InsertNextPoint(i, j, 0.0);
      }
    }
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        const vtkIdType a = j * (side + 1) + i, b = a + side + 1;
        const vtkIdType corners[4] = { a, a + 1, b + 1, b };
        squares->InsertNextCell(4, corners);
      }
    }
    this->mesh->SetPoints(coordinates);
    this->mesh->SetPolys(squares);
    const int pixels = this->isOfCells ? side : side + 1;
    this->camera->ParallelProjectionOn();
    this->camera->SetParallelScale(0.5 * pixels);
    this->camera->SetFocalPoint(0.5 * side, 0.5 * side, 0.0);
    this->camera->SetPosition(0.5 * side, 0.5 * side, 1.0);
    this->property->LightingOff();
    this->tracer->SetImageSize(pixels, pixels);
    this->tracer->SetCamera(this->camera);
    this->tracer->SetProperty(this->property);
    this->tracer->SetInputData(this->mesh);
    this->tracer->SetInputScalarVisibility(0, true);
  }

  void add(vtkDataArray* array)
  {
    vtkDataSetAttributes* const all = this->isOfCells
      ? static_cast<vtkDataSetAttributes*>(this->mesh->GetCellData())
      : this->mesh->GetPointData();
    all->SetScalars(array);
  }
};

#endif
