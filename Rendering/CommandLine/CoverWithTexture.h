// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the texture of `--texture`
 *
 * The image covers all inputs that have texture coordinates. It replaces the materials of OBJ
 * files, and multiplies the colours of the lit surfaces.
 */

#ifndef CoverWithTexture_h
#define CoverWithTexture_h

#include "MaterialInputs.h"

namespace lambent::command
{

/// Reads the image and returns the looks of the meshes. A mesh without texture coordinates causes a
/// warning. Throws WrongUsage if no mesh has some, and Failure if the image cannot be read.
std::vector<MeshLooks> CoverWithTexture(const Options& options,
  const MaterialInputs::Meshes& meshes, VtkMessages& messages, Progress& progress);

} // namespace lambent::command

#endif
