// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a whole file in memory
 */

#ifndef FileBytes_h
#define FileBytes_h

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace lambent::command
{

class FileBytes
{
public:
  /// Reads the file; throws Failure if it cannot be read to its end.
  explicit FileBytes(const std::string& path);

  /// A zero byte follows the last byte, so that a number at the end of a text file ends there.
  const char* begin() const { return this->Data.get(); }
  const char* end() const { return this->Data.get() + this->Size; }
  std::size_t size() const { return this->Size; }
  std::string_view view() const { return { this->Data.get(), this->Size }; }

private:
  std::unique_ptr<char[]> Data;
  std::size_t Size = 0;
};

} // namespace lambent::command

#endif
