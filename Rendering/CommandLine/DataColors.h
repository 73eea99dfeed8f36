// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief adds the meshes to the ray tracer, with their colours from arrays and as spheres
 *
 * An input is coloured by
 *
 * 1. the array of `--color-by`, if the input has it: a point array, or else a cell array. Three or
 *    four unsigned chars per tuple are colours, unless a component is named. All other arrays are
 *    mapped through the table of `--colormap`; several components by their magnitude, unless one is
 *    named. All inputs share one range.
 * 2. its own colours: the active scalars of its points, or else of its cells, if they are three or
 *    four unsigned chars. `--color` turns these off.
 * 3. `--color`, or white.
 *
 * A lookup table in the file, as legacy VTK files may have one, is not used.
 */

#ifndef DataColors_h
#define DataColors_h

#include "Options.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkLambentRayTracer;
class vtkPolyData;

namespace lambent::command
{

/// Throws WrongUsage if no input has the array of `--color-by` or of `--spheres`, or if its numbers
/// do not fit.
void AddMeshes(const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes,
  vtkLambentRayTracer* tracer);

/// One line for the report: "point array temperature, 0 to 100, viridis"; empty without
/// `--color-by`.
std::string DescribeColors(
  const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

/// Whether the active scalars of its points, or else of its cells, are colours.
bool HasOwnColors(vtkPolyData* mesh);

/// Why options about colours have no effect, each with a remedy.
std::vector<std::string> WhyColorsAreIdle(
  const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

} // namespace lambent::command

#endif
