// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlyCursor.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace lambent::command
{
namespace
{

bool IsHostLittleEndian()
{
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

} // namespace

PlyCursor::PlyCursor(std::string_view file, const PlyHeader& header)
  : Text(file.substr(header.bodyOffset), header.lines + 1)
  , At(file.data() + header.bodyOffset)
  , End(file.data() + file.size())
  , IsText(header.format == PlyFormat::Text)
  , IsSwapped(!IsText && IsHostLittleEndian() != (header.format == PlyFormat::LittleEndian))
{
}

bool PlyCursor::CanHold(double count, PlyType type) const
{
  // In text every value takes a digit and a space, except the last, which needs no space.
  const double bytes = this->IsText ? 2.0 : static_cast<double>(PlySize(type));
  const char* const at = this->IsText ? this->Text.Position() : this->At;
  return count >= 0 && count * bytes <= static_cast<double>(this->End - at + 1);
}

bool PlyCursor::Next(PlyType type, double& value)
{
  if (this->IsText)
  {
    return this->TakeText(value);
  }
  switch (type)
  {
    case PlyType::Int8:
      return this->Take<std::int8_t>(value);
    case PlyType::UInt8:
      return this->Take<std::uint8_t>(value);
    case PlyType::Int16:
      return this->Take<std::int16_t>(value);
    case PlyType::UInt16:
      return this->Take<std::uint16_t>(value);
    case PlyType::Int32:
      return this->Take<std::int32_t>(value);
    case PlyType::UInt32:
      return this->Take<std::uint32_t>(value);
    case PlyType::Float32:
      return this->Take<float>(value);
    case PlyType::Float64:
      break;
  }
  return this->Take<double>(value);
}

template <typename T>
bool PlyCursor::Take(double& value)
{
  if (this->End - this->At < static_cast<std::ptrdiff_t>(sizeof(T)))
  {
    return false;
  }
  T stored;
  std::memcpy(&stored, this->At, sizeof(T));
  if (this->IsSwapped)
  {
    char bytes[sizeof(T)];
    std::reverse_copy(this->At, this->At + sizeof(T), bytes);
    std::memcpy(&stored, bytes, sizeof(T));
  }
  this->At += sizeof(T);
  value = static_cast<double>(stored);
  return true;
}

bool PlyCursor::TakeText(double& value)
{
  this->Text.SkipSpace();
  if (this->Text.IsAtEnd())
  {
    return false;
  }
  value = this->Text.TakeNumber();
  return true;
}

void PlyCursor::EndItem()
{
  if (!this->IsText)
  {
    return;
  }
  this->Text.SkipBlanks();
  while (!this->Text.TakeWord().empty())
  {
    if (this->LeftOver++ == 0)
    {
      this->FirstLineWithMore = this->Text.Line();
    }
    this->Text.SkipBlanks();
  }
}

std::size_t PlyCursor::BytesBehind()
{
  if (this->IsText)
  {
    this->Text.SkipSpace();
    return static_cast<std::size_t>(this->End - this->Text.Position());
  }
  const bool isBlank = std::all_of(
    this->At, this->End, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
  return isBlank ? 0 : static_cast<std::size_t>(this->End - this->At);
}

} // namespace lambent::command
