// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * @brief reads the values after the header of a PLY file
 *
 * In text files each item of an element starts a new line and may continue on the next. Excess
 * numbers on a line are skipped and counted.
 */

#ifndef PlyCursor_h
#define PlyCursor_h

#include "PlyHeader.h"
#include "TextCursor.h"

#include <cstddef>
#include <string_view>

namespace lambent::command
{

class PlyCursor
{
public:
  /// A zero byte must follow the file.
  PlyCursor(std::string_view file, const PlyHeader& header);

  /// Whether the rest of the file can hold this many values of the type.
  bool CanHold(double count, PlyType type) const;

  /// Reads the next value (every PLY type fits a double). Returns false if the file ends before it;
  /// throws Failure if a text file has no number there.
  bool Next(PlyType type, double& value);

  /// Call after the last value of an item. In text files, moves to the end of the line.
  void EndItem();

  /// The number of skipped words, and the first line that had any.
  std::size_t GetLeftOver() const { return this->LeftOver; }
  std::size_t GetFirstLineWithMore() const { return this->FirstLineWithMore; }
  /// The number of bytes left; 0 if they are all blanks.
  std::size_t BytesBehind();

private:
  template <typename T>
  bool Take(double& value);
  bool TakeText(double& value);

  TextCursor Text; ///< the position in a text file
  const char* At;  ///< the position in a binary file
  const char* End;
  bool IsText;
  bool IsSwapped;
  std::size_t LeftOver = 0;
  std::size_t FirstLineWithMore = 0;
};

} // namespace lambent::command

#endif
