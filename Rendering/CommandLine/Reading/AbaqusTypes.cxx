// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "AbaqusTypes.h"
#include "TextNumber.h"

namespace lambent::command
{
namespace
{

/// Families of shells, membranes, plane and axisymmetric elements, and rigid surfaces.
const char* const Flat[] = { "S", "STRI", "M3D", "CPS", "CPE", "CAX", "R3D", "SFM3D", "DS", "DC2D",
  "DCAX", "AC2D" };
/// Families of volumes.
const char* const Solid[] = { "C3D", "DC3D", "AC3D", "SC" };

ElementShape FlatShape(std::int64_t nodes)
{
  switch (nodes)
  {
    case 3:
    case 6:
      return { VTK_TRIANGLE, 3 };
    case 4:
    case 8:
    case 9:
      return { VTK_QUAD, 4 };
    default:
      return {};
  }
}

ElementShape SolidShape(std::int64_t nodes)
{
  switch (nodes)
  {
    case 4:
    case 10:
      return { VTK_TETRA, 4 };
    case 5:
      return { VTK_PYRAMID, 5 };
    case 6:
    case 15:
      return { VTK_WEDGE, 6 };
    case 8:
    case 20:
      return { VTK_HEXAHEDRON, 8 };
    default:
      return {};
  }
}

/// The number of nodes after the family's name; 0 if the type belongs to another family.
std::int64_t NodesBehind(const std::string& family, const std::string& name)
{
  std::int64_t nodes = 0;
  const char* const digits = name.c_str() + family.size();
  if (name.compare(0, family.size(), family) == 0 && *digits >= '0' && *digits <= '9')
  {
    ReadInteger(digits, nodes);
  }
  return name == "STRI65" ? 6 : nodes; // the 5 counts degrees of freedom per node
}

} // namespace

AbaqusType FindAbaqusType(const std::string& name)
{
  for (const char* const family : Flat)
  {
    const std::int64_t nodes = NodesBehind(family, name);
    if (FlatShape(nodes).corners > 0)
    {
      return { static_cast<int>(nodes), FlatShape(nodes) };
    }
  }
  for (const char* const family : Solid)
  {
    const std::int64_t nodes = NodesBehind(family, name);
    if (SolidShape(nodes).corners > 0)
    {
      return { static_cast<int>(nodes), SolidShape(nodes) };
    }
  }
  return {};
}

} // namespace lambent::command
