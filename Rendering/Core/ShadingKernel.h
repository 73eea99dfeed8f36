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
/// Fill in the colours and bytes of a batch whose hits, points and normals are
/// there. smooth: there are normals at the corners, else one of the face.
void shadeBatch(const Shader& shader, const Material& material, bool smooth, ShadeBatch& batch);
}

#endif
