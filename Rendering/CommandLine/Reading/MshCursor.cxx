// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MshCursor.h"
#include "Messages.h"
#include "TextNumber.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <string_view>

namespace lambent::command
{
namespace
{

bool IsSpace(char c)
{
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

} // namespace

MshCursor::MshCursor(const FileBytes& file)
  : Begin(file.begin())
  , At(file.begin())
  , End(file.end())
{
}

void MshCursor::SetBinary(bool isSwapped)
{
  this->IsBinary = true;
  this->IsSwapped = isSwapped;
}

double MshCursor::Fraction() const
{
  return static_cast<double>(this->At - this->Begin) /
    static_cast<double>(this->End - this->Begin + 1);
}

void MshCursor::Fail(const std::string& what) const
{
  const std::string where = this->IsBinary
    ? "byte " + std::to_string(this->At - this->Begin)
    : "line " + std::to_string(1 + std::count(this->Begin, this->At, '\n'));
  throw Failure(
    where + ": " + what + "; check that the file is complete and has the right extension");
}

void MshCursor::SkipSpace()
{
  this->At = std::find_if_not(this->At, this->End, IsSpace);
}

void MshCursor::SkipLine()
{
  this->At = std::find(this->At, this->End, '\n');
  this->At += this->At != this->End;
}

std::string MshCursor::TakeSection()
{
  for (; this->At != this->End; this->SkipLine())
  {
    this->At = std::find_if(this->At, this->End, [](char c) { return c == '\n' || !IsSpace(c); });
    if (this->At != this->End && *this->At == '$')
    {
      const char* const begin = this->At + 1;
      const char* const end = std::find_if(begin, this->End, IsSpace);
      this->SkipLine();
      return { begin, end };
    }
  }
  return {};
}

void MshCursor::SkipSection(const std::string& name)
{
  const std::string end = "$End" + name;
  const std::string_view rest(this->At, static_cast<std::size_t>(this->End - this->At));
  const std::size_t at = rest.find(end);
  if (at == std::string_view::npos)
  {
    this->Fail("the section $" + name.substr(0, 40) + " has no end");
  }
  this->At += at + end.size();
  this->SkipLine();
}

void MshCursor::EndSection(const std::string& name)
{
  const std::string end = "$End" + name;
  this->SkipSpace();
  const std::string_view rest(this->At, static_cast<std::size_t>(this->End - this->At));
  if (rest.substr(0, end.size()) != end)
  {
    this->Fail("the section $" + name + " does not have the length that its counts declare");
  }
  this->SkipLine();
}

template <typename Value>
Value MshCursor::TakeBytes(const char* what)
{
  char bytes[sizeof(Value)];
  if (static_cast<std::size_t>(this->End - this->At) < sizeof(Value))
  {
    this->Fail("it ends within " + std::string(what));
  }
  std::memcpy(bytes, this->At, sizeof(Value));
  if (this->IsSwapped)
  {
    std::reverse(bytes, bytes + sizeof(Value));
  }
  Value value;
  std::memcpy(&value, bytes, sizeof(Value));
  this->At += sizeof(Value);
  return value;
}

template <typename Value, typename Read>
Value MshCursor::TakeText(const char* what, const Read& read)
{
  this->SkipSpace();
  Value value = 0;
  const char* const behind = read(this->At, value);
  if (behind == this->At || (behind != this->End && !IsSpace(*behind)))
  {
    this->Fail("there is no number where " + std::string(what) + " is expected");
  }
  this->At = behind;
  return value;
}

std::int64_t MshCursor::TakeTextInt(const char* what)
{
  return this->TakeText<std::int64_t>(what, ReadInteger);
}

double MshCursor::TakeTextNumber(const char* what)
{
  return this->TakeText<double>(
    what, [this](const char* at, double& value) { return ReadNumber(at, this->End, value); });
}

std::int64_t MshCursor::TakeInt(const char* what)
{
  return this->IsBinary ? this->TakeBytes<std::int32_t>(what) : this->TakeTextInt(what);
}

std::int64_t MshCursor::TakeSize(const char* what)
{
  return this->IsBinary ? this->TakeBytes<std::int64_t>(what) : this->TakeTextInt(what);
}

std::int64_t MshCursor::Sound(std::int64_t count, const char* what) const
{
  if (count < 0)
  {
    this->Fail(std::string(what) + " is negative");
  }
  return count;
}

std::int64_t MshCursor::TakeCount(const char* what)
{
  return this->Sound(this->TakeSize(what), what);
}

std::int64_t MshCursor::TakeLineCount(const char* what)
{
  const std::int64_t count = this->TakeTextInt(what);
  this->SkipLine();
  return this->Sound(count, what);
}

double MshCursor::TakeNumber(const char* what)
{
  return this->IsBinary ? this->TakeBytes<double>(what) : this->TakeTextNumber(what);
}

} // namespace lambent::command
