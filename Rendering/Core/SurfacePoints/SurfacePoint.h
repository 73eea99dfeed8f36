// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what light and film know of a hit, whatever was hit
 *
 * Each kind of primitive fills it in its own file; nothing after that asks for the kind.
 */
#ifndef lambent_SurfacePoint_h
#define lambent_SurfacePoint_h

#include "Surface.h"

namespace lambent
{
struct SurfacePoint
{
  Vec3 position; ///< relative to the eye, with the world's axes
  double depth;  ///< along the viewing direction
  Vec3 normal;   ///< of any length, on the side that is lit
  const Appearance* appearance;
};
}

#endif
