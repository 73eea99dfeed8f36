// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief runs a VTK reader and turns reported errors into a Failure
 */

#ifndef ReadThroughVtk_h
#define ReadThroughVtk_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;
class vtkDataObject;

namespace lambent::command
{

class Progress;
class VtkMessages;

/// Updates a reader and returns its output. Throws Failure if the reader reported an error, because
/// most readers then return incomplete output.
vtkSmartPointer<vtkDataObject> Run(vtkAlgorithm* reader, VtkMessages& messages, Progress& progress);

/// Like Run(), but at the reader's first time step, if it has any.
vtkSmartPointer<vtkDataObject> RunAtFirstTime(
  vtkAlgorithm* reader, VtkMessages& messages, Progress& progress);

/// Reads a file with a reader that needs only the file name.
template <typename Reader>
vtkSmartPointer<vtkDataObject> Read(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  return Run(reader, messages, progress);
}

} // namespace lambent::command

#endif
