// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief loads the spheres that samples hit
 */
#ifndef lambent_LoadSpheres_h
#define lambent_LoadSpheres_h

#include "RunRange.h"

namespace lambent
{
/// Rows of SampleBatch::points with the numbers of spheres.
namespace SphereRows
{
constexpr int center = 0;        ///< three: in the world
constexpr int centerInFrame = 3; ///< three, filled in by VectorSpherePoints
constexpr int radius = 6;
constexpr int hasOutside = 7; ///< 1 if the outside is drawn, 0 otherwise
}

/// Fills in isWanted, centre, radius and hasOutside for the runs of a range.
void loadSpheres(const RunRange& range, SampleBatch& batch);
}

#endif
