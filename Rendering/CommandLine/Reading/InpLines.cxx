// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "InpLines.h"
#include "Messages.h"
#include "TextNumber.h"

#include <algorithm>
#include <cctype>

namespace lambent::command
{
namespace
{

bool IsSpace(char c)
{
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool IsLineEnd(char c)
{
  return c == '\n' || c == '\r';
}

} // namespace

std::string Quoted(std::string text)
{
  text.resize(std::min<std::size_t>(text.size(), 40));
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < 0x20 || c >= 0x7f; }, '?');
  return "'" + text + "'";
}

InpLines::InpLines(const FileBytes& file)
  : Begin(file.begin())
  , At(file.begin())
  , End(file.end())
{
  constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";
  if (file.view().substr(0, byteOrderMark.size()) == byteOrderMark)
  {
    this->At += byteOrderMark.size();
  }
}

double InpLines::Fraction() const
{
  return static_cast<double>(this->At - this->Begin) /
    static_cast<double>(this->End - this->Begin + 1);
}

void InpLines::Fail(const std::string& what) const
{
  throw Failure("line " + std::to_string(this->Number) + ": " + what);
}

bool InpLines::NextOfAnyKind()
{
  if (this->At == this->End)
  {
    return false;
  }
  const char* const end = std::find_if(this->At, this->End, IsLineEnd);
  this->Line.clear();
  for (; this->At != end; ++this->At)
  {
    if (!IsSpace(*this->At))
    {
      this->Line += static_cast<char>(std::toupper(static_cast<unsigned char>(*this->At)));
    }
  }
  if (this->At != this->End)
  {
    const bool isPair = this->At[0] == '\r' && this->At[1] == '\n'; // a zero byte follows the file
    this->At += isPair ? 2 : 1;
  }
  ++this->Number;
  return true;
}

bool InpLines::Next()
{
  while (this->NextOfAnyKind())
  {
    if (!this->Line.empty() && this->Line.compare(0, 2, "**") != 0)
    {
      return true;
    }
  }
  this->Line.clear();
  return false;
}

std::vector<std::string> InpLines::Fields() const
{
  std::vector<std::string> fields;
  for (std::size_t begin = 0; begin < this->Line.size();)
  {
    const std::size_t end = std::min(this->Line.find(',', begin), this->Line.size());
    fields.push_back(this->Line.substr(begin, end - begin));
    begin = end + 1;
  }
  return fields;
}

InpKeyword InpLines::TakeKeyword()
{
  std::vector<std::string> fields = this->Fields();
  while (this->IsContinued() && this->Next())
  {
    const std::vector<std::string> more = this->Fields();
    fields.insert(fields.end(), more.begin(), more.end());
  }
  InpKeyword keyword;
  keyword.name = fields[0].substr(1);
  for (std::size_t k = 1; k < fields.size(); ++k)
  {
    const std::size_t equals = std::min(fields[k].find('='), fields[k].size());
    keyword.parameters[fields[k].substr(0, equals)] =
      fields[k].substr(std::min(equals + 1, fields[k].size()));
  }
  return keyword;
}

void InpLines::AddIntegers(std::vector<std::int64_t>& numbers) const
{
  for (const std::string& field : this->Fields())
  {
    std::int64_t number = 0;
    const char* const end = ReadInteger(field.c_str(), number);
    if (field.empty() || *end != '\0')
    {
      this->Fail("found " + Quoted(field) + " where the number of an element or node is expected");
    }
    numbers.push_back(number);
  }
}

std::int64_t InpLines::Node(double coordinates[3]) const
{
  const std::vector<std::string> fields = this->Fields();
  std::int64_t number = 0;
  const char* const end = ReadInteger(fields[0].c_str(), number);
  if (fields[0].empty() || *end != '\0')
  {
    this->Fail("found " + Quoted(fields[0]) + " where the number of a node is expected");
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    coordinates[axis] = 0;
    std::string field = axis + 1 < fields.size() ? fields[axis + 1] : std::string();
    std::replace(field.begin(), field.end(), 'D', 'E'); // Fortran writes 1D3 for 1e3
    const char* const last = field.c_str() + field.size();
    if (!field.empty() && ReadNumber(field.c_str(), last, coordinates[axis]) != last)
    {
      this->Fail("found " + Quoted(field) + " where a coordinate of node " +
        std::to_string(number) + " is expected");
    }
  }
  return number;
}

} // namespace lambent::command
