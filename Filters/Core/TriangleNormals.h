// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the normals of faces at the corners of their triangles
 */
#ifndef lambent_TriangleNormals_h
#define lambent_TriangleNormals_h

#include "CornerNormals.h"
#include "UnwrittenVector.h"

namespace lambent
{
/**
 * The number of the normal at each corner of the triangles of Triangulation.h: n - 2 triangles
 * for a face with n corners, in ascending order of the faces. normals.numbers must be set. If
 * its face does not name a corner's point, the corner gets the number of the point. This
 * happens in a strip with a point that is not finite: all its triangles consist of that point.
 */
UnwrittenVector<std::int32_t> numbersOfTriangles(const CellSpan& faces,
  const CornerNormals& normals, const IndexSpan& corners, const Parallel& parallel);
}

#endif
