// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlyCursor.h"
#include "Messages.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
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

PlyCursor::PlyCursor(const char* begin, const char* end, PlyFormat format)
  : At(begin)
  , End(end)
  , IsText(format == PlyFormat::Text)
  , IsSwapped(!IsText && IsHostLittleEndian() != (format == PlyFormat::LittleEndian))
{
}

bool PlyCursor::CanHold(double count, PlyType type) const
{
  // In text a value takes a digit and, but for the last one, a space.
  const double bytes = this->IsText ? 2.0 : static_cast<double>(PlySize(type));
  return count >= 0 && count * bytes <= static_cast<double>(this->End - this->At + 1);
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
  char* end = nullptr;
  value = std::strtod(this->At, &end);
  if (end != this->At)
  {
    this->At = end;
    return true;
  }
  if (this->At + std::strspn(this->At, " \t\r\n") < this->End)
  {
    throw Failure("it has something else where a number is due");
  }
  return false;
}

} // namespace lambent::command
