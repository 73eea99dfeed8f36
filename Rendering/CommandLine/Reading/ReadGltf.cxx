// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Messages.h"
#include "ReadThroughVtk.h"
#include "Readers.h"

#include "vtkDataObject.h"
#include "vtkGLTFReader.h"
#include "vtkObject.h"

namespace lambent::command
{

vtkSmartPointer<vtkDataObject> ReadGltf(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  const vtkSmartPointer<vtkDataObject> data = Read<vtkGLTFReader>(path, messages, progress);
  for (const std::string& warning : messages.TakeWarnings())
  {
    if (warning.find("is required in this model") != std::string::npos)
    {
      throw Failure(warning + "; save it without that extension");
    }
    if (warning.find("is used in this model") == std::string::npos) // mostly about materials
    {
      vtkGenericWarningMacro(<< warning);
    }
  }
  return data;
}

} // namespace lambent::command
