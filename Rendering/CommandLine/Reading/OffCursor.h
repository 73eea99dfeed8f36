// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief goes through the words and numbers of an OFF file, and knows the line
 */

#ifndef OffCursor_h
#define OffCursor_h

#include "FileBytes.h"

#include <cstddef>
#include <string>

namespace lambent::command
{

/// Lines end with LF, CR LF or CR; from '#' on they are comment. Throws Failure with the line.
class OffCursor
{
public:
  explicit OffCursor(const FileBytes& file);

  /// To the next that is neither space nor comment; false at the end.
  bool Skip();

  /// To the end of the line.
  void SkipLine();

  /// The letters that come next, in capitals, with a digit in front of them if there is one;
  /// empty if a number comes next.
  std::string TakeWord();

  /// The next number; `owner` and `index` say in a message what it is for.
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
