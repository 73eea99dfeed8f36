// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief goes through the values behind the header of a PLY file
 */

#ifndef PlyCursor_h
#define PlyCursor_h

#include "PlyHeader.h"

#include <cstddef>

namespace lambent::command
{

class PlyCursor
{
public:
  /// The bytes from `begin` to `end`; a zero byte must follow them at `end`.
  PlyCursor(const char* begin, const char* end, PlyFormat format);

  /// Whether what is left can hold so many values of a type.
  bool CanHold(double count, PlyType type) const;

  /// The next value (every type of PLY fits a double). False if the file ends before it;
  /// throws Failure if the text has something else there.
  bool Next(PlyType type, double& value);

private:
  template <typename T>
  bool Take(double& value);
  bool TakeText(double& value);

  const char* At;
  const char* End;
  bool IsText;
  bool IsSwapped;
};

} // namespace lambent::command

#endif
