// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the sections and numbers of a Gmsh file, text or binary
 *
 * The cursor checks that the file holds each number before reading it. Counts are never trusted,
 * because items are read one by one.
 */

#ifndef MshCursor_h
#define MshCursor_h

#include "FileBytes.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace lambent::command
{

/// Every Failure thrown names the line or, in binary files, the byte.
class MshCursor
{
public:
  explicit MshCursor(const FileBytes& file);

  void SetBinary(bool isSwapped);
  bool GetBinary() const { return this->IsBinary; }

  /// Moves past the next line that begins with '$'. Returns the word after the '$'; empty at the
  /// end of the file.
  std::string TakeSection();
  /// Moves past the end of the section, wherever it is.
  void SkipSection(const std::string& name);
  /// Moves past the end of the section, which must come next.
  void EndSection(const std::string& name);

  /// These read the next number; messages call it `what`. In binary files TakeInt() reads 32 bits
  /// and TakeSize() 64.
  std::int64_t TakeInt(const char* what);
  std::int64_t TakeSize(const char* what);
  double TakeNumber(const char* what);
  /// Like TakeSize(), but fails if the number is negative.
  std::int64_t TakeCount(const char* what);

  /// These read text, even in binary files.
  std::int64_t TakeTextInt(const char* what);
  double TakeTextNumber(const char* what);
  /// Like TakeTextInt(), but fails if the number is negative, and skips the rest of the line.
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
