// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief splits points whose corners have different normals or texture coordinates
 *
 * In an OBJ file each corner of each face may name a different normal or texture coordinate, but a
 * vtkPolyData has one for each point. So a point whose corners differ becomes several points.
 */

#ifndef SplitPoints_h
#define SplitPoints_h

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace lambent::command
{

/// The key of a corner that matches any key, and of a point whose corners have no keys.
constexpr std::int32_t NoKey = std::numeric_limits<std::int32_t>::min();

struct SplitPoints
{
  /// Changes the point ids of the corners so that corners with different keys have different
  /// points. A point keeps its id for the first key of its corners; for each further key a copy is
  /// appended, in the order of the corners.
  SplitPoints(std::vector<std::int32_t>& corners, const std::vector<std::int32_t>& keys,
    std::size_t numberOfPoints);

  std::vector<std::int32_t> keyOfPoint;
  std::vector<std::int32_t> copies; ///< the original of each appended point
};

} // namespace lambent::command

#endif
