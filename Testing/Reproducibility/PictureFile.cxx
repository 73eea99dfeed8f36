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

/// Appends values, the least significant byte first.
template <typename Bits, typename Value>
void append(const std::vector<Value>& values, std::string& content)
{
  static_assert(sizeof(Bits) == sizeof(Value));
  for (const Value value : values)
  {
    Bits bits;
    std::memcpy(&bits, &value, sizeof(bits));
    for (std::size_t shift = 0; shift < 8 * sizeof(bits); shift += 8)
    {
      content.push_back(static_cast<char>(bits >> shift & 0xFFu));
    }
  }
}

/// PFM. The scale of -1 declares little-endian numbers.
std::string pfm(const Picture& picture)
{
  std::string content = (picture.channels == 4 ? "PF4\n" : "PF\n") + sizeOf(picture) + "\n-1.0\n";
  append<std::uint32_t>(picture.floats, content);
  return content;
}

std::string passes(const Picture& picture)
{
  std::string content;
  for (const PassPicture& pass : picture.passes)
  {
    content += pass.name + " " + sizeOf(picture) + " " + std::to_string(pass.form.components) +
      (pass.form.isDouble ? " double\n" : " float\n");
    append<std::uint32_t>(pass.floats, content);
    append<std::uint64_t>(pass.doubles, content);
  }
  return content;
}

/// PPM, or PAM with alpha. These formats store the top row first.
std::string bytes(const Picture& picture)
{
  std::string content = picture.channels == 4
    ? "P7\nWIDTH " + std::to_string(picture.width) + "\nHEIGHT " + std::to_string(picture.height) +
      "\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n"
    : "P6\n" + sizeOf(picture) + "\n255\n";
  const std::size_t row = static_cast<std::size_t>(picture.channels) * picture.width;
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
  write(directory + "/" + name + (picture.channels == 4 ? ".pam" : ".ppm"), bytes(picture));
  if (!picture.passes.empty())
  {
    write(directory + "/" + name + ".passes", passes(picture));
  }
}
