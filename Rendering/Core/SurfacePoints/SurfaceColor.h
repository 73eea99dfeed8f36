// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the colour of a surface at a point: where it comes from is known here and nowhere else
 *
 * colorOf() is the definition. loadColors() gives a batch the same colours.
 */
#ifndef lambent_SurfaceColor_h
#define lambent_SurfaceColor_h

#include "Surface.h"

namespace lambent
{
struct RunRange;
struct SampleBatch;

/// What the light model knows of a surface's colour.
struct SurfaceColor
{
  bool isUnlit;
  Vec3 diffuse; ///< rho_d; the plain colour if unlit
  Vec3 ambient; ///< rho_a; not used if unlit
};

SurfaceColor colorOf(const Appearance& appearance);

/// Fills in SampleBatch::diffuse and ambient of the samples in a range that hit something.
void loadColors(const RunRange& range, SampleBatch& batch);
}

#endif
