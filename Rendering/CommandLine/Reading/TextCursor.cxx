// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextCursor.h"
#include "TextNumber.h"

#include <cmath>
#include <cstring>

namespace lambent::command
{

TextCursor::TextCursor(std::string_view text, std::size_t lineNumber)
  : Begin(text.data())
  , At(text.data())
  , End(text.data() + text.size())
  , LineNumber(lineNumber)
{
  constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";
  if (text.substr(0, byteOrderMark.size()) == byteOrderMark)
  {
    this->At += byteOrderMark.size();
  }
}

double TextCursor::Fraction() const
{
  return static_cast<double>(this->At - this->Begin) /
    static_cast<double>(this->End - this->Begin + 1);
}

/// At a backslash: moves to the next line. Returns false if more follows on the line.
bool TextCursor::JoinNextLine()
{
  const char* behind = this->At + 1;
  while (IsBlank(*behind))
  {
    ++behind;
  }
  if (!IsLineEnd(*behind))
  {
    return false;
  }
  this->At = behind;
  this->TakeLineEnd();
  return true;
}

void TextCursor::TakeLineEnd()
{
  const bool isPair = this->At[0] == '\r' && this->At[1] == '\n';
  this->At += isPair ? 2 : 1;
  ++this->LineNumber;
}

void TextCursor::SkipSpace()
{
  while (true)
  {
    if (IsBlank(*this->At))
    {
      ++this->At;
    }
    else if (IsLineEnd(*this->At))
    {
      this->TakeLineEnd();
    }
    else
    {
      return;
    }
  }
}

void TextCursor::NextLine()
{
  while (this->At != this->End && !IsLineEnd(*this->At))
  {
    ++this->At;
  }
  if (this->At != this->End)
  {
    this->TakeLineEnd();
  }
}

const char* TextCursor::WordEnd() const
{
  const char* behind = this->At;
  while (behind != this->End && !IsBlank(*behind) && !IsLineEnd(*behind) &&
    !(behind[0] == '\\' && IsLineEnd(behind[1])))
  {
    ++behind;
  }
  return behind;
}

std::string_view TextCursor::TakeWord()
{
  const char* const begin = this->At;
  this->At = this->WordEnd();
  return { begin, static_cast<std::size_t>(this->At - begin) };
}

std::string TextCursor::TakeRest()
{
  while (IsBlank(*this->At))
  {
    ++this->At;
  }
  const char* const begin = this->At;
  const char* behind = begin; // the last character that is not blank
  for (; this->At != this->End && !IsLineEnd(*this->At); ++this->At)
  {
    behind = IsBlank(*this->At) ? behind : this->At + 1;
  }
  return { begin, behind };
}

/// Some systems write NaN as "1.#IND" and the like; there the '#' does not start a comment.
bool TextCursor::IsBehindNumber(const char* at) const
{
  return at == this->End || IsBlank(*at) || IsLineEnd(*at) || *at == '\\' ||
    (*at == '#' && at[-1] != '.');
}

double TextCursor::TakeNumber()
{
  double value = 0;
  const char* const behind = ReadNumber(this->At, this->End, value);
  if (behind == this->At || !this->IsBehindNumber(behind))
  {
    if (this->IsAtLineEnd())
    {
      throw this->FailureHere("it ends where a number is expected");
    }
    throw this->FailureHere("found " + this->QuotedWord() + " where a number is expected");
  }
  this->At = behind;
  this->SkipBlanks();
  return value;
}

double TextCursor::TakeFiniteNumber()
{
  const TextCursor before = *this;
  const double value = this->TakeNumber();
  if (!std::isfinite(value))
  {
    throw before.FailureHere(before.QuotedWord() + " is not a finite number");
  }
  return value;
}

Failure TextCursor::FailureHere(const std::string& what) const
{
  return Failure("line " + std::to_string(this->LineNumber) + ": " + what);
}

std::string TextCursor::QuotedWord() const
{
  constexpr std::ptrdiff_t longest = 40;
  const char* const behind = this->WordEnd();
  std::string word;
  for (const char* at = this->At; at != behind && at - this->At < longest; ++at)
  {
    const unsigned char c = static_cast<unsigned char>(*at);
    word += c < 0x20 || c >= 0x7f ? '?' : *at;
  }
  return "'" + word + (behind - this->At > longest ? "...'" : "'");
}

} // namespace lambent::command
