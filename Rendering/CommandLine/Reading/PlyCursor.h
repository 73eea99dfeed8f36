// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * @brief goes through the values behind the header of a PLY file
 *
 * In text an element has a line of its own. Numbers left over on a line are passed
 * over and counted. An element may go on in the next line, too.
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

  /// Whether what is left can hold so many values of a type.
  bool CanHold(double count, PlyType type) const;

  /// The next value (every type of PLY fits a double). False if the file ends before it;
  /// throws Failure if the text has something else there.
  bool Next(PlyType type, double& value);

  /// An item of an element has all its values: goes to the end of the line if it is text.
  void EndItem();

  /// How many numbers have been passed over, and the first line in which there were any.
  std::size_t GetLeftOver() const { return this->LeftOver; }
  std::size_t GetFirstLineWithMore() const { return this->FirstLineWithMore; }
  /// How many bytes are left, but for blanks.
  std::size_t BytesBehind();

private:
  template <typename T>
  bool Take(double& value);
  bool TakeText(double& value);

  TextCursor Text; ///< goes through a text
  const char* At;  ///< goes through a binary file
  const char* End;
  bool IsText;
  bool IsSwapped;
  std::size_t LeftOver = 0;
  std::size_t FirstLineWithMore = 0;
};

} // namespace lambent::command

#endif
