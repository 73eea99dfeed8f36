// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads triangles from an STL file, text or binary
 *
 * Corners with equal coordinates become one point, as with vtkSTLReader, so that shading can be
 * smooth. The cells are in file order, and the points in the order of their first occurrence. The
 * normals in the file are ignored, since they follow from the corners. Coordinates are double for
 * text and float for binary files.
 *
 * vtkSTLReader is not used: it mistakes text in capitals or with a non-ASCII name for binary,
 * accepts any bytes as binary triangles, narrows the coordinates of text files, and is slower.
 *
 * A file is binary if its size matches exactly the number of triangles in its header. Otherwise it
 * is text if it begins with "solid" or "facet", in upper or lower case, and has no zero byte near
 * its start. All other files are read as binary.
 *
 * - Binary: fewer triangles than the header counts are a Failure. If more whole triangles fill the
 *   file, the count is wrong, and all of them are read with a warning. Any other excess bytes are
 *   ignored with a warning.
 * - Text: keywords may be in capitals. A facet may have more than three corners. An unexpected word
 *   is a Failure that names the line, and so is a file that ends within a solid. Several solids
 *   form one mesh. Text after the last solid is ignored with a warning.
 */

#ifndef ReadStl_h
#define ReadStl_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkPolyData;

namespace lambent::command
{

/// The mesh in the file. Throws Failure if the file is truncated or not an STL file.
vtkSmartPointer<vtkPolyData> ReadStl(
  const std::string& path, const std::function<void(double)>& progress);

} // namespace lambent::command

#endif
