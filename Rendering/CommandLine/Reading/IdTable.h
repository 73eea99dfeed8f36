// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a hash table of ids whose keys are stored by the caller
 *
 * Open addressing with linear probing, at most half full. A slot holds an id and its hash. The
 * caller compares the keys, so they are not stored twice.
 */

#ifndef IdTable_h
#define IdTable_h

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace lambent::command
{

/// Lets every bit affect every other bit (the finaliser of MurmurHash3, by A. Appleby).
inline std::uint64_t MixBits(std::uint64_t bits)
{
  bits = (bits ^ (bits >> 33)) * 0xff51afd7ed558ccdULL;
  bits = (bits ^ (bits >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return bits ^ (bits >> 33);
}

class IdTable
{
public:
  IdTable()
    : Slots(64, Slot{ 0, None })
  {
  }

  /// The id with that hash for which isSame(id) is true. If there is none, adds and returns newId.
  template <typename IsSame>
  std::int32_t FindOrAdd(std::uint64_t hash, std::int32_t newId, IsSame&& isSame)
  {
    const std::uint32_t shortHash = static_cast<std::uint32_t>(hash);
    std::size_t at = shortHash & (this->Slots.size() - 1);
    for (; this->Slots[at].id != None; at = (at + 1) & (this->Slots.size() - 1))
    {
      if (this->Slots[at].hash == shortHash && isSame(this->Slots[at].id))
      {
        return this->Slots[at].id;
      }
    }
    this->Slots[at] = { shortHash, newId };
    if (++this->Used > this->Slots.size() / 2)
    {
      this->Grow();
    }
    return newId;
  }

private:
  static constexpr std::int32_t None = -1;

  struct Slot
  {
    std::uint32_t hash;
    std::int32_t id;
  };

  void Grow()
  {
    const std::vector<Slot> old =
      std::exchange(this->Slots, std::vector<Slot>(2 * this->Slots.size(), Slot{ 0, None }));
    for (const Slot& slot : old)
    {
      std::size_t at = slot.hash & (this->Slots.size() - 1);
      while (slot.id != None && this->Slots[at].id != None)
      {
        at = (at + 1) & (this->Slots.size() - 1);
      }
      if (slot.id != None)
      {
        this->Slots[at] = slot;
      }
    }
  }

  std::vector<Slot> Slots;
  std::size_t Used = 0;
};

} // namespace lambent::command

#endif
