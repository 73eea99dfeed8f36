// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckXmlCells.h"
#include "CheckedXmlParser.h"
#include "HigherOrder.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

namespace lambent::command
{
namespace
{

/// The last offset that is not -1. Face offsets are -1 for cells without faces.
double LastOffset(vtkDataArray* offsets)
{
  for (vtkIdType k = offsets->GetNumberOfTuples() - 1; k >= 0; --k)
  {
    const double offset = offsets->GetComponent(k, 0);
    if (offset != -1.0)
    {
      return offset;
    }
  }
  return 0.0;
}

} // namespace

void XmlCellsCheck::Check(
  const std::string& name, vtkDataArray* values, const CheckedXmlParser& parser)
{
  const std::string end = "offsets"; // also "faceoffsets" and the newer names
  if (name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
  {
    if (!parser.CanHold(LastOffset(values)))
    {
      throw Failure("it is incomplete or corrupt: the last value of '" + name +
        "' is invalid; use a complete copy");
    }
    if (name == "faceoffsets")
    {
      this->FaceOffsets = values;
    }
  }
  if (name == "faces" && this->FaceOffsets)
  {
    this->CheckFaces(values);
  }
}

/// The list holds, for each polyhedron, the number of faces, then for each face the number of
/// points and the point ids.
void XmlCellsCheck::CheckFaces(vtkDataArray* faces) const
{
  const vtkIdType size = faces->GetNumberOfTuples();
  vtkIdType at = 0;
  const auto next = [&]() -> vtkIdType
  { return at < size ? static_cast<vtkIdType>(faces->GetComponent(at++, 0)) : size; };
  for (vtkIdType cell = 0; cell < this->FaceOffsets->GetNumberOfTuples(); ++cell)
  {
    if (this->FaceOffsets->GetComponent(cell, 0) < 0)
    {
      continue;
    }
    vtkIdType count = next();
    bool isSound = count >= 0;
    for (; count > 0 && isSound; --count)
    {
      const vtkIdType points = next();
      isSound = points >= 0 && points <= size - at;
      at += isSound ? points : 0;
    }
    if (!isSound || at > size)
    {
      throw Failure("it is incomplete or corrupt: the faces of its cell " + std::to_string(cell) +
        " do not add up; use a complete copy");
    }
  }
}

void XmlCellsCheck::CheckOldHexahedra(vtkUnstructuredGrid* grid, vtkDataArray* types)
{
  vtkCellArray* const cells = grid->GetCells();
  const vtkIdType first = cells->GetNumberOfCells() - types->GetNumberOfTuples();
  for (vtkIdType k = 0; k < types->GetNumberOfTuples(); ++k)
  {
    const int type = static_cast<int>(types->GetComponent(k, 0)) & 255;
    if (IsSortedHexahedron(type) && first + k >= 0)
    {
      CheckHigherOrder(grid, first + k, type);
    }
  }
}

} // namespace lambent::command
