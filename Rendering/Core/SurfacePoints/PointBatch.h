// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the surface points of a batch of samples, for passes
 */
#ifndef lambent_PointBatch_h
#define lambent_PointBatch_h

#include "SampleBatch.h"

namespace lambent
{
/// One value for each place of a SampleBatch. Undefined where a sample hits nothing.
struct PointBatch
{
  alignas(64) double depth[SampleBatch::places];
  double normal[3][SampleBatch::places];   ///< of length 1
  double position[3][SampleBatch::places]; ///< in the world
  double weights[3][SampleBatch::places];
};
}

#endif
