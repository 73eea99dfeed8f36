// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the surface on which an array of a volume has a given value
 *
 * Images of three dimensions are contoured by vtkFlyingEdges3D, all other volumes by
 * vtkContourFilter. If no array is named, it is the active point scalars, else the only point
 * array, or the only cell array if there are no point arrays. Arrays with several components are
 * ignored. Cell data is first averaged to the points (vtkCellDataToPointData).
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

/// Whether a data set can be contoured: any but a polygon mesh.
bool IsVolume(vtkDataSet* data);

/**
 * The contours of the volumes of one file. A volume that lacks the array, or whose values do not
 * reach the contour's, has no contour. Throws Failure if there is no contour at all; the message
 * lists the arrays and their ranges.
 */
std::vector<vtkSmartPointer<vtkPolyData>> ContoursOf(const std::vector<vtkDataSet*>& volumes,
  const ContourValue& contour, VtkMessages& messages, Progress& progress);

/// The arrays that can be contoured, as listed in messages: "density from 0 to 255, ...".
std::string DescribeArrays(const std::vector<vtkDataSet*>& volumes);

} // namespace lambent::command

#endif
