// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Reads simulation results at the first time step, with all arrays, so that they can be contoured.

#include "CheckEnSight.h"
#include "CheckNetCdf.h"
#include "Messages.h"
#include "ReadThroughVtk.h"
#include "Readers.h"

#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkOpenFOAMReader.h"
#include "vtkSetGet.h"

#include <string>
#include <vector>

#ifdef LAMBENT_HAS_ENSIGHT
#include "vtkGenericEnSightReader.h"
#endif
#ifdef LAMBENT_HAS_EXODUS
#include "vtkExodusIIReader.h"
#endif

namespace lambent::command
{

vtkSmartPointer<vtkDataObject> ReadFoam(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  vtkNew<vtkOpenFOAMReader> reader;
  reader->SetFileName(path.c_str());
  return RunAtFirstTime(reader, messages, progress);
}

#ifdef LAMBENT_HAS_ENSIGHT
vtkSmartPointer<vtkDataObject> ReadEnSight(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  const std::vector<BrokenVariable> broken = CheckEnSight(path);
  vtkNew<vtkGenericEnSightReader> reader;
  reader->SetCaseFileName(path.c_str());
  for (const BrokenVariable& variable : broken)
  {
    reader->UpdateInformation();
    variable.isAtPoints ? reader->SetPointArrayStatus(variable.name.c_str(), 0)
                        : reader->SetCellArrayStatus(variable.name.c_str(), 0);
  }
  const vtkSmartPointer<vtkDataObject> data = RunAtFirstTime(reader, messages, progress);
  const std::vector<std::string> warnings = messages.TakeWarnings();
  if (!warnings.empty()) // about truncated files; the reader continues after such a warning
  {
    throw Failure(
      warnings.front() + "; check that this file and all files that it names are complete");
  }
  for (const BrokenVariable& variable : broken)
  {
    vtkGenericWarningMacro(<< "its variable " << variable.name << " is skipped: the file '"
                           << variable.file << "' is incomplete");
  }
  return data;
}
#endif

#ifdef LAMBENT_HAS_EXODUS
vtkSmartPointer<vtkDataObject> ReadExodus(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckNetCdf(path);
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
  return RunAtFirstTime(reader, messages, progress);
}
#endif

} // namespace lambent::command
