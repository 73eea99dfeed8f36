// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SplitPoints.h"
#include "IdTable.h"
#include "Messages.h"

namespace lambent::command
{

SplitPoints::SplitPoints(std::vector<std::int32_t>& corners, const std::vector<std::int32_t>& keys,
  std::size_t numberOfPoints)
  : keyOfPoint(numberOfPoints, NoKey)
{
  IdTable table; // only of the copies, because most points need none
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    const std::int32_t point = corners[c];
    const std::int32_t key = keys[c];
    std::int32_t& firstKey = this->keyOfPoint[static_cast<std::size_t>(point)];
    if (firstKey == NoKey)
    {
      firstKey = key;
    }
    if (key == NoKey || key == firstKey)
    {
      continue;
    }
    const std::size_t size = this->keyOfPoint.size();
    if (size >= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    {
      throw Failure("it has too many points with several normals or texture coordinates");
    }
    const std::uint64_t hash =
      MixBits(static_cast<std::uint64_t>(point) << 32 | static_cast<std::uint32_t>(key));
    corners[c] = table.FindOrAdd(hash, static_cast<std::int32_t>(size),
      [&](std::int32_t copy)
      {
        const std::size_t id = static_cast<std::size_t>(copy);
        return this->copies[id - numberOfPoints] == point && this->keyOfPoint[id] == key;
      });
    if (corners[c] == static_cast<std::int32_t>(size))
    {
      this->copies.push_back(point);
      this->keyOfPoint.push_back(key);
    }
  }
}

} // namespace lambent::command
