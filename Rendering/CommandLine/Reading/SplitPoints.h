// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief gives the corners of faces that differ in something points of their own
 *
 * An OBJ file may name another normal or texture coordinate at each corner of each
 * face; a vtkPolyData has one a point. So a point whose corners differ becomes
 * several.
 */

#ifndef SplitPoints_h
#define SplitPoints_h

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace lambent::command
{

/// Of a corner to which every key is equal, and of a point no corner of which has one.
constexpr std::int32_t NoKey = std::numeric_limits<std::int32_t>::min();

struct SplitPoints
{
  /// Changes the corners, which are point ids, so that corners with different keys have different
  /// points. Each point keeps its id for the key that comes first at it; for each further key a
  /// copy is appended, in the order of the corners.
  SplitPoints(std::vector<std::int32_t>& corners, const std::vector<std::int32_t>& keys,
    std::size_t numberOfPoints);

  std::vector<std::int32_t> keyOfPoint;
  std::vector<std::int32_t> copies; ///< of which point each appended one is a copy
};

} // namespace lambent::command

#endif
