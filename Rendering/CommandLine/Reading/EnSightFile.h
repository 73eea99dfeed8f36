// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a file of EnSight Gold, text or C binary, as lines and rows of numbers
 *
 * Numbers are stepped over rather than read, but for those that count others. In a text a row is
 * a line. In a binary file a line has 80 bytes and each number 4; the number of the first part
 * tells their order.
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

/// The file ends where something is due.
struct EndOfEnSightFile
{
};

/// Something that is left to VTK's reader.
struct EnSightNotUnderstood
{
};

enum class EnSightEncoding
{
  Text,
  Binary, ///< of C
  Other
};

/// As the first line of a geometry file says. The case's other files have the same, and do not say.
EnSightEncoding EncodingOfEnSight(const std::string& geometryPath);

std::vector<std::string> WordsOf(const std::string& line);

class EnSightFile
{
public:
  virtual ~EnSightFile() = default;

  /// Null if there is no such file.
  static std::unique_ptr<EnSightFile> Open(const std::string& path, EnSightEncoding encoding);

  /// True if nothing but blank lines follows.
  virtual bool IsAtEnd() = 0;

  // These throw EndOfEnSightFile or EnSightNotUnderstood.
  virtual std::string TakeDescription() = 0; ///< a line that may be blank
  virtual std::string TakeLine() = 0;        ///< without blanks at its ends
  virtual std::int64_t TakePartNumber() = 0; ///< or any other number that is small
  virtual std::vector<std::int64_t> TakeRow(int count) = 0;
  virtual void SkipRows(std::int64_t rows, std::int64_t numbersInRow) = 0;

  /// So many rows of numbers that count something: from 0 to 2^31 - 1, as the format has it.
  std::vector<std::int64_t> TakeCounts(std::int64_t rows, int numbersInRow);
  std::int64_t TakeCount() { return this->TakeCounts(1, 1)[0]; }
};

} // namespace lambent::command

#endif
