// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief distinct points, in the order of their first occurrence
 */

#ifndef MergedPoints_h
#define MergedPoints_h

#include "IdTable.h"
#include "Messages.h"

#include <cstring>
#include <limits>

namespace lambent::command
{

/// Coordinates are equal if they have the same bits; zero and minus zero are equal.
template <typename Coordinate>
class MergedPoints
{
public:
  /// Returns the id of the point, after adding it if it is new.
  std::int32_t Add(const Coordinate* coordinates)
  {
    Coordinate point[3];
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i)
    {
      point[i] = coordinates[i] + Coordinate(0); // turns -0 into 0
      std::uint64_t bits = 0;
      std::memcpy(&bits, &point[i], sizeof(Coordinate));
      hash = MixBits(hash ^ bits);
    }
    const std::size_t size = this->Values.size() / 3;
    if (size >= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    {
      throw Failure("it has too many points; divide it into several files");
    }
    const std::int32_t newId = static_cast<std::int32_t>(size);
    const std::int32_t id = this->Table.FindOrAdd(hash, newId,
      [&](std::int32_t other)
      {
        return std::memcmp(
                 &this->Values[3 * static_cast<std::size_t>(other)], point, sizeof(point)) == 0;
      });
    if (id == newId)
    {
      this->Values.insert(this->Values.end(), point, point + 3);
    }
    return id;
  }

  const std::vector<Coordinate>& GetValues() const { return this->Values; }

private:
  std::vector<Coordinate> Values; ///< x y z
  IdTable Table;
};

} // namespace lambent::command

#endif
