// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief textures multiply the colours of surface points
 *
 * The colour of the texture multiplies the colour that the light model gives, as in VTK's OpenGL
 * mapper: diffuse, ambient and any other light alike, wherever the surface's own colour comes from.
 *
 * textureAt() is the definition. multiplyByTextures() calls it for many samples.
 */
#ifndef lambent_TextureFactors_h
#define lambent_TextureFactors_h

#include "RunRange.h"
#include "Surface.h"

namespace lambent
{
/// The colour of a surface's texture at a point of a triangle with these barycentric coordinates.
/// The surface must have a texture.
TextureColor textureAt(const Surface& surface, std::size_t triangle, const Vec3& weights);

/// Multiplies the colours of the samples of a range that has textures, and stores the alpha of the
/// textures. The weights of the samples must be stored in the batch.
void multiplyByTextures(const RunRange& range, SampleBatch& batch);
}

#endif
