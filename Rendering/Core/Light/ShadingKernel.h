// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Shader::color() and toByte() for several rays at a time
 *
 * Lane by lane the arithmetic is theirs, in the same order, and so are the bits.
 */
#ifndef lambent_ShadingKernel_h
#define lambent_ShadingKernel_h

#include "ShadeBatch.h"
#include "Shading.h"

namespace lambent
{
/// Fill in the colours of the rays whose runs are wanted; the points and normals of all runs
/// of the range are there. smooth: there are normals at the corners, else one of the face.
void shadeHits(const Shader& shader, const Material& material, bool smooth, const ShadeRange& range,
  ShadeBatch& batch);

/// Write the colours of a piece's rays as the bytes of its pixels.
void storeBytes(const ShadeBatch& batch, int piece, unsigned char* pixels);
}

#endif
