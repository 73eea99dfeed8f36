// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief replace the points and polygons of a polydata, and adapt its data
 *
 * The output starts as a shallow copy of the input. Changed parts are replaced by new arrays, so
 * the input keeps its own. copyPoints() and setPolygons() throw std::runtime_error, with the
 * remedy in its message, if an array that they must adapt has the wrong length.
 */
#ifndef PolyDataRewrite_h
#define PolyDataRewrite_h

#include <cstdint>
#include <vector>

class vtkPolyData;

namespace lambent
{
class Parallel;
}

namespace lambent::adapters
{
class FacesFromVTK;

/// Appends a copy of each listed point of the input, with its point data.
void copyPoints(
  vtkPolyData* input, const std::vector<std::int64_t>& copiedPoints, vtkPolyData* output);

/// Makes the faces of the mesh the output's polygons. A connectivity that is not empty replaces
/// that of the faces; it must have the same length. Removes all strips and adapts the cell data.
void setPolygons(const FacesFromVTK& mesh, const std::vector<std::int64_t>& connectivity,
  vtkPolyData* output, const Parallel& parallel);

/// Reverses the order of each polygon's points. Call this after setPolygons() only.
void reversePolygons(vtkPolyData* output, const Parallel& parallel);
}

#endif
