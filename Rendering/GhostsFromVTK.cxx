// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GhostsFromVTK.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <sstream>
#include <stdexcept>

namespace lambent::adapters
{
namespace
{
static_assert(GhostFlags::duplicateCell == vtkDataSetAttributes::DUPLICATECELL &&
  GhostFlags::refinedCell == vtkDataSetAttributes::REFINEDCELL &&
  GhostFlags::hiddenCell == vtkDataSetAttributes::HIDDENCELL &&
  GhostFlags::hiddenPoint == vtkDataSetAttributes::HIDDENPOINT);

/// The flags, or nullptr if there are none. `kind` is "point" or "cell".
const unsigned char* flagsOf(
  vtkDataSetAttributes* attributes, vtkIdType expected, const std::string& kind)
{
  const char* const name = vtkDataSetAttributes::GhostArrayName();
  vtkAbstractArray* const array = attributes->GetAbstractArray(name);
  if (!array)
  {
    return nullptr;
  }
  auto* const bytes = vtkUnsignedCharArray::SafeDownCast(array);
  if (!bytes || bytes->GetNumberOfComponents() != 1 || bytes->GetNumberOfTuples() != expected)
  {
    std::ostringstream text;
    text << "the " << kind << " array \"" << name << "\" is a " << array->GetClassName() << " of "
         << array->GetNumberOfTuples() << " tuples of " << array->GetNumberOfComponents()
         << " components, but there are " << expected << " " << kind
         << "s, each of which needs one value of a vtkUnsignedCharArray. Correct the array, or "
            "remove it.";
    throw std::runtime_error(text.str());
  }
  return expected > 0 ? bytes->GetPointer(0) : nullptr;
}
}

GhostFlags ghostsFromVTK(vtkPolyData* polyData)
{
  GhostFlags flags;
  flags.points = flagsOf(polyData->GetPointData(), polyData->GetNumberOfPoints(), "point");
  flags.cells = flagsOf(polyData->GetCellData(), polyData->GetNumberOfCells(), "cell");
  if (flags.cells)
  {
    flags.cells += polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
  }
  return flags;
}
}
