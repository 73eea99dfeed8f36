// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief loads the corners and normals of the triangles that samples hit
 */
#ifndef lambent_LoadTriangles_h
#define lambent_LoadTriangles_h

#include "RunRange.h"

namespace lambent
{
/// Fills in isWanted, points and normals for the runs of a range.
void loadTriangles(const RunRange& range, SampleBatch& batch);
}

#endif
