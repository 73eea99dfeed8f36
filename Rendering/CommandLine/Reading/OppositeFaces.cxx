// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OppositeFaces.h"
#include "IdTable.h"

#include <algorithm>

namespace lambent::command
{
namespace
{

/// The points of a face, starting at the smallest id, in the direction of its smaller neighbour.
/// Faces with opposite orientations have the same ring.
class Ring
{
public:
  Ring(const CellLists& faces, std::size_t face)
    : Points(faces.points.data() + faces.offsets[face])
    , Size(static_cast<std::size_t>(faces.offsets[face + 1] - faces.offsets[face]))
  {
    this->First = static_cast<std::size_t>(
      std::min_element(this->Points, this->Points + this->Size) - this->Points);
    const std::int32_t next = this->Points[(this->First + 1) % this->Size];
    const std::int32_t previous = this->Points[(this->First + this->Size - 1) % this->Size];
    this->Reversed = previous < next;
  }

  bool IsReversed() const { return this->Reversed; }

  std::int32_t operator[](std::size_t k) const
  {
    return this
      ->Points[(this->Reversed ? this->First + this->Size - k : this->First + k) % this->Size];
  }

  bool operator==(const Ring& other) const
  {
    bool isSame = this->Size == other.Size;
    for (std::size_t k = 0; k < this->Size && isSame; ++k)
    {
      isSame = (*this)[k] == other[k];
    }
    return isSame;
  }

  std::uint64_t Hash() const
  {
    std::uint64_t bits = this->Size;
    for (std::size_t k = 0; k < this->Size; ++k)
    {
      bits = MixBits(bits ^ static_cast<std::uint32_t>((*this)[k]));
    }
    return bits;
  }

private:
  const std::int32_t* Points;
  std::size_t Size;
  std::size_t First;
  bool Reversed;
};

} // namespace

std::vector<bool> FindOppositeFaces(const CellLists& faces)
{
  std::vector<bool> isOpposite(faces.size());
  IdTable table;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    const Ring ring(faces, face);
    const std::int32_t first = table.FindOrAdd(ring.Hash(), static_cast<std::int32_t>(face),
      [&](std::int32_t other) { return Ring(faces, static_cast<std::size_t>(other)) == ring; });
    isOpposite[face] =
      Ring(faces, static_cast<std::size_t>(first)).IsReversed() != ring.IsReversed();
  }
  return isOpposite;
}

} // namespace lambent::command
