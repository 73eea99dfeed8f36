// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief run a reader of VTK's and turn what it reports into a Failure
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

/// Updates a reader and returns its output. Throws Failure if the reader reported an error: most of
/// them return what they have read so far.
vtkSmartPointer<vtkDataObject> Run(vtkAlgorithm* reader, VtkMessages& messages, Progress& progress);

/// As Run(), at the first time step that the reader offers, if it offers any.
vtkSmartPointer<vtkDataObject> RunAtFirstTime(
  vtkAlgorithm* reader, VtkMessages& messages, Progress& progress);

/// Reads a file with a reader that needs the name of the file only.
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
