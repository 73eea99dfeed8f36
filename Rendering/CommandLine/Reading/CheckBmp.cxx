// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckBmp.h"
#include "FileBytes.h"
#include "Messages.h"

#include <cstdint>
#include <cstdlib>

namespace lambent::command
{
namespace
{

const char* const Remedy = "; convert it to .png";

/// Reads a little-endian number of `size` bytes at an offset.
std::uint32_t NumberAt(const FileBytes& bytes, std::size_t place, std::size_t size)
{
  if (bytes.size() < place + size)
  {
    throw Failure("it is incomplete; use a complete copy");
  }
  std::uint32_t number = 0;
  for (std::size_t k = size; k-- > 0;)
  {
    number = number << 8 | static_cast<unsigned char>(bytes.begin()[place + k]);
  }
  return number;
}

} // namespace

void CheckBmp(const std::string& path)
{
  const FileBytes bytes(path);
  const auto number = [&bytes](std::size_t place, std::size_t size)
  { return NumberAt(bytes, place, size); };
  if (bytes.view().substr(0, 2) != "BM" || number(14, 4) != 40)
  {
    throw Failure(
      "it is not a BMP file, or of a version that VTK does not read" + std::string(Remedy));
  }
  const std::uint32_t bits = number(28, 2);
  if ((bits != 8 && bits != 24) || number(30, 4) != 0)
  {
    throw Failure("VTK's reader cannot read a BMP " +
      (number(30, 4) != 0 ? "with compression"
                          : "of " + std::to_string(bits) + " bits per pixel (only 8 and 24)") +
      Remedy);
  }
  const std::int64_t width = static_cast<std::int32_t>(number(18, 4)),
                     height = std::llabs(static_cast<std::int32_t>(number(22, 4)));
  const std::int64_t row = (width * (bits / 8) + 3) / 4 * 4;
  if (width < 1 || height < 1 ||
    row * height > static_cast<std::int64_t>(bytes.size()) - number(10, 4))
  {
    throw Failure("it is incomplete; use a complete copy");
  }
}

} // namespace lambent::command
