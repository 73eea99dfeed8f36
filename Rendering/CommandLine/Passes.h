// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief renders the passes of `--pass` with the picture, and writes them to their files
 */

#ifndef Passes_h
#define Passes_h

#include "Options.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;
class vtkLambentRayTracer;
class vtkPolyData;

namespace lambent::command
{

class Progress;
class VtkMessages;

/// Asks the ray tracer for the passes. Throws Failure if no input has one of the arrays, or if it
/// is both a point and a cell array; the message lists the arrays that there are.
void RequestPasses(const std::vector<PassValue>& passes,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, vtkLambentRayTracer* tracer);

/**
 * Writes each pass that has a file. A .vti holds the array as it is. A .tif holds 32-bit floats:
 * doubles are rounded. Ids and other integers of cells must not be rounded, and nothing may become
 * infinite; otherwise Failure is thrown.
 */
void WritePasses(const std::vector<PassValue>& passes, vtkImageData* picture,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, VtkMessages& messages,
  Progress& progress);

/// Removes the arrays that no pass asks for: ids that only a comparison needs, or one of the two
/// arrays of ids.
void KeepOnlyPasses(const std::vector<PassValue>& passes, vtkImageData* picture);

} // namespace lambent::command

#endif
