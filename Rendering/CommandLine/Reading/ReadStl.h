// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief read triangles from an STL file, text or binary
 *
 * Corners at equal coordinates become one point, as with vtkSTLReader, so that
 * shading can be smooth. The order of the cells is that of the file, and the
 * points have the order in which they come first. The normals in the file are
 * not used: they follow from the corners. Coordinates are double in text and
 * float in binary, as in the file.
 *
 * vtkSTLReader is not used: it takes text in capitals, or with a name that is not
 * ASCII, for binary, takes any bytes for binary triangles, narrows the
 * coordinates of texts, and is slower.
 *
 * Which of the two a file is: binary if its size is just that of the triangles
 * that it counts. Or else text if it begins with "solid" or "facet", in any case,
 * and has no zero byte near its start.
 *
 * - Binary: fewer triangles than are counted are a Failure. If there are more,
 *   and they end with the file, then the count is wrong and all of them are read, with a
 *   warning, as it is with any other bytes that are left over.
 * - Text: keywords may be in capitals. A facet may have more corners than three.
 *   Anything else than what is due is a Failure that names the line, and so is a
 *   file that ends within a solid. Several solids are one mesh. What follows the
 *   last one is ignored with a warning.
 */

#ifndef ReadStl_h
#define ReadStl_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkPolyData;

namespace lambent::command
{

/// The mesh in the file; throws Failure if it is cut short or not an STL file.
vtkSmartPointer<vtkPolyData> ReadStl(
  const std::string& path, const std::function<void(double)>& progress);

} // namespace lambent::command

#endif
