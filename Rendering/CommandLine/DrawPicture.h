// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief renders the picture that the options describe, with its passes
 */

#ifndef DrawPicture_h
#define DrawPicture_h

#include "ChangedCells.h"
#include "MaterialInputs.h"
#include "Options.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;
class vtkPolyData;

namespace lambent::command
{

class Progress;
class Stopwatch;
class VtkMessages;

/// A picture with its passes as additional arrays and, for a comparison, the ids of its pixels.
struct Drawing
{
  vtkSmartPointer<vtkImageData> picture;
  PixelIds ids;
};

/// Renders the meshes with their looks. The background image may be null. Warns if no surface is
/// visible. Throws Failure.
Drawing DrawPicture(const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes,
  const std::vector<MeshLooks>& looks, vtkImageData* background, VtkMessages& messages,
  Progress& progress, Stopwatch& stopwatch);

} // namespace lambent::command

#endif
