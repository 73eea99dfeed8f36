// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief make the bytes of a fuzz target available as a file that readers can open
 */
#ifndef NamelessFile_h
#define NamelessFile_h

#include "FuzzInput.h"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

/// A temporary file without a name, deleted when it is closed.
class NamelessFile
{
public:
  NamelessFile(const std::uint8_t* data, std::size_t size)
  {
    require(this->File && std::fwrite(data, 1, size, this->File.get()) == size &&
        std::fflush(this->File.get()) == 0,
      "a temporary file can be written");
  }

  std::string path() const { return "/dev/fd/" + std::to_string(fileno(this->File.get())); }

private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> File{ std::tmpfile(), std::fclose };
};

#endif
