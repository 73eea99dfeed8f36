// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the types of elements that Gmsh numbers
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
  ElementShape shape; ///< with no corners for points and lines, which are not drawn
};

/// Null if the type is not known.
const GmshType* FindGmshType(std::int64_t number);

} // namespace lambent::command

#endif
