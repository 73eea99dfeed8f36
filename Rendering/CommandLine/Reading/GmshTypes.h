// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Gmsh element types
 *
 * Reference: the manual of Gmsh, "MSH file format", elm-type.
 */

#ifndef GmshTypes_h
#define GmshTypes_h

#include "NumberedMesh.h"

namespace lambent::command
{

struct GmshType
{
  int number;
  int nodes;
  ElementShape shape; ///< has no corners for points and lines, which are not drawn
};

/// Returns null if the type is unknown.
const GmshType* FindGmshType(std::int64_t number);

} // namespace lambent::command

#endif
