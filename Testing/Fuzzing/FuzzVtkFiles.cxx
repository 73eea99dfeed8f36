// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of VTK's own kinds, legacy and XML, which VTK's readers read with additional checks. The
// result is a Failure, or cells that are safe for the surface filter.
#include "../Rendering/Sanitizers.h"
#include "FuzzInput.h"
#include "NamelessFile.h"

#include "CheckCells.h"
#include "CheckedXmlReader.h"
#include "LinearCells.h"
#include "Messages.h"
#include "ReadLegacyVtk.h"

#include "vtkCellArray.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#if LAMBENT_ADDRESS_SANITIZER
#include <sanitizer/lsan_interface.h>
#endif

using namespace lambent::command;

namespace
{
template <typename Reader>
vtkSmartPointer<vtkDataObject> read(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetFailure().empty() ? reader->GetOutputDataObject(0) : nullptr;
}

vtkSmartPointer<vtkDataObject> read(std::string_view text, const std::string& path)
{
  if (text.substr(0, 5) != "# vtk")
  {
    return text.find("type=\"U") == std::string_view::npos
      ? read<CheckedXmlReader<vtkXMLPolyDataReader>>(path)
      : read<CheckedXmlReader<vtkXMLUnstructuredGridReader>>(path);
  }
  switch (LegacyTypeOf(path))
  {
    case LegacyType::PolyData:
      return read<LegacyPolyDataReader>(path);
    case LegacyType::UnstructuredGrid:
      return read<LegacyGridReader>(path);
    case LegacyType::Other:
      break; // only VTK's own code reads it
  }
  return nullptr;
}

void use(vtkDataObject* data)
{
  if (auto* const mesh = vtkPolyData::SafeDownCast(data))
  {
    CheckCells(mesh->GetPolys(), mesh->GetNumberOfPoints());
    CheckCells(mesh->GetStrips(), mesh->GetNumberOfPoints());
  }
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid && grid->GetNumberOfPoints() > 0)
  {
    CheckCells(grid);
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputData(WithLinearCells(grid));
    surface->Update();
    vtkPolyData* const mesh = surface->GetOutput();
    CheckCells(mesh->GetPolys(), mesh->GetNumberOfPoints());
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
#if LAMBENT_ADDRESS_SANITIZER
  const __lsan::ScopedDisabler isTolerated; // VTK's readers leak arrays if a file is broken
#endif
  vtkObject::GlobalWarningDisplayOff(); // VTK's readers complain about most of this
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const NamelessFile file(data, size);
  try
  {
    use(read(text, file.path()));
  }
  catch (const Failure& failure)
  {
    require(*failure.what() != '\0', "a failure says why");
  }
  catch (const std::bad_alloc&)
  {
    // a count that the file could just hold
  }
  return 0;
}
