// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief warns of options that have no effect on the inputs
 */

#ifndef IdleOptions_h
#define IdleOptions_h

#include "MaterialInputs.h"
#include "Options.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;
class vtkPolyData;

namespace lambent::command
{

/// Warns, unless the command is quiet, and drops the options of which the ray tracer itself would
/// warn: it would name methods instead of options. The background image may be null.
void DropIdleOptions(Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes,
  const std::vector<MeshLooks>& looks, vtkImageData* background);

} // namespace lambent::command

#endif
