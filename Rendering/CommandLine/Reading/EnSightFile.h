// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief an EnSight Gold file, in text or C binary, as lines and rows of numbers
 *
 * Only counts are read; all other numbers are skipped. In a text file a row is a line. In a binary
 * file a line has 80 bytes and a number 4; the part numbers reveal the byte order.
 */

#ifndef EnSightFile_h
#define EnSightFile_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace lambent::command
{

/// Thrown if the file ends too early.
struct EndOfEnSightFile
{
};

/// Thrown at unknown content, which is left to VTK's reader.
struct EnSightNotUnderstood
{
};

enum class EnSightEncoding
{
  Text,
  Binary, ///< C binary
  Other
};

/// From the first line of a geometry file. The case's other files have the same encoding but do not
/// declare it.
EnSightEncoding EncodingOfEnSight(const std::string& geometryPath);

std::vector<std::string> WordsOf(const std::string& line);

class EnSightFile
{
public:
  virtual ~EnSightFile() = default;

  /// Returns null if the file cannot be opened.
  static std::unique_ptr<EnSightFile> Open(const std::string& path, EnSightEncoding encoding);

  /// True if nothing but blank lines follows.
  virtual bool IsAtEnd() = 0;

  // These throw EndOfEnSightFile or EnSightNotUnderstood.
  virtual std::string TakeDescription() = 0; ///< a line that may be blank
  virtual std::string TakeLine() = 0;        ///< without blanks at its ends
  virtual std::int64_t TakePartNumber() = 0; ///< also sets the byte order; the number must be small
  virtual std::vector<std::int64_t> TakeRow(int count) = 0;
  virtual void SkipRows(std::int64_t rows, std::int64_t numbersInRow) = 0;

  /// Rows of counts from 0 to 2^31 - 1, the range of the format.
  std::vector<std::int64_t> TakeCounts(std::int64_t rows, int numbersInRow);
  std::int64_t TakeCount() { return this->TakeCounts(1, 1)[0]; }
};

} // namespace lambent::command

#endif
