// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckPng.h"
#include "Messages.h"

#include "vtk_png.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace lambent::command
{
namespace
{

using namespace std::string_view_literals;

constexpr std::string_view Signature = "\x89PNG\r\n\x1a\n"sv;

constexpr std::array<std::uint32_t, 256> MakeTable()
{
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n)
  {
    table[n] = n;
    for (int bit = 0; bit < 8; ++bit)
    {
      table[n] = (table[n] & 1 ? 0xEDB88320u : 0u) ^ (table[n] >> 1);
    }
  }
  return table;
}

/// The check sum CRC-32 of ISO 3309.
std::uint32_t CheckSum(std::string_view bytes)
{
  static constexpr auto table = MakeTable();
  std::uint32_t sum = 0xFFFFFFFFu;
  for (const char byte : bytes)
  {
    sum = table[(sum ^ static_cast<unsigned char>(byte)) & 0xFF] ^ (sum >> 8);
  }
  return ~sum;
}

std::uint32_t BigEndian(std::string_view bytes)
{
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4))
  {
    value = value << 8 | static_cast<unsigned char>(byte);
  }
  return value;
}

/// Whether the chunks are whole: length, type, data, check sum each.
void CheckChunks(std::string_view bytes)
{
  for (std::string_view type; type != "IEND";)
  {
    if (bytes.size() < 12 || BigEndian(bytes) > bytes.size() - 12)
    {
      throw Failure("the file is cut short");
    }
    const std::size_t length = BigEndian(bytes);
    if (CheckSum(bytes.substr(4, 4 + length)) != BigEndian(bytes.substr(8 + length)))
    {
      throw Failure("the file is damaged: a check sum is wrong");
    }
    type = bytes.substr(4, 4);
    bytes.remove_prefix(12 + length);
  }
}

/// Whether pixels come out.
void CheckPixels(std::string_view bytes)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> end(&image, png_image_free);
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()))
  {
    image.format = PNG_FORMAT_RGBA;
    const std::size_t size = std::size_t(PNG_IMAGE_ROW_STRIDE(image)) * image.height;
    const std::unique_ptr<char[]> pixels(new char[size]);
    if (png_image_finish_read(&image, nullptr, pixels.get(), 0, nullptr))
    {
      return;
    }
  }
  throw Failure("the file is damaged: " + std::string(image.message));
}

} // namespace

void CheckPng(std::string_view bytes)
{
  if (bytes.substr(0, Signature.size()) != Signature)
  {
    throw Failure("it is not a PNG file");
  }
  CheckChunks(bytes.substr(Signature.size()));
  CheckPixels(bytes);
}

} // namespace lambent::command
