// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief intersect() for many rays at a time
 *
 * One triangle after the other, with several rays of a row at a time. Lane by lane
 * the arithmetic is that of CameraFrame::toFrame() and intersect(), in the same
 * order, and so are the bits. What is left out cannot matter: the box test where the
 * box is known to be exact, and the test that the sum is not zero, which the depth
 * 0 / 0 fails anyway.
 */
#ifndef lambent_CastingKernel_h
#define lambent_CastingKernel_h

#include "CastBatch.h"
#include "CellRays.h"

namespace lambent
{
void castBatch(const CameraFrame& frame, const CastBatch& batch, CellRays& rays);
}

#endif
