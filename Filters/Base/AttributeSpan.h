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

  /// Returns body(values), where the values have their own type.
  template <typename Body>
  auto visit(const Body& body) const
  {
    switch (this->type)
    {
      case AttributeType::Int8:
        return body(static_cast<const std::int8_t*>(this->data));
      case AttributeType::UInt8:
        return body(static_cast<const std::uint8_t*>(this->data));
      case AttributeType::Int16:
        return body(static_cast<const std::int16_t*>(this->data));
      case AttributeType::UInt16:
        return body(static_cast<const std::uint16_t*>(this->data));
      case AttributeType::Int32:
        return body(static_cast<const std::int32_t*>(this->data));
      case AttributeType::UInt32:
        return body(static_cast<const std::uint32_t*>(this->data));
      case AttributeType::Int64:
        return body(static_cast<const std::int64_t*>(this->data));
      case AttributeType::UInt64:
        return body(static_cast<const std::uint64_t*>(this->data));
      case AttributeType::Float:
        return body(static_cast<const float*>(this->data));
      case AttributeType::Double:
        break;
    }
    return body(static_cast<const double*>(this->data));
  }

  /// The address of a tuple, for prefetching.
  const void* address(std::size_t tuple) const
  {
    return this->visit([&](const auto* values) -> const void*
      { return values + tuple * static_cast<std::size_t>(this->components); });
  }

  /// A component of a tuple; integers beyond 2^53 are rounded.
  double at(std::size_t tuple, int component) const
  {
    const std::size_t k = tuple * static_cast<std::size_t>(this->components) + component;
    return this->visit([k](const auto* values) { return static_cast<double>(values[k]); });
  }
};
}

#endif
