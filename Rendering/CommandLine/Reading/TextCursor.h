// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the words and numbers of a text in memory, and counts its lines
 *
 * Lines end with LF, CR LF or CR, even mixed within a file. A '#' starts a comment up to the end of
 * the line. A backslash at the end of a line joins it with the next, but only where SkipBlanks()
 * finds it, because names and comments may end with a backslash.
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
  /// A zero byte must follow the text. A UTF-8 byte order mark is skipped. `lineNumber` is the
  /// number of the first line.
  explicit TextCursor(std::string_view text, std::size_t lineNumber = 1);

  bool IsAtEnd() const { return this->At == this->End; }
  /// The fraction of the text before the cursor, from 0 to 1.
  double Fraction() const;
  std::size_t Line() const { return this->LineNumber; }

  /// Moves to the next word of the line.
  void SkipBlanks();
  /// Moves to the next word of the text.
  void SkipSpace();
  /// Whether nothing or only a comment is left of the line.
  bool IsAtLineEnd() const;
  void NextLine();

  /// Reads a word, up to a blank or the end of the line; empty at the end of a line.
  std::string_view TakeWord();
  /// Reads the rest of the line, with blanks and '#' within it, but without those around it.
  std::string TakeRest();
  /// Reads a number and skips the blanks after it. Throws Failure with the line if there is none.
  double TakeNumber();
  /// Like TakeNumber(), but throws Failure if the number is not finite.
  double TakeFiniteNumber();

  /// Whether a number may end there: a blank, a comment or the end of the line follows.
  bool IsBehindNumber(const char* at) const;
  const char* Position() const { return this->At; }
  void MoveTo(const char* position) { this->At = position; }

  /// A Failure with the text "line 12: " and `what`.
  Failure FailureHere(const std::string& what) const;
  /// The current word as quoted in messages: at most 40 characters, in printable ASCII.
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
