// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief goes through the words and numbers of a text in memory, and counts its lines
 *
 * Lines end with LF, CR LF or CR, in one file mixed if need be. A '#' begins a
 * comment that reaches to the end of its line. A backslash at the end of a line
 * joins the next one to it, but only where SkipBlanks() meets it: names and
 * comments may end with a backslash of their own.
 */

#ifndef TextCursor_h
#define TextCursor_h

#include "Messages.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace lambent::command
{

class TextCursor
{
public:
  /// The text must be followed by a zero byte. A byte order mark of UTF-8 is passed over.
  /// The number is that of the first line.
  explicit TextCursor(std::string_view text, std::size_t lineNumber = 1);

  bool IsAtEnd() const { return this->At == this->End; }
  /// How much of the text is behind, from 0 to 1.
  double Fraction() const;
  std::size_t Line() const { return this->LineNumber; }

  /// Goes to the next word of the line.
  void SkipBlanks();
  /// Goes to the next word of the text.
  void SkipSpace();
  /// Whether only a comment is left of the line, if anything.
  bool IsAtLineEnd() const;
  void NextLine();

  /// The word here, up to a blank or the end of the line; empty at the end of a line.
  std::string_view TakeWord();
  /// The number here, and the blanks behind it. Throws Failure with the line if there is none.
  double TakeNumber();
  /// The same, and it must be finite.
  double TakeFiniteNumber();

  /// Whether a number may end at that place: a blank, a comment, or the end of the line follows.
  bool IsBehindNumber(const char* at) const;
  const char* Position() const { return this->At; }
  void MoveTo(const char* position) { this->At = position; }

  /// "line 12: " and what is wrong there.
  Failure FailureHere(const std::string& what) const;
  /// The word here as a message quotes it: not too long, and without control characters.
  std::string QuotedWord() const;

private:
  static bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool IsLineEnd(char c) { return c == '\n' || c == '\r'; }
  bool JoinNextLine();
  const char* WordEnd() const;
  void TakeLineEnd();

  const char* Begin;
  const char* At;
  const char* End;
  std::size_t LineNumber;
};

inline void TextCursor::SkipBlanks()
{
  while (IsBlank(*this->At) || (*this->At == '\\' && this->JoinNextLine()))
  {
    this->At += IsBlank(*this->At);
  }
}

inline bool TextCursor::IsAtLineEnd() const
{
  return IsLineEnd(*this->At) || *this->At == '#' || this->At == this->End;
}

} // namespace lambent::command

#endif
