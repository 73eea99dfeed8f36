// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Abaqus element types
 *
 * A name consists of a family, the number of nodes, and letters that do not matter for a picture:
 * C3D8R is a hexahedron of the family C3D with reduced integration.
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
  ElementShape shape; ///< has no corners if the type is not drawn
};

/// `name` must be in capitals.
AbaqusType FindAbaqusType(const std::string& name);

} // namespace lambent::command

#endif
