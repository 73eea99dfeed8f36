// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// These readers run in the command's own process, since each checks its file. The exceptions are
// legacy files of other types than polygons and unstructured grids (see TrustIn()).

#include "CheckXmlType.h"
#include "CheckedXmlReader.h"
#include "Progress.h"
#include "ReadLegacyVtk.h"
#include "ReadObj.h"
#include "ReadPly.h"
#include "ReadStl.h"
#include "ReadThroughVtk.h"
#include "Readers.h"

#include "vtkGenericDataObjectReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

namespace lambent::command
{
namespace
{

auto Follow(Progress& progress)
{
  return [&progress](double fraction) { progress.Update(fraction); };
}

/// Reads a legacy file with all its arrays, so that passes and contours can use them. By default,
/// VTK reads only the first of each kind.
template <typename Reader>
vtkSmartPointer<vtkDataObject> ReadLegacy(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllFieldsOn();
  return Run(reader, messages, progress);
}

} // namespace

vtkSmartPointer<vtkDataObject> ReadVtpFile(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckVtkStart(path, true);
  return Read<CheckedXmlReader<vtkXMLPolyDataReader>>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadVtuFile(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckVtkStart(path, true);
  return Read<CheckedXmlReader<vtkXMLUnstructuredGridReader>>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadLegacyVtkFile(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckVtkStart(path, false);
  switch (LegacyTypeOf(path))
  {
    case LegacyType::PolyData:
      return ReadLegacy<LegacyPolyDataReader>(path, messages, progress);
    case LegacyType::UnstructuredGrid:
      return ReadLegacy<LegacyGridReader>(path, messages, progress);
    case LegacyType::Other:
      break;
  }
  return ReadLegacy<vtkGenericDataObjectReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadObjFile(
  const std::string& path, VtkMessages&, Progress& progress)
{
  return ReadObj(path, Follow(progress));
}

vtkSmartPointer<vtkDataObject> ReadStlFile(
  const std::string& path, VtkMessages&, Progress& progress)
{
  return ReadStl(path, Follow(progress));
}

vtkSmartPointer<vtkDataObject> ReadPlyFile(
  const std::string& path, VtkMessages&, Progress& progress)
{
  return ReadPly(path, Follow(progress));
}

} // namespace lambent::command
