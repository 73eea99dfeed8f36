// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadSurface.h"
#include "CheckCells.h"
#include "CheckFile.h"
#include "CheckXmlType.h"
#include "CheckedXmlReader.h"
#include "FileKinds.h"
#include "LinearCells.h"
#include "Messages.h"
#include "Progress.h"
#include "ReadLegacyVtk.h"
#include "ReadPly.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkErrorCode.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <type_traits>

namespace lambent::command
{
namespace
{

/// vtkSTLReader takes any bytes for binary triangles and any number of them for all.
void CheckStl(const std::string& path)
{
  constexpr std::size_t headerSize = 84;
  constexpr std::size_t triangleSize = 50;
  std::ifstream file(path, std::ios::binary);
  unsigned char header[headerSize] = {};
  file.read(reinterpret_cast<char*>(header), headerSize);
  const std::string start(reinterpret_cast<char*>(header), headerSize);
  const bool isText = start.compare(start.find_first_not_of(" \t\r\n"), 5, "solid") == 0 &&
    std::all_of(start.begin(), start.begin() + file.gcount(),
      [](char c) { return static_cast<unsigned char>(c) < 128 && c != '\0'; });
  if (isText)
  {
    return; // the reader knows where the text has to end
  }
  std::size_t count = 0;
  for (int i = 3; i >= 0; --i)
  {
    count = 256 * count + header[80 + i];
  }
  if (static_cast<std::size_t>(file.gcount()) < headerSize ||
    std::filesystem::file_size(path) < headerSize + triangleSize * count)
  {
    throw Failure("it is cut short or not an STL file: it is too short for the " +
      std::to_string(count) + " triangles that it promises; get a whole copy of it");
  }
}

/// An OBJ file has no counts and no end: what tells of a cut is a line that is not ended.
void CheckObj(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(-1, std::ios::end);
  CheckLastByte(static_cast<char>(file.get()));
}

/// Runs a reader and gives its output, or throws what it has to say.
template <typename Reader>
vtkSmartPointer<vtkDataObject> Read(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  vtkNew<Reader> reader;
  progress.Follow(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  if constexpr (std::is_base_of_v<CheckedReader, Reader>)
  {
    if (!reader->GetFailure().empty())
    {
      throw Failure(reader->GetFailure());
    }
  }
  const std::string error = messages.TakeError();
  if (!error.empty())
  {
    throw Failure(error + "; is it whole, and of the kind that its name tells?");
  }
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw Failure(std::string(vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode())) +
      "; is it whole, and of the kind that its name tells?");
  }
  return reader->GetOutputDataObject(0);
}

vtkSmartPointer<vtkDataObject> ReadLegacyVtk(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  switch (LegacyTypeOf(path))
  {
    case LegacyType::PolyData:
      return Read<LegacyPolyDataReader>(path, messages, progress);
    case LegacyType::UnstructuredGrid:
      return Read<LegacyGridReader>(path, messages, progress);
    case LegacyType::Other:
      break;
  }
  return Read<vtkGenericDataObjectReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadAnyKind(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  const std::optional<MeshKind> kind = MeshKindOf(path);
  if (!kind)
  {
    throw Failure("its kind is not known; its name has to end in one of " + MeshExtensions());
  }
  switch (*kind)
  {
    case MeshKind::Vtp:
      CheckVtkStart(path, true);
      return Read<CheckedXmlReader<vtkXMLPolyDataReader>>(path, messages, progress);
    case MeshKind::Vtu:
      CheckVtkStart(path, true);
      return Read<CheckedXmlReader<vtkXMLUnstructuredGridReader>>(path, messages, progress);
    case MeshKind::LegacyVtk:
      CheckVtkStart(path, false);
      return ReadLegacyVtk(path, messages, progress);
    case MeshKind::Obj:
      CheckObj(path);
      return Read<vtkOBJReader>(path, messages, progress);
    case MeshKind::Stl:
      CheckStl(path);
      return Read<vtkSTLReader>(path, messages, progress);
    case MeshKind::Ply:
      break;
  }
  return ReadPly(path, [&progress](double fraction) { progress.Update(fraction); });
}

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

vtkSmartPointer<vtkPolyData> SurfaceOf(
  vtkDataObject* data, VtkMessages& messages, Progress& progress)
{
  vtkDataSet* dataSet = vtkDataSet::SafeDownCast(data);
  if (!dataSet || dataSet->GetNumberOfPoints() == 0)
  {
    throw Failure("there is no mesh in it");
  }
  if (auto* const mesh = vtkPolyData::SafeDownCast(dataSet))
  {
    CheckCells(mesh->GetPolys(), mesh->GetNumberOfPoints(), "polygon");
    CheckCells(mesh->GetStrips(), mesh->GetNumberOfPoints(), "strip");
    return mesh;
  }
  vtkSmartPointer<vtkUnstructuredGrid> linear;
  if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(dataSet))
  {
    CheckCells(grid);
    linear = WithLinearCells(grid);
    dataSet = linear;
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  progress.Follow(surface);
  surface->SetInputData(dataSet);
  surface->Update();
  const std::string error = messages.TakeError();
  if (!error.empty())
  {
    throw Failure(error);
  }
  return surface->GetOutput();
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadSurface(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  progress.Begin("reading " + path);
  try
  {
    CheckFile(path);
    const vtkSmartPointer<vtkDataObject> data = ReadAnyKind(path, messages, progress);
    const vtkSmartPointer<vtkPolyData> mesh = SurfaceOf(data, messages, progress);
    CheckPolygons(path, mesh);
    return mesh;
  }
  catch (const std::exception& reason) // a Failure, or memory that is not there
  {
    throw Failure("cannot read '" + path + "': " + reason.what());
  }
}

} // namespace lambent::command
