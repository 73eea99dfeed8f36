// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the words and numbers of an OFF file, and tracks the line
 */

#ifndef OffCursor_h
#define OffCursor_h

#include "FileBytes.h"

#include <cstddef>
#include <string>

namespace lambent::command
{

/// Lines end with LF, CR LF or CR, and '#' starts a comment. Every Failure thrown names the line.
class OffCursor
{
public:
  explicit OffCursor(const FileBytes& file);

  /// Skips space and comments. Returns false at the end.
  bool Skip();

  /// Moves to the end of the line.
  void SkipLine();

  /// Reads the letters that come next, in capitals, with any digits before them. Returns an empty
  /// string if a number comes next.
  std::string TakeWord();

  /// These read the next number; messages name what it belongs to by `owner` and `index`.
  double TakeNumber(const char* owner, long long index);
  long long TakeWhole(const char* owner, long long index);

  std::size_t GetRest() const { return static_cast<std::size_t>(this->End - this->At); }

  [[noreturn]] void Fail(const std::string& what) const;

private:
  const char* At;
  const char* End;
  long long Line = 1;
};

} // namespace lambent::command

#endif
