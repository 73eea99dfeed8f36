// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief draws the edges of cells over the colours of a batch
 */
#ifndef lambent_EdgeMixing_h
#define lambent_EdgeMixing_h

#include "CellEdges.h"
#include "RunRange.h"

namespace lambent
{
/// Mixes the colours of samples at edges with those of the edges, as CellEdges::mixed() does. The
/// samples of the range must have their colours, and belong to the tile.
void mixEdges(const CellEdges& edges, const RunRange& range, SampleBatch& batch, EdgesInTile& tile);
}

#endif
