// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief goes through the sections and numbers of a file of Gmsh, text or binary
 *
 * Every number is taken behind a check that the file has it, so that a count need
 * not be believed: what it promises is taken one by one.
 */

#ifndef MshCursor_h
#define MshCursor_h

#include "FileBytes.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace lambent::command
{

/// Throws Failure with the line, or in binary files the byte.
class MshCursor
{
public:
  explicit MshCursor(const FileBytes& file);

  void SetBinary(bool isSwapped);
  bool GetBinary() const { return this->IsBinary; }

  /// Goes behind the next line that begins with '$'. Returns the rest of it; empty at the end.
  std::string TakeSection();
  /// Goes behind the end of the section, wherever it is.
  void SkipSection(const std::string& name);
  /// Goes behind the end of the section, which comes next.
  void EndSection(const std::string& name);

  /// The next number, which a message calls `what`. In binary files whole numbers are of 32 bits
  /// (TakeInt) or of 64 (TakeSize).
  std::int64_t TakeInt(const char* what);
  std::int64_t TakeSize(const char* what);
  double TakeNumber(const char* what);
  /// TakeSize() that is not negative.
  std::int64_t TakeCount(const char* what);

  /// The same in text, whatever the file is; and to the end of the line.
  std::int64_t TakeTextInt(const char* what);
  double TakeTextNumber(const char* what);
  /// TakeTextInt() that is not negative, and the rest of its line.
  std::int64_t TakeLineCount(const char* what);
  void SkipLine();

  double Fraction() const;
  [[noreturn]] void Fail(const std::string& what) const;

private:
  void SkipSpace();
  std::int64_t Sound(std::int64_t count, const char* what) const;
  template <typename Value>
  Value TakeBytes(const char* what);
  template <typename Value, typename Read>
  Value TakeText(const char* what, const Read& read);

  const char* Begin;
  const char* At;
  const char* End;
  bool IsBinary = false;
  bool IsSwapped = false;
};

} // namespace lambent::command

#endif
