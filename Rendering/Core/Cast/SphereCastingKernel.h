// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief tests the rays of a tile against a batch of spheres, several rays of a row at a time
 *
 * The hits and their depths are those of intersectSphere(). A depth becomes a range of nearness,
 * as in nearnessOf(), which is compared with that of the stored hit. Only where the two overlap
 * must depths be compared.
 */
#ifndef lambent_SphereCastingKernel_h
#define lambent_SphereCastingKernel_h

#include "CameraFrame.h"
#include "Layers.h"
#include "SphereBatch.h"
#include "TileSamples.h"

namespace lambent
{
/// Casts the batch. Stores hits in the policy, or appends them to batch.hits. Returns a lower bound
/// on the nearness of all hits of the tile before.
float castBatch(
  const CameraFrame& frame, const TileSamples& samples, Nearest& nearest, SphereBatch& batch);
float castBatch(
  const CameraFrame& frame, const TileSamples& samples, Layers& layers, SphereBatch& batch);
}

#endif
