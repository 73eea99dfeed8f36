// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief arrays of offsets and point ids, looked at as fast as memory allows
 *
 * Whether numbers are in a range is asked of many at once: the highest bits of
 * k and of n - 1 - k, without signs, are both 0 for 0 <= k < n alone. A sum of
 * bits needs no branch, and the compiler puts several numbers into a register.
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

/// Calls visit with the values of an array; false if it is of another type than those of cells.
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

/// Calls visit with the values of any array. Newer versions of VTK have some that are formulas.
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

/// Whether values[begin .. end] are not negative, and none is less than the one before.
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

/// Whether ids[begin .. end) are at least 0 and less than the count, which is not 0.
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
