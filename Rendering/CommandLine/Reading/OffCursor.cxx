// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OffCursor.h"
#include "Messages.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace lambent::command
{
namespace
{

bool IsSpace(char c)
{
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool IsLetter(char c)
{
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

std::string NameOf(const char* owner, long long index)
{
  return index < 0 ? owner : owner + std::string(" ") + std::to_string(index);
}

} // namespace

OffCursor::OffCursor(const FileBytes& file)
  : At(file.begin())
  , End(file.end())
{
  const std::string_view byteOrderMark = "\xef\xbb\xbf";
  if (file.view().substr(0, byteOrderMark.size()) == byteOrderMark)
  {
    this->At += byteOrderMark.size();
  }
}

void OffCursor::Fail(const std::string& what) const
{
  throw Failure("line " + std::to_string(this->Line) + ": " + what +
    "; check that the file is complete and has the right extension");
}

bool OffCursor::Skip()
{
  for (; this->At < this->End; ++this->At)
  {
    if (*this->At == '#')
    {
      this->SkipLine();
      if (this->At == this->End)
      {
        break;
      }
    }
    if (!IsSpace(*this->At))
    {
      return true;
    }
    const bool isCrOfCrLf = *this->At == '\r' && this->At + 1 < this->End && this->At[1] == '\n';
    this->Line += *this->At == '\n' || (*this->At == '\r' && !isCrOfCrLf);
  }
  return false;
}

void OffCursor::SkipLine()
{
  this->At = std::find_if(this->At, this->End, [](char c) { return c == '\n' || c == '\r'; });
}

std::string OffCursor::TakeWord()
{
  this->Skip();
  const char* const digit = std::find_if(
    this->At, this->End, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) == 0; });
  if (digit == this->End || !IsLetter(*digit))
  {
    return {};
  }
  const char* const end = std::find_if_not(digit, this->End, IsLetter);
  std::string word(this->At, end);
  for (char& c : word)
  {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  this->At = end;
  return word;
}

double OffCursor::TakeNumber(const char* owner, long long index)
{
  if (!this->Skip())
  {
    this->Fail("it ends within " + NameOf(owner, index));
  }
  char* end = nullptr;
  const double number = std::strtod(this->At, &end);
  if (end == this->At)
  {
    this->Fail("there is no number where " + NameOf(owner, index) + " needs one");
  }
  this->At = end;
  return number;
}

long long OffCursor::TakeWhole(const char* owner, long long index)
{
  if (!this->Skip())
  {
    this->Fail("it ends within " + NameOf(owner, index));
  }
  char* end = nullptr;
  const long long number = std::strtoll(this->At, &end, 10);
  if (end == this->At || (end < this->End && !IsSpace(*end) && *end != '#'))
  {
    this->Fail("there is no whole number where " + NameOf(owner, index) + " needs one");
  }
  this->At = end;
  return number;
}

} // namespace lambent::command
