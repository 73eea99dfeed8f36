// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Shader::color() and toByte() for several hits at a time
 *
 * Lane by lane the arithmetic is theirs, in the same order, and so are the bits.
 */
#ifndef lambent_ShadingKernel_h
#define lambent_ShadingKernel_h

#include "ShadeBatch.h"
#include "Shading.h"

namespace lambent
{
/// Fill in the colours and bytes of hits whose points and normals are there; those of
/// hits beyond the range may be overwritten. smooth: there are normals at the corners,
/// else one of the face.
void shadeHits(const Shader& shader, const Material& material, bool smooth, const ShadeRange& range,
  ShadeBatch& batch);
}

#endif
