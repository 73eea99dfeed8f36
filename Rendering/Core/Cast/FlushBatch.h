// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief casts a batch of one kind of primitive, and empties it
 */
#ifndef lambent_FlushBatch_h
#define lambent_FlushBatch_h

#include "TileHits.h"

namespace lambent
{
/// Keeps the batch's hits. The kernel of its kind, castBatch(), leaves those open whose depth must
/// be computed.
template <typename Policy, typename Batch>
void flushBatch(const FrameMesh& mesh, TileHits<Policy>& tile, Batch& batch)
{
  tile.least = castBatch(mesh.frame(), tile.samples, tile.hits, batch);
  offerHits(mesh, tile, batch.hits);
  batch.count = 0;
}
}

#endif
