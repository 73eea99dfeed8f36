// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckFile.h"
#include "Messages.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace lambent::command
{

void CheckFile(const std::string& path, bool mayBeEmpty)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    throw Failure("there is no such file; check its name");
  }
  if (std::filesystem::is_directory(status))
  {
    throw Failure("it is a folder; name a file in it");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw Failure("it is not a regular file; copy it to one");
  }
  errno = 0;
  if (!std::ifstream(path, std::ios::binary))
  {
    throw Failure(std::string(std::strerror(errno)) + "; check its permissions");
  }
  if (!mayBeEmpty && std::filesystem::file_size(path, error) == 0)
  {
    throw Failure("it is empty; use a complete copy");
  }
}

} // namespace lambent::command
