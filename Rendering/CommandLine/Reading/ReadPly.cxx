// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadPly.h"
#include "FileBytes.h"
#include "PlyFaces.h"
#include "PlyVertices.h"
#include "PlyWalk.h"

#include "vtkPolyData.h"

#include <limits>

namespace lambent::command
{
namespace
{

/// Rejects a count that the rest of the file cannot hold, because it determines an allocation.
void CheckCount(const PlyCursor& cursor, const PlyElement& element)
{
  for (const PlyProperty& property : element.properties)
  {
    const PlyType first = property.isList ? property.countType : property.type;
    if (!cursor.CanHold(static_cast<double>(element.count), first))
    {
      throw Failure("it is incomplete: its header declares " + std::to_string(element.count) +
        " of '" + element.name + "', more than the rest of the file can hold");
    }
  }
}

/// Warns of numbers and bytes that belong to no element.
void WarnOfRest(PlyCursor& cursor)
{
  if (cursor.GetLeftOver() > 0)
  {
    vtkGenericWarningMacro(
      << "numbers left over on a line are ignored, since each element has its own "
      << "line; it has " << cursor.GetLeftOver() << " of them, the first in line "
      << cursor.GetFirstLineWithMore());
  }
  const std::size_t bytes = cursor.BytesBehind();
  if (bytes > 0)
  {
    vtkGenericWarningMacro(<< "ignored " << bytes << (bytes == 1 ? " byte" : " bytes")
                           << " after the last element that its header declares");
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadPly(
  const std::string& path, const std::function<void(double)>& progress)
{
  const FileBytes file(path);
  const PlyHeader header = ParsePlyHeader(file.view());
  PlyCursor cursor(file.view(), header);
  // A file of less than 2 GiB cannot hold more than 2^31 - 1 ids; 32-bit ids take half the memory.
  const bool idsAreShort = file.size() <= std::numeric_limits<std::int32_t>::max();

  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  for (const PlyElement& element : header.elements)
  {
    CheckCount(cursor, element);
    if (element.name == "vertex")
    {
      ReadPlyVertices(cursor, element, progress, mesh);
    }
    else if (element.name == "face")
    {
      ReadPlyFaces(cursor, element, idsAreShort, progress, mesh);
    }
    else if (element.name == "tristrips")
    {
      ReadPlyStrips(cursor, element, progress, mesh);
    }
    else
    {
      SkipSink sink;
      Walk(cursor, element, progress, sink);
    }
  }
  WarnOfRest(cursor);
  if (!mesh->GetPoints())
  {
    throw Failure("it has no vertices");
  }
  return mesh;
}

} // namespace lambent::command
