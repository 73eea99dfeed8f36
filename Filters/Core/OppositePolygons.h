// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether two faces have the same points in reverse order
 *
 * Faces with few corners are compared at each rotation. In faces with many corners, ids could be
 * periodic, and most rotations would match for a long stretch. These faces are therefore compared
 * at their least rotations, in linear time. Two such faces meet at each of their corners, so the
 * results are cached.
 *
 * Y. Shiloach, "Fast canonization of circular strings", Journal of Algorithms 2(2), 1981.
 */
#ifndef lambent_OppositePolygons_h
#define lambent_OppositePolygons_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace lambent
{
/// The start of the lexicographically least rotation of a ring of ids.
template <typename Iterator>
std::ptrdiff_t leastRotation(Iterator ring, std::ptrdiff_t size)
{
  std::ptrdiff_t first = 0, second = 1, same = 0; // two starts, and how far they match
  const auto at = [&](std::ptrdiff_t i) { return ring[i < size ? i : i - size]; };
  while (first < size && second < size && same < size)
  {
    const auto a = at(first + same), b = at(second + same);
    if (a == b)
    {
      ++same;
      continue;
    }
    // No start within the matched part of the greater rotation can be the least.
    (b < a ? first : second) += same + 1;
    second += first == second;
    same = 0;
  }
  return std::min(first, second);
}

template <typename Cells>
class OppositePolygons
{
public:
  explicit OppositePolygons(const Cells& cells)
    : AllCells(cells)
  {
  }

  bool areOpposite(std::int64_t faceA, std::int64_t faceB)
  {
    const std::size_t size = this->AllCells.cellSize(faceA);
    if (this->AllCells.cellSize(faceB) != size)
    {
      return false;
    }
    const auto* const a = this->AllCells.cell(faceA);
    const auto* const b = this->AllCells.cell(faceB);
    if (size <= mostTried)
    {
      return hasOppositeRotation(a, b, static_cast<std::ptrdiff_t>(size));
    }
    Pair& pair = this->recall(faceA, faceB);
    if (pair.a != faceA || pair.b != faceB)
    {
      pair = { faceA, faceB, isSameRing(a, b, static_cast<std::ptrdiff_t>(size)) };
    }
    return pair.areOpposite;
  }

private:
  static constexpr std::size_t mostTried = 16;
  static constexpr std::size_t pairCount = 1024;

  struct Pair
  {
    std::int64_t a = -1, b = -1;
    bool areOpposite = false;
  };

  template <typename Id>
  static bool hasOppositeRotation(const Id* a, const Id* b, std::ptrdiff_t size)
  {
    for (std::ptrdiff_t first = 0; first < size; ++first)
    {
      const std::reverse_iterator rotated(b + first), end(b);
      if (a[0] == b[first > 0 ? first - 1 : size - 1] && std::equal(rotated, end, a) &&
        std::equal(std::reverse_iterator(b + size), rotated, a + first))
      {
        return true;
      }
    }
    return false;
  }

  template <typename Id>
  static bool isSameRing(const Id* a, const Id* b, std::ptrdiff_t size)
  {
    const std::reverse_iterator reversed(b + size);
    const std::ptrdiff_t firstA = leastRotation(a, size), firstB = leastRotation(reversed, size);
    for (std::ptrdiff_t k = 0; k < size; ++k)
    {
      if (a[(firstA + k) % size] != reversed[(firstB + k) % size])
      {
        return false;
      }
    }
    return true;
  }

  /// The cache entry for a pair; it may hold another pair.
  Pair& recall(std::int64_t faceA, std::int64_t faceB)
  {
    this->Pairs.resize(pairCount);
    const auto mixed = 31 * static_cast<std::uint64_t>(faceA) + static_cast<std::uint64_t>(faceB);
    return this->Pairs[mixed % pairCount];
  }

  const Cells& AllCells;
  std::vector<Pair> Pairs; ///< a cache of compared faces with many corners
};
}

#endif
