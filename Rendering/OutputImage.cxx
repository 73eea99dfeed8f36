// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputImage.h"

#include "InputSurfaces.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <vtksys/SystemInformation.hxx>

#include <new>

namespace lambent::adapters
{
namespace
{
/// Refuse what the machine's memory certainly cannot hold. Most systems would
/// promise it all the same and end the process once it is written to.
void checkMemory(double bytes)
{
  constexpr double alwaysTried = 1e9;
  if (bytes > alwaysTried)
  {
    vtksys::SystemInformation machine;
    machine.RunMemoryCheck();
    if (bytes > 1024.0 * 1024.0 * static_cast<double>(machine.GetTotalPhysicalMemory()))
    {
      throw std::bad_alloc();
    }
  }
}
}

Image allocateImage(
  const int size[2], int scalarType, vtkInformation* outInfo, vtkImageData* output)
{
  int extent[6];
  outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  Image image;
  image.width = size[0];
  image.height = size[1];
  image.part = { extent[0], extent[1] + 1, extent[2], extent[3] + 1 };

  auto colors = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(scalarType));
  const vtkIdType pixels = static_cast<vtkIdType>(image.part.width()) * image.part.height();
  checkMemory(3.0 * pixels * colors->GetDataTypeSize());
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(pixels);
  output->SetExtent(extent);
  output->GetPointData()->SetScalars(colors);
  if (auto* bytes = vtkUnsignedCharArray::SafeDownCast(colors))
  {
    image.bytes = bytes->GetPointer(0);
  }
  if (auto* floats = vtkFloatArray::SafeDownCast(colors))
  {
    image.floats = floats->GetPointer(0);
  }
  return image;
}

void addIds(
  const std::vector<std::uint32_t>& triangles, const InputSurfaces& surfaces, vtkImageData* output)
{
  const auto pixels = static_cast<vtkIdType>(triangles.size());
  vtkNew<vtkIdTypeArray> cells, inputs;
  cells->SetName("CellIds");
  inputs->SetName("InputIds");
  cells->SetNumberOfTuples(pixels);
  inputs->SetNumberOfTuples(pixels);
  vtkIdType* const cell = cells->GetPointer(0);
  vtkIdType* const input = inputs->GetPointer(0);
  vtkSMPTools::For(0, pixels,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        cell[k] = input[k] = -1;
        if (triangles[k] != noTriangle)
        {
          const InputSurfaces::Place place = surfaces.find(triangles[k]);
          cell[k] = static_cast<vtkIdType>(place.cell);
          input[k] = static_cast<vtkIdType>(place.input);
        }
      }
    });
  output->GetPointData()->AddArray(cells);
  output->GetPointData()->AddArray(inputs);
}
}
