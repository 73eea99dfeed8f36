// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief checks arrays of offsets and point ids at memory speed
 *
 * Ranges are checked for many numbers at once: the highest bits of k and n - 1 - k, as unsigned
 * numbers, are both 0 if and only if 0 <= k < n. Combining them by OR needs no branch, and the
 * compiler vectorises the loop.
 */

#ifndef IdArrays_h
#define IdArrays_h

#include "vtkAOSDataArrayTemplate.h"
#include "vtkNew.h"
#include "vtkType.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace lambent::command
{

/// Calls visit with the values of an array. Returns false if it is not of a type used for cells.
template <typename Visit>
bool VisitPlain(vtkDataArray* array, const Visit& visit)
{
  if (auto* const plain = vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(array))
  {
    visit(plain->GetPointer(0));
    return true;
  }
  if (auto* const plain = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(array))
  {
    visit(plain->GetPointer(0));
    return true;
  }
  return false;
}

/// Calls visit with the values of any array. Newer versions of VTK have implicit arrays.
template <typename Visit>
void VisitValues(vtkDataArray* array, const Visit& visit)
{
  if (!VisitPlain(array, visit))
  {
    vtkNew<vtkTypeInt64Array> copy;
    copy->DeepCopy(array);
    visit(copy->GetPointer(0));
  }
}

/// Whether values[begin .. end] are not negative and do not decrease.
template <typename Value>
bool DoIncrease(const Value* values, vtkIdType begin, vtkIdType end)
{
  using Bits = std::make_unsigned_t<Value>;
  Bits wrong = 0;
  for (vtkIdType k = begin; k < end; ++k)
  {
    wrong |= static_cast<Bits>(values[k]) |
      (static_cast<Bits>(values[k + 1]) - static_cast<Bits>(values[k]));
  }
  return static_cast<Value>(wrong) >= 0;
}

/// Whether ids[begin .. end) are in [0, count), where count > 0.
template <typename Value>
bool AreIdsBelow(vtkIdType count, const Value* ids, vtkIdType begin, vtkIdType end)
{
  using Bits = std::make_unsigned_t<Value>;
  const auto largest =
    static_cast<Bits>(std::min<vtkIdType>(count - 1, std::numeric_limits<Value>::max()));
  Bits wrong = 0;
  for (vtkIdType k = begin; k < end; ++k)
  {
    wrong |= static_cast<Bits>(ids[k]) | (largest - static_cast<Bits>(ids[k]));
  }
  return static_cast<Value>(wrong) >= 0;
}

} // namespace lambent::command

#endif
