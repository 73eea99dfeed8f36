// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief classify a list of cells by their sizes, and validate its offsets
 */
#ifndef lambent_CellSizes_h
#define lambent_CellSizes_h

#include "Parallel.h"
#include "Spans.h"

namespace lambent
{
enum class CellSizes
{
  Triangles, ///< only triangles: a Surface can use the connectivity unchanged
  Mixed,
  Broken ///< some offset decreases or exceeds the size of the connectivity
};

CellSizes inspect(const CellSpan& cells, const Parallel& parallel);
}

#endif
