// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "GmshTypes.h"

#include <algorithm>
#include <iterator>

namespace lambent::command
{
namespace
{

constexpr ElementShape None{ VTK_EMPTY_CELL, 0 };
constexpr ElementShape Triangle{ VTK_TRIANGLE, 3 };
constexpr ElementShape Quad{ VTK_QUAD, 4 };
constexpr ElementShape Tetra{ VTK_TETRA, 4 };
constexpr ElementShape Hexahedron{ VTK_HEXAHEDRON, 8 };
constexpr ElementShape Prism{ VTK_WEDGE, 6 };
constexpr ElementShape Pyramid{ VTK_PYRAMID, 5 };

// clang-format off
const GmshType Types[] = {
  { 1, 2, None }, { 2, 3, Triangle }, { 3, 4, Quad }, { 4, 4, Tetra }, { 5, 8, Hexahedron },
  { 6, 6, Prism }, { 7, 5, Pyramid }, { 8, 3, None }, { 9, 6, Triangle }, { 10, 9, Quad },
  { 11, 10, Tetra }, { 12, 27, Hexahedron }, { 13, 18, Prism }, { 14, 14, Pyramid },
  { 15, 1, None }, { 16, 8, Quad }, { 17, 20, Hexahedron }, { 18, 15, Prism }, { 19, 13, Pyramid },
  { 20, 9, Triangle }, { 21, 10, Triangle }, { 22, 12, Triangle }, { 23, 15, Triangle },
  { 24, 15, Triangle }, { 25, 21, Triangle }, { 26, 4, None }, { 27, 5, None }, { 28, 6, None },
  { 29, 20, Tetra }, { 30, 35, Tetra }, { 31, 56, Tetra }, { 36, 16, Quad }, { 37, 25, Quad },
  { 38, 36, Quad }, { 92, 64, Hexahedron }, { 93, 125, Hexahedron },
};
// clang-format on

} // namespace

const GmshType* FindGmshType(std::int64_t number)
{
  const auto* const type = std::find_if(std::begin(Types), std::end(Types),
    [number](const GmshType& known) { return known.number == number; });
  return type != std::end(Types) ? type : nullptr;
}

} // namespace lambent::command
