// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief goes through the lines of an input file of Abaqus
 *
 * Lines that begin with two asterisks are comments, those with one begin with a
 * keyword, all others are data, fields with commas between them. Neither case nor
 * blanks matter.
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

/// A text of the file as a message quotes it: not too long, and in ASCII.
std::string Quoted(std::string text);

/// In capitals and without blanks.
struct InpKeyword
{
  std::string name;                              ///< "ELEMENT"
  std::map<std::string, std::string> parameters; ///< "TYPE" and "S3R"
};

/// Throws Failure with the line.
class InpLines
{
public:
  explicit InpLines(const FileBytes& file);

  /// Goes to the next line that is neither empty nor comment; false at the end.
  bool Next();

  /// The line here, in capitals and without blanks.
  const std::string& Text() const { return this->Line; }
  bool IsKeyword() const { return this->Line[0] == '*'; }
  bool IsContinued() const { return this->Line.back() == ','; }

  /// The keyword here, and those of the next lines that continue it.
  InpKeyword TakeKeyword();

  /// The whole numbers of the line here, added to those before it.
  void AddIntegers(std::vector<std::int64_t>& numbers) const;

  /// The number and the coordinates of a node; those that are missing or empty are 0.
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
