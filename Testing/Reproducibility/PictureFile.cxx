// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace
{
void write(const std::string& path, const std::string& content)
{
  std::ofstream file(path, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file)
  {
    throw std::runtime_error("cannot write " + path + ". Is there such a folder, and room?");
  }
}

std::string sizeOf(const Picture& picture)
{
  return std::to_string(picture.width) + " " + std::to_string(picture.height);
}

/// The least significant byte first; the scale of -1 declares this byte order.
std::string pfm(const Picture& picture)
{
  std::string content = "PF\n" + sizeOf(picture) + "\n-1.0\n";
  for (float channel : picture.floats)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &channel, sizeof(bits));
    for (int shift = 0; shift < 32; shift += 8)
    {
      content.push_back(static_cast<char>(bits >> shift & 0xFFu));
    }
  }
  return content;
}

/// This format has the top row first.
std::string ppm(const Picture& picture)
{
  std::string content = "P6\n" + sizeOf(picture) + "\n255\n";
  const std::size_t row = 3u * picture.width;
  for (std::size_t j = picture.height; j-- > 0;)
  {
    content.append(reinterpret_cast<const char*>(&picture.bytes[j * row]), row);
  }
  return content;
}
}

void writePicture(const Picture& picture, const std::string& directory, const std::string& name)
{
  write(directory + "/" + name + ".pfm", pfm(picture));
  write(directory + "/" + name + ".ppm", ppm(picture));
}
