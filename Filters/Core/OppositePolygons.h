// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether two faces name the same points, the other way round
 *
 * Faces of few corners are compared at each rotation. Those of many could be periodic, so that
 * most rotations agree for long: they are compared at their least rotations, in a time that is
 * linear in the corners. Two such faces meet at each of their corners, so what was found of them
 * is remembered.
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
/// Where the rotation of a ring of ids starts that comes first in the order of words.
template <typename Iterator>
std::ptrdiff_t leastRotation(Iterator ring, std::ptrdiff_t size)
{
  std::ptrdiff_t first = 0, second = 1, same = 0; // two starts, and how long they agree
  const auto at = [&](std::ptrdiff_t i) { return ring[i < size ? i : i - size]; };
  while (first < size && second < size && same < size)
  {
    const auto a = at(first + same), b = at(second + same);
    if (a == b)
    {
      ++same;
      continue;
    }
    // No start within what agreed is less than the other one's.
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

  /// The place of a pair; another one may be there.
  Pair& recall(std::int64_t faceA, std::int64_t faceB)
  {
    this->Pairs.resize(pairCount);
    const auto mixed = 31 * static_cast<std::uint64_t>(faceA) + static_cast<std::uint64_t>(faceB);
    return this->Pairs[mixed % pairCount];
  }

  const Cells& AllCells;
  std::vector<Pair> Pairs; ///< of faces of many corners that were compared
};
}

#endif
