// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads a polygon mesh from a PLY file
 *
 * Reads text, and binary of either byte order: the coordinates, normals and colours of the
 * vertices, the vertex lists of the faces, and the triangle strips of the element "tristrips". All
 * other elements and properties are skipped. Colours (red, green, blue, and alpha if there is one)
 * are bytes, or floats from 0 to 1, which become bytes; they are the active scalars "RGB" or
 * "RGBA". Coordinates keep their precision, float or double. Excess numbers on a line of text, and
 * bytes after the last element, are ignored with a warning.
 *
 * vtkPLYReader is not used, for three reasons: it narrows double coordinates to float; it trusts
 * the header (it reads beyond a line of a truncated text file, and allocates whatever a count
 * says); and it takes ten times as long, because it reads item by item from a stream.
 *
 * 1. Read the whole file into memory.
 * 2. Parse the header into a list of elements with their properties.
 * 3. Read the elements with a cursor. Every step is checked against the end of the file, and a
 *    count is accepted only if the rest of the file can hold it.
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

/// The mesh in the file. Throws Failure if the file is truncated or not a PLY file.
vtkSmartPointer<vtkPolyData> ReadPly(
  const std::string& path, const std::function<void(double)>& progress);

} // namespace lambent::command

#endif
