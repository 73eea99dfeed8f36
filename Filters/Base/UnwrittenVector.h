// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a std::vector whose new elements are not zeroed
 *
 * For large arrays that are filled by several threads: zeroing them first would take one thread as
 * long as all of them need to fill them.
 */
#ifndef lambent_UnwrittenVector_h
#define lambent_UnwrittenVector_h

#include "HugePages.h"

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace lambent
{
template <typename Value>
struct UnwrittenAllocator : std::allocator<Value>
{
  static_assert(std::is_trivially_default_constructible_v<Value>);
  template <typename Other>
  struct rebind
  {
    using other = UnwrittenAllocator<Other>;
  };

  Value* allocate(std::size_t count)
  {
    Value* const values = std::allocator<Value>::allocate(count);
    useHugePages(values, count * sizeof(Value));
    return values;
  }

  /// Leaves the element as it is.
  template <typename Other>
  void construct(Other* element)
  {
    ::new (static_cast<void*>(element)) Other;
  }
  template <typename Other, typename... Arguments>
  void construct(Other* element, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(element)) Other(std::forward<Arguments>(arguments)...);
  }
};

template <typename Value>
using UnwrittenVector = std::vector<Value, UnwrittenAllocator<Value>>;
}

#endif
