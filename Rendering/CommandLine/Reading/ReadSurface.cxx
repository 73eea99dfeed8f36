// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadSurface.h"
#include "CheckFile.h"
#include "CheckPolygons.h"
#include "Formats.h"
#include "Isolated.h"
#include "Messages.h"
#include "Progress.h"
#include "SurfaceOf.h"
#include "UnpackedFile.h"

#include "vtkPolyData.h"

namespace lambent::command
{
namespace
{

using Convert = std::function<vtkSmartPointer<vtkPolyData>(vtkDataObject*)>;

vtkSmartPointer<vtkPolyData> ReadFormat(const Format& format, const std::string& path,
  const Convert& convert, VtkMessages& messages, Progress& progress)
{
  const auto read = [&]() -> vtkSmartPointer<vtkPolyData>
  { return convert(format.read(path, messages, progress)); };
  if (TrustIn(format, path) == Trust::Checked)
  {
    return read();
  }
  return ReadIsolated(read, LimitsFor(path, format.hasParts), messages, progress);
}

/// Replaces the name of a temporary file in a text by the name of the original file.
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
  const Convert& convert, VtkMessages& messages, Progress& progress)
{
  const UnpackedFile unpacked(path, format.hasParts);
  try
  {
    return ReadFormat(format, unpacked.GetPath(), convert, messages, progress);
  }
  catch (const std::exception& reason)
  {
    throw Failure(Renamed(reason.what(), unpacked.GetPath(), path));
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& path, VtkMessages& messages,
  Progress& progress, const std::optional<ContourValue>& contour, bool drawsPoints)
{
  return ReadAs(path, messages, progress,
    [&](vtkDataObject* data)
    {
      const vtkSmartPointer<vtkPolyData> mesh = SurfaceOf(data, contour, messages, progress);
      if (!drawsPoints || mesh->GetNumberOfPoints() == 0)
      {
        CheckPolygons(mesh, data);
      }
      return mesh;
    });
}

vtkSmartPointer<vtkPolyData> ReadAs(
  const std::string& path, VtkMessages& messages, Progress& progress, const Convert& convert)
{
  progress.Begin("reading " + path);
  try
  {
    const Format* const known = FindFormat(path);
    CheckFile(path, known && known->mayBeEmpty);
    const Format& format = RequireFormat(path);
    const vtkSmartPointer<vtkPolyData> mesh = IsGzipped(path)
      ? ReadGzipped(format, path, convert, messages, progress)
      : ReadFormat(format, path, convert, messages, progress);
    return mesh;
  }
  catch (const std::exception& reason) // a Failure, or out of memory
  {
    throw Failure("cannot read '" + path + "': " + reason.what());
  }
}

} // namespace lambent::command
