// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which edges of triangles are edges of the polygons that they were cut from
 *
 * The diagonals inside a polygon are not. All edges of a strip's triangles are.
 *
 * An edge is compared by its two points, in any direction. A diagonal between two points that are
 * also joined by an edge of the polygon coincides with it, so marking both changes no picture.
 * Edges of a polygon with many corners are sorted first: O(n log n).
 */
#ifndef lambent_CellEdgeFlags_h
#define lambent_CellEdgeFlags_h

#include "Triangulation.h"

namespace lambent
{
/// One byte for each triangle of the list that triangulate() made of these faces: polygons, or the
/// faces of mergeFaces(). Bit k is the edge from corner k to the next one (Surface::cellEdges).
UnwrittenVector<unsigned char> findCellEdges(
  const CellSpan& faces, const TriangleList& triangles, const Parallel& parallel);
}

#endif
