// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the normals of faces at the corners of the triangles that they are cut into
 */
#ifndef lambent_TriangleNormals_h
#define lambent_TriangleNormals_h

#include "CornerNormals.h"

#include <vector>

namespace lambent
{
/**
 * The number of the normal at each corner of the triangles of Triangulation.h: those of the
 * faces in ascending order, n - 2 for a face of n corners. There must be numbers in
 * `normals`. A corner at a point that its face does not name (a triangle that stands for a
 * face with a point that is not finite) gets the point's number.
 */
std::vector<std::int32_t> numbersOfTriangles(const CellSpan& faces, const CornerNormals& normals,
  const IndexSpan& corners, const Parallel& parallel);
}

#endif
