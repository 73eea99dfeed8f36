// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the normals of faces at the corners of their triangles
 */
#ifndef lambent_TriangleNormals_h
#define lambent_TriangleNormals_h

#include "CornerNormals.h"

#include <vector>

namespace lambent
{
/**
 * The number of the normal at each corner of the triangles of Triangulation.h: n - 2 triangles
 * for a face with n corners, in ascending order of the faces. `normals` must have numbers. If
 * a triangle's point does not belong to its face (the triangle replaces a face with a point
 * that is not finite), its corner gets the point's number.
 */
std::vector<std::int32_t> numbersOfTriangles(const CellSpan& faces, const CornerNormals& normals,
  const IndexSpan& corners, const Parallel& parallel);
}

#endif
