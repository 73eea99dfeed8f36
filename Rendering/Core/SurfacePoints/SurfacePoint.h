// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a surface point: all that the light model and the passes know of a hit
 *
 * Each kind of primitive fills it in a file of its own. Later steps do not depend on the kind.
 */
#ifndef lambent_SurfacePoint_h
#define lambent_SurfacePoint_h

#include "SurfaceColor.h"

namespace lambent
{
struct SurfacePoint
{
  Vec3 position; ///< relative to the eye, along the world's axes
  double depth;  ///< along the viewing direction
  Vec3 normal;   ///< of any length, pointing to the side that is lit
  Vec3 weights;  ///< barycentric coordinates: of attributes at the primitive's points
  SurfaceColor color;
  TextureColor texture{}; ///< multiplies the colour that the light model gives, and the opacity

  double opacity() const { return clampedOpacity(this->color.opacity * this->texture.alpha); }
};
}

#endif
