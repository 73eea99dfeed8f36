// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cells of any number of points, and what can be said of all of them
 */
#ifndef lambent_CellSpan_h
#define lambent_CellSpan_h

#include "Parallel.h"
#include "Scene.h"

namespace lambent
{
/// Cell k has the points connectivity[offsets[k]] to connectivity[offsets[k + 1] - 1].
struct CellSpan
{
  IndexSpan offsets; ///< one more than there are cells
  IndexSpan connectivity;
};

enum class CellSizes
{
  Triangles, ///< all of them: the connectivity is that of a Surface
  Mixed,
  Broken ///< offsets that decrease or reach beyond the connectivity
};

CellSizes inspect(const CellSpan& cells, const Parallel& parallel);
}

#endif
