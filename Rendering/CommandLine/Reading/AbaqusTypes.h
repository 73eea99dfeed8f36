// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the types of elements that Abaqus names
 *
 * A name is a family, the number of nodes, and letters for what does not matter to
 * a picture: C3D8R is a hexahedron of the family C3D with reduced integration.
 */

#ifndef AbaqusTypes_h
#define AbaqusTypes_h

#include "NumberedMesh.h"

#include <string>

namespace lambent::command
{

struct AbaqusType
{
  int nodes = 0;
  ElementShape shape; ///< with no corners if the type is not drawn
};

/// The name is in capitals.
AbaqusType FindAbaqusType(const std::string& name);

} // namespace lambent::command

#endif
