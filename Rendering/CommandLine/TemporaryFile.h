// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a file that appears under its name whole or not at all
 */

#ifndef TemporaryFile_h
#define TemporaryFile_h

#include <cstddef>
#include <string>

namespace lambent::command
{

/**
 * Stands beside the file that it will become, since only within one file system
 * is renaming one step. Unless Commit() succeeds, it is removed: by the
 * destructor, and when SIGINT, SIGTERM or SIGHUP end the process. One at a time.
 */
class TemporaryFile
{
public:
  /// Makes the file, empty. Throws Failure if that cannot be: no such folder, no permission.
  explicit TemporaryFile(const std::string& target);
  /// Makes an empty file in a folder that never becomes another: its name is new, its end given.
  TemporaryFile(const std::string& folder, const std::string& extension);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& GetPath() const { return this->Path; }

  /// Writes the whole content. Throws Failure, for instance if the disk is full.
  void Write(const void* bytes, std::size_t size);

  /// Gives the file its name; what had the name before is replaced.
  void Commit();

private:
  std::string Target;
  std::string Path;
};

} // namespace lambent::command

#endif
