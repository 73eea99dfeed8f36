// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief give a polydata other points and polygons, and let its data follow
 *
 * The output starts as a shallow copy of the input. What is changed is replaced by
 * new arrays, so that the input keeps its own. Both throw std::runtime_error, with what
 * to do about it, if data that is to follow has the wrong length.
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

/// Append a copy of each of these points of the input, with its point data.
void copyPoints(
  vtkPolyData* input, const std::vector<std::int64_t>& copiedPoints, vtkPolyData* output);

/// Make the faces of the mesh the output's polygons, with another connectivity of the
/// same length unless that is empty. No strips are left; cell data follows.
void setPolygons(const FacesFromVTK& mesh, const std::vector<std::int64_t>& connectivity,
  vtkPolyData* output, const Parallel& parallel);

/// Let the points of each polygon run the other way. Only after setPolygons().
void reversePolygons(vtkPolyData* output, const Parallel& parallel);
}

#endif
