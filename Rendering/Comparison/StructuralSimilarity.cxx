// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StructuralSimilarity.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkVersion.h"

#include <stdexcept>
#include <string>
#include <vector>

#if __has_include("vtkImageSSIM.h")
#include "vtkImageSSIM.h"

namespace
{
/// The largest difference between two values of the type; 1 for floating point.
int rangeOf(vtkImageData* image)
{
  switch (image->GetScalarType())
  {
    case VTK_UNSIGNED_CHAR:
      return 255;
    case VTK_UNSIGNED_SHORT:
      return 65535;
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return 1;
    default:
      throw std::runtime_error(
        std::string("The structural similarity is not defined for scalars of ") +
        image->GetScalarTypeAsString() +
        ", whose range is not known. Convert them to unsigned char, or choose another metric.");
  }
}
}

bool hasStructuralSimilarity()
{
  return true;
}

double structuralSimilarity(vtkImageData* picture, vtkImageData* baseline)
{
  std::vector<int> ranges(picture->GetNumberOfScalarComponents(), rangeOf(picture));
  vtkNew<vtkImageData> placed; // vtkImageSSIM requires equal extents
  placed->ShallowCopy(baseline);
  placed->SetExtent(picture->GetExtent());
  vtkNew<vtkImageSSIM> filter;
  filter->SetInputRange(ranges);
  filter->SetInputData(0, picture);
  filter->SetInputData(1, placed);
  filter->Update();
  vtkDataArray* map = filter->GetOutput()->GetPointData()->GetScalars();
  if (!map || map->GetNumberOfTuples() != picture->GetNumberOfPoints())
  {
    throw std::runtime_error("vtkImageSSIM could not compute the structural similarity.");
  }
  double sum = 0.0;
  for (vtkIdType pixel = 0; pixel < map->GetNumberOfTuples(); ++pixel)
  {
    for (int c = 0; c < map->GetNumberOfComponents(); ++c)
    {
      sum += map->GetComponent(pixel, c);
    }
  }
  return sum / map->GetNumberOfValues();
}

#else

bool hasStructuralSimilarity()
{
  return false;
}

double structuralSimilarity(vtkImageData*, vtkImageData*)
{
  throw std::runtime_error(std::string("The structural similarity needs vtkImageSSIM, which VTK ") +
    vtkVersion::GetVTKVersion() +
    " does not have. Choose another metric, or build with a newer VTK.");
}

#endif
