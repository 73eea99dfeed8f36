// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadSurface.h"
#include "CheckFile.h"
#include "Formats.h"
#include "Isolated.h"
#include "Messages.h"
#include "Progress.h"
#include "SurfaceOf.h"
#include "UnpackedFile.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

namespace lambent::command
{
namespace
{

/// A mesh without polygons can be drawn. But in the kinds that do not tell at their start what is
/// in them, it means that the rest is missing.
void CheckPolygons(const std::string& path, vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0)
  {
    return;
  }
  const std::optional<MeshKind> kind = MeshKindOf(path);
  if (kind == MeshKind::LegacyVtk || kind == MeshKind::Obj)
  {
    throw Failure("it has points, but no polygons; get a whole copy of it");
  }
  vtkGenericWarningMacro("it has no polygons, so that nothing of it is seen");
}

vtkSmartPointer<vtkPolyData> ReadFormat(const Format& format, const std::string& path,
  const std::optional<ContourValue>& contour, VtkMessages& messages, Progress& progress)
{
  const auto read = [&]() -> vtkSmartPointer<vtkPolyData>
  { return SurfaceOf(format.read(path, messages, progress), contour, messages, progress); };
  if (TrustIn(format, path) == Trust::Checked)
  {
    return read();
  }
  return ReadIsolated(read, LimitsFor(path, format.hasParts), messages, progress);
}

/// The text with the name of a temporary file replaced by that of the file that it came from.
std::string Renamed(std::string text, const std::string& temporary, const std::string& path)
{
  for (std::size_t at = 0; (at = text.find(temporary, at)) != std::string::npos;)
  {
    text.replace(at, temporary.size(), path);
    at += path.size();
  }
  return text;
}

vtkSmartPointer<vtkPolyData> ReadGzipped(const Format& format, const std::string& path,
  const std::optional<ContourValue>& contour, VtkMessages& messages, Progress& progress)
{
  const UnpackedFile unpacked(path, format.hasParts);
  try
  {
    return ReadFormat(format, unpacked.GetPath(), contour, messages, progress);
  }
  catch (const std::exception& reason)
  {
    throw Failure(Renamed(reason.what(), unpacked.GetPath(), path));
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& path, VtkMessages& messages,
  Progress& progress, const std::optional<ContourValue>& contour)
{
  progress.Begin("reading " + path);
  try
  {
    const Format* const known = FindFormat(path);
    CheckFile(path, known && known->mayBeEmpty);
    const Format& format = RequireFormat(path);
    const vtkSmartPointer<vtkPolyData> mesh = IsGzipped(path)
      ? ReadGzipped(format, path, contour, messages, progress)
      : ReadFormat(format, path, contour, messages, progress);
    CheckPolygons(path, mesh);
    return mesh;
  }
  catch (const std::exception& reason) // a Failure, or memory that is not there
  {
    throw Failure("cannot read '" + path + "': " + reason.what());
  }
}

} // namespace lambent::command
