// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Passes.h"
#include "FileKinds.h"
#include "InputArrays.h"
#include "Messages.h"
#include "Progress.h"
#include "WritePicture.h"

#include "vtkLambentRayTracer.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace lambent::command
{
namespace
{

using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;
using Content = PassValue::Content;
using Association = PassValue::Association;

/// Finds out whether the array of a pass belongs to points or cells. Throws Failure if it is both
/// or neither.
Association FindArray(const PassValue& pass, const Meshes& meshes)
{
  const bool isOfPoints =
    pass.association != Association::Cells && HasArray(meshes, Association::Points, pass.array);
  const bool isOfCells =
    pass.association != Association::Points && HasArray(meshes, Association::Cells, pass.array);
  if (isOfPoints && isOfCells)
  {
    throw Failure("--pass " + pass.text +
      ": the inputs have a point array and a cell array of that name; write point:" + pass.array +
      " or cell:" + pass.array);
  }
  if (!isOfPoints && !isOfCells)
  {
    ArrayList forPasses;
    forPasses.withOwn = false;
    throw Failure("--pass " + pass.text +
      ": no input has such an array; the arrays are: " + ListArrays(meshes, forPasses) +
      "; other passes are: depth, normals, positions, ids, input-ids");
  }
  return isOfPoints ? Association::Points : Association::Cells;
}

/// Whether the values must not be rounded, because they are ids or labels.
bool IsExact(const PassValue& pass, const Meshes& meshes)
{
  if (pass.content != Content::Array)
  {
    return pass.content == Content::CellIds || pass.content == Content::InputIds;
  }
  return FindArray(pass, meshes) == Association::Cells &&
    std::any_of(meshes.begin(), meshes.end(),
      [&pass](vtkPolyData* mesh)
      {
        vtkDataArray* const array = mesh->GetCellData()->GetArray(pass.array.c_str());
        return array && array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
      });
}

vtkSmartPointer<vtkDataArray> AsFloats(vtkDataArray* array, bool isExact)
{
  constexpr double largest = std::numeric_limits<float>::max();
  auto floats = vtkSmartPointer<vtkFloatArray>::New();
  floats->SetNumberOfComponents(array->GetNumberOfComponents());
  floats->SetNumberOfTuples(array->GetNumberOfTuples());
  floats->SetName(array->GetName());
  float* to = floats->GetPointer(0);
  for (vtkIdType tuple = 0; tuple < array->GetNumberOfTuples(); ++tuple)
  {
    for (int k = 0; k < array->GetNumberOfComponents(); ++k, ++to)
    {
      const double value = array->GetComponent(tuple, k);
      const bool isTooLarge = std::isfinite(value) && std::fabs(value) > largest;
      *to = isTooLarge ? 0.0f : static_cast<float>(value);
      if (isTooLarge || (isExact && std::isfinite(value) && *to != value))
      {
        std::ostringstream text;
        text.precision(17);
        text << value;
        throw Failure("the value " + text.str() +
          (isTooLarge ? " is beyond the range of the 32-bit floats of a .tif"
                      : " would be rounded to the 32-bit floats of a .tif") +
          "; choose a name that ends in .vti");
      }
    }
  }
  return floats;
}

vtkSmartPointer<vtkImageData> ImageOf(vtkImageData* picture, vtkDataArray* array)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(picture);
  image->GetPointData()->SetScalars(array);
  return image;
}

} // namespace

void RequestPasses(
  const std::vector<PassValue>& passes, const Meshes& meshes, vtkLambentRayTracer* tracer)
{
  for (const PassValue& pass : passes)
  {
    switch (pass.content)
    {
      case Content::Depth:
        tracer->GenerateDepthOn();
        break;
      case Content::Normals:
        tracer->GenerateNormalsOn();
        break;
      case Content::Positions:
        tracer->GeneratePositionsOn();
        break;
      case Content::CellIds:
      case Content::InputIds:
        tracer->GenerateIdsOn();
        break;
      case Content::Array:
        tracer->AddPassArray(FindArray(pass, meshes) == Association::Points
            ? vtkDataObject::FIELD_ASSOCIATION_POINTS
            : vtkDataObject::FIELD_ASSOCIATION_CELLS,
          pass.array.c_str());
        break;
    }
  }
}

void WritePasses(const std::vector<PassValue>& passes, vtkImageData* picture, const Meshes& meshes,
  VtkMessages& messages, Progress& progress)
{
  for (const PassValue& pass : passes)
  {
    if (pass.file.empty())
    {
      continue;
    }
    progress.Begin("writing " + pass.file);
    vtkDataArray* const array = picture->GetPointData()->GetArray(pass.array.c_str());
    const bool isTiff = PictureKindOf(pass.file) == PictureKind::Tiff;
    try
    {
      vtkSmartPointer<vtkDataArray> values = array;
      if (isTiff)
      {
        values = AsFloats(array, IsExact(pass, meshes));
      }
      WritePicture(ImageOf(picture, values), pass.file, messages);
    }
    catch (const Failure& reason)
    {
      throw Failure("--pass " + pass.text + ": " + reason.what());
    }
  }
}

void KeepOnlyPasses(const std::vector<PassValue>& passes, vtkImageData* picture)
{
  const std::set<std::string> ids = { "CellIds", "InputIds" };
  for (const std::string& name : ids)
  {
    if (std::none_of(passes.begin(), passes.end(),
          [&name](const PassValue& pass) { return pass.array == name; }))
    {
      picture->GetPointData()->RemoveArray(name.c_str());
    }
  }
}

} // namespace lambent::command
