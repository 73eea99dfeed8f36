// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief finds the rays of a tile that hit a line, several rays of a row at a time
 *
 * A line covers a small part of its box. So each row is tested only where LineBounds.h says that
 * the line may be. The hits and their depths are those of intersectLine().
 */
#ifndef lambent_LineCastingKernel_h
#define lambent_LineCastingKernel_h

#include "CameraFrame.h"
#include "ExactHit.h"
#include "LineContract.h"
#include "TileSamples.h"

#include <vector>

namespace lambent
{
/// Appends the hits of the rays in a box, whose samples are counted from the first of the tile.
void findLineHits(const CameraFrame& frame, const TileSamples& samples, const Line& line,
  std::uint32_t number, const Window& box, std::vector<ExactHit>& hits);
}

#endif
