// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckPng.h"
#include "Messages.h"

#include <array>
#include <cstdint>

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

} // namespace

void CheckPng(std::string_view bytes)
{
  if (bytes.substr(0, Signature.size()) != Signature)
  {
    throw Failure("it is not a PNG file");
  }
  bytes.remove_prefix(Signature.size());
  for (std::string_view type; type != "IEND";) // length, type, data, check sum
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

} // namespace lambent::command
