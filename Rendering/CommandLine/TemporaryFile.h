// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a file that appears under its name complete or not at all
 */

#ifndef TemporaryFile_h
#define TemporaryFile_h

#include <cstddef>
#include <string>

namespace lambent::command
{

/**
 * It is created in the target's folder, because renaming is atomic only within one file system.
 * Unless Commit() succeeds, it is removed by the destructor, or when SIGINT, SIGTERM or SIGHUP ends
 * the process. Only one may exist at a time.
 */
class TemporaryFile
{
public:
  /// Creates an empty file. Throws Failure if that is impossible: no such folder, no permission.
  explicit TemporaryFile(const std::string& target);
  /// Creates an empty file with a new name and the given extension, which is never committed.
  TemporaryFile(const std::string& folder, const std::string& extension);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& GetPath() const { return this->Path; }

  /// Writes the whole content. Throws Failure, for instance if the disk is full.
  void Write(const void* bytes, std::size_t size);

  /// Renames the file to its target, replacing any existing file.
  void Commit();

private:
  std::string Target;
  std::string Path;
};

} // namespace lambent::command

#endif
