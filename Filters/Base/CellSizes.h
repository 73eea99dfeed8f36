// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what can be said of the sizes of all cells of a list
 */
#ifndef lambent_CellSizes_h
#define lambent_CellSizes_h

#include "Parallel.h"
#include "Spans.h"

namespace lambent
{
enum class CellSizes
{
  Triangles, ///< all of them: the connectivity is that of a Surface
  Mixed,
  Broken ///< offsets that decrease or reach beyond the connectivity
};

CellSizes inspect(const CellSpan& cells, const Parallel& parallel);
}

#endif
