// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FileBytes.h"
#include "Messages.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace lambent::command
{

FileBytes::FileBytes(const std::string& path)
{
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
    std::fopen(path.c_str(), "rb"), std::fclose);
  const long size = file && std::fseek(file.get(), 0, SEEK_END) == 0 ? std::ftell(file.get()) : -1;
  if (size < 0)
  {
    throw Failure(std::strerror(errno));
  }
  this->Size = static_cast<std::size_t>(size);
  this->Data.reset(new char[this->Size + 1]); // make_unique would first fill it with zeros
  std::rewind(file.get());
  if (std::fread(this->Data.get(), 1, this->Size, file.get()) != this->Size)
  {
    throw Failure("it cannot be read completely");
  }
  this->Data[this->Size] = '\0';
}

} // namespace lambent::command
