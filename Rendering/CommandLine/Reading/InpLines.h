// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the lines of an Abaqus input file
 *
 * Lines that begin with two asterisks are comments, lines with one asterisk are keywords, and all
 * other lines are data, with fields separated by commas. Case and blanks do not matter.
 */

#ifndef InpLines_h
#define InpLines_h

#include "FileBytes.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace lambent::command
{

/// A text of the file as quoted in messages: at most 40 characters, in ASCII.
std::string Quoted(std::string text);

/// A keyword line, in capitals and without blanks.
struct InpKeyword
{
  std::string name;                              ///< "ELEMENT"
  std::map<std::string, std::string> parameters; ///< "TYPE" and "S3R"
};

/// Every Failure thrown names the line.
class InpLines
{
public:
  explicit InpLines(const FileBytes& file);

  /// Moves to the next line that is neither empty nor a comment. Returns false at the end.
  bool Next();

  /// The current line, in capitals and without blanks.
  const std::string& Text() const { return this->Line; }
  bool IsKeyword() const { return this->Line[0] == '*'; }
  bool IsContinued() const { return this->Line.back() == ','; }

  /// Parses the current keyword line and the lines that continue it.
  InpKeyword TakeKeyword();

  /// Appends the integers of the current line.
  void AddIntegers(std::vector<std::int64_t>& numbers) const;

  /// Returns the number of a node and sets its coordinates; missing or empty ones are 0.
  std::int64_t Node(double coordinates[3]) const;

  double Fraction() const;
  [[noreturn]] void Fail(const std::string& what) const;

private:
  bool NextOfAnyKind();
  std::vector<std::string> Fields() const;

  const char* Begin;
  const char* At;
  const char* End;
  std::size_t Number = 0;
  std::string Line;
};

} // namespace lambent::command

#endif
