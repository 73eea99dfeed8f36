// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief polygons and the triangles of strips, in one list
 *
 * The unchanged polygons come first, then the triangles of each strip. Every second triangle
 * of a strip swaps its first two points, so that all are oriented like the first.
 */
#ifndef lambent_MergedFaces_h
#define lambent_MergedFaces_h

#include "CellView.h"
#include "Parallel.h"
#include "UnwrittenVector.h"

#include <cstdint>

namespace lambent
{
struct MergedFaces
{
  UnwrittenVector<std::int64_t> offsets;
  UnwrittenVector<std::int64_t> connectivity;
  /// The cell id of each face: polygons count from 0, strips follow the last polygon.
  UnwrittenVector<std::int64_t> cells;

  bool isEmpty() const { return this->offsets.empty(); }

  CellSpan span() const
  {
    return { { this->offsets.data(), true, this->offsets.size() },
      { this->connectivity.data(), true, this->connectivity.size() } };
  }
};

/// The offsets of both must not be broken. There may be no strips.
MergedFaces mergeFaces(const CellSpan& polygons, const CellSpan& strips, const Parallel& parallel);
}

#endif
