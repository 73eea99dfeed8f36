// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BackgroundFromVTK.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <stdexcept>
#include <string>

namespace lambent::adapters
{
namespace
{
/// What is wrong with an image, and the remedy; empty if nothing.
std::string describeDefect(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  vtkDataArray* const colors = image->GetPointData()->GetScalars();
  if (!colors || colors->GetNumberOfTuples() == 0)
  {
    return "without scalars. Update the filter or reader that produces it first.";
  }
  if (size[2] != 1)
  {
    return "of " + std::to_string(size[2]) + " slices; it takes one. Call vtkExtractVOI.";
  }
  const int type = colors->GetDataType();
  if (type != VTK_UNSIGNED_CHAR && type != VTK_FLOAT)
  {
    return std::string("of type ") + colors->GetDataTypeAsString() +
      "; it takes unsigned char and float. Convert it with vtkImageShiftScale.";
  }
  const int components = colors->GetNumberOfComponents();
  if (components < 1 || components > 4)
  {
    return "of " + std::to_string(components) +
      " components; it takes 1 to 4: grey, grey and alpha, RGB or RGBA. Call "
      "vtkImageExtractComponents.";
  }
  const vtkIdType pixels = static_cast<vtkIdType>(size[0]) * size[1];
  if (colors->GetNumberOfTuples() != pixels)
  {
    return "of " + std::to_string(pixels) + " pixels, but its scalars have " +
      std::to_string(colors->GetNumberOfTuples()) + " tuples. Set its extent to match them.";
  }
  return "";
}
}

BackgroundImage backgroundFromVTK(vtkImageData* image, SpansFromVTK& spans)
{
  if (!image)
  {
    return {};
  }
  const std::string defect = describeDefect(image);
  if (!defect.empty())
  {
    throw std::runtime_error("SetBackgroundImage() was given an image " + defect);
  }
  int size[3];
  image->GetDimensions(size);
  return { spans.attribute(image->GetPointData()->GetScalars(), false), size[0], size[1] };
}

bool isOpaque(vtkImageData* image)
{
  return image && describeDefect(image).empty() &&
    image->GetPointData()->GetScalars()->GetNumberOfComponents() % 2 == 1;
}
}
