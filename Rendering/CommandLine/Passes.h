// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief requests the passes of `--pass` from the ray tracer, and writes them to their files
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

/// Requests the passes from the ray tracer. Throws Failure if no input has one of the arrays (the
/// message lists those that exist), or if both a point array and a cell array have its name.
void RequestPasses(const std::vector<PassValue>& passes,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, vtkLambentRayTracer* tracer);

/**
 * Writes each pass that has a file. A .vti holds the array unchanged. A .tif holds 32-bit floats,
 * to which doubles are rounded. Throws Failure if an id or another integer of a cell would be
 * rounded, or if a finite value is beyond the range of floats.
 */
void WritePasses(const std::vector<PassValue>& passes, vtkImageData* picture,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, VtkMessages& messages,
  Progress& progress);

/// Removes the id arrays that no pass requests: the ray tracer generates both of them together,
/// also for a comparison.
void KeepOnlyPasses(const std::vector<PassValue>& passes, vtkImageData* picture);

} // namespace lambent::command

#endif
