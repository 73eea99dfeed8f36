// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief read a polygon mesh from a PLY file
 *
 * Text and binary of either byte order: the coordinates and normals of the
 * vertices, the vertex lists of the faces, the triangle strips of the element
 * "tristrips"; all other elements and properties are passed over. Coordinates
 * keep their precision: float stays float, double stays double. What is left over
 * on a line of text, or behind the last element, is ignored with a warning.
 *
 * vtkPLYReader is not used, for three reasons: it narrows double coordinates to
 * float, it trusts the header (a text file that is cut short makes it read
 * beyond its line, and a huge count makes it allocate that much), and item by
 * item through a stream it takes ten times as long.
 *
 * How: the whole file is read into memory; the header becomes a list of
 * elements with their properties; one cursor goes through the rest. Every step
 * of the cursor is checked against the end of the file, and a count is believed
 * only if the rest of the file can hold it.
 *
 * Reference: G. Turk, "The PLY Polygon File Format", 1994.
 */

#ifndef ReadPly_h
#define ReadPly_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkPolyData;

namespace lambent::command
{

/// The mesh in the file; throws Failure if it is cut short or not a PLY file.
vtkSmartPointer<vtkPolyData> ReadPly(
  const std::string& path, const std::function<void(double)>& progress);

} // namespace lambent::command

#endif
