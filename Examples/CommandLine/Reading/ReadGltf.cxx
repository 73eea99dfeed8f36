// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadThroughVtk.h"
#include "Readers.h"

#include "vtkDataObject.h"
#include "vtkGLTFReader.h"

namespace lambent::command
{

vtkSmartPointer<vtkDataObject> ReadGltf(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  return Read<vtkGLTFReader>(path, messages, progress);
}

} // namespace lambent::command
