// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a read-only view of the caller's data at the points or cells of a surface
 */
#ifndef lambent_AttributeSpan_h
#define lambent_AttributeSpan_h

#include <cstddef>
#include <cstdint>

namespace lambent
{
enum class AttributeType : unsigned char
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float,
  Double
};

/// Contiguous tuples of so many components, one per point or one per cell.
struct AttributeSpan
{
  const void* data = nullptr; ///< or none
  AttributeType type = AttributeType::Float;
  int components = 1;
  bool isPerCell = false; ///< otherwise one tuple per point

  explicit operator bool() const { return this->data != nullptr; }

  /// A component of a tuple; integers beyond 2^53 are rounded.
  double at(std::size_t tuple, int component) const
  {
    const std::size_t k = tuple * static_cast<std::size_t>(this->components) + component;
    switch (this->type)
    {
      case AttributeType::Int8:
        return this->value<std::int8_t>(k);
      case AttributeType::UInt8:
        return this->value<std::uint8_t>(k);
      case AttributeType::Int16:
        return this->value<std::int16_t>(k);
      case AttributeType::UInt16:
        return this->value<std::uint16_t>(k);
      case AttributeType::Int32:
        return this->value<std::int32_t>(k);
      case AttributeType::UInt32:
        return this->value<std::uint32_t>(k);
      case AttributeType::Int64:
        return this->value<std::int64_t>(k);
      case AttributeType::UInt64:
        return this->value<std::uint64_t>(k);
      case AttributeType::Float:
        return this->value<float>(k);
      case AttributeType::Double:
        break;
    }
    return this->value<double>(k);
  }

private:
  template <typename Value>
  double value(std::size_t k) const
  {
    return static_cast<double>(static_cast<const Value*>(this->data)[k]);
  }
};
}

#endif
