// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadSurface.h"
#include "CheckCells.h"
#include "CheckFile.h"
#include "CheckLegacyVtk.h"
#include "CheckPolygons.h"
#include "CheckXml.h"
#include "FileKinds.h"
#include "Messages.h"
#include "Progress.h"
#include "ReadObj.h"
#include "ReadPly.h"
#include "ReadStl.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkErrorCode.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

namespace lambent::command
{
namespace
{

/// Runs a reader and gives its output, or throws what it has to say.
template <typename Reader>
vtkSmartPointer<vtkDataObject> Read(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  vtkNew<Reader> reader;
  progress.Follow(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
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

vtkSmartPointer<vtkDataObject> ReadAnyKind(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  const std::optional<MeshKind> kind = MeshKindOf(path);
  if (!kind)
  {
    throw Failure("its kind is not known; its name has to end in one of " + MeshExtensions());
  }
  const auto follow = [&progress](double fraction) { progress.Update(fraction); };
  switch (*kind)
  {
    case MeshKind::Vtp:
      CheckXml(path);
      return Read<vtkXMLPolyDataReader>(path, messages, progress);
    case MeshKind::Vtu:
      CheckXml(path);
      return Read<vtkXMLUnstructuredGridReader>(path, messages, progress);
    case MeshKind::LegacyVtk:
      CheckLegacyVtk(path);
      return Read<vtkGenericDataObjectReader>(path, messages, progress);
    case MeshKind::Obj:
      return ReadObj(path, follow);
    case MeshKind::Stl:
      return ReadStl(path, follow);
    case MeshKind::Ply:
      break;
  }
  return ReadPly(path, follow);
}

vtkSmartPointer<vtkPolyData> SurfaceOf(
  vtkDataObject* data, VtkMessages& messages, Progress& progress)
{
  vtkDataSet* const dataSet = vtkDataSet::SafeDownCast(data);
  if (!dataSet || dataSet->GetNumberOfPoints() == 0)
  {
    throw Failure("there is no mesh in it");
  }
  if (auto* const mesh = vtkPolyData::SafeDownCast(dataSet))
  {
    for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
    {
      CheckCells(cells, mesh->GetNumberOfPoints());
    }
    return mesh;
  }
  if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(dataSet))
  {
    CheckCells(grid);
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
    CheckPolygons(mesh, data);
    return mesh;
  }
  catch (const std::exception& reason) // a Failure, or memory that is not there
  {
    throw Failure("cannot read '" + path + "': " + reason.what());
  }
}

} // namespace lambent::command
