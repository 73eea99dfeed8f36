// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the surface on which an array of a volume has a value
 *
 * Images go through vtkFlyingEdges3D, every other volume through
 * vtkContourFilter. Without a name the array is the active scalars of the
 * points, or else the only array of the points, or, where these have none, of
 * the cells; arrays with several components do not count. Cell data is first averaged
 * at the points (vtkCellDataToPointData).
 */

#ifndef Contour_h
#define Contour_h

#include "Values.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkPolyData;

namespace lambent::command
{

class Progress;
class VtkMessages;

/// Whether the cells of a data set can be cut by a contour: any but polygon meshes.
bool IsVolume(vtkDataSet* data);

/**
 * The contours of some volumes, which are the blocks of one file; a volume that
 * lacks the array, or whose values do not reach the contour's, has none. Throws
 * Failure if nothing is left, naming the arrays and their ranges.
 */
std::vector<vtkSmartPointer<vtkPolyData>> ContoursOf(const std::vector<vtkDataSet*>& volumes,
  const ContourValue& contour, VtkMessages& messages, Progress& progress);

/// The arrays that can be contoured, as a message lists them: "density from 0 to 255, ...".
std::string DescribeArrays(const std::vector<vtkDataSet*>& volumes);

} // namespace lambent::command

#endif
