// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlyHeader.h"
#include "Messages.h"

#include <map>
#include <sstream>

namespace lambent::command
{
namespace
{

PlyType TypeNamed(const std::string& name)
{
  static const std::map<std::string, PlyType> types = { { "char", PlyType::Int8 },
    { "int8", PlyType::Int8 }, { "uchar", PlyType::UInt8 }, { "uint8", PlyType::UInt8 },
    { "short", PlyType::Int16 }, { "int16", PlyType::Int16 }, { "ushort", PlyType::UInt16 },
    { "uint16", PlyType::UInt16 }, { "int", PlyType::Int32 }, { "int32", PlyType::Int32 },
    { "uint", PlyType::UInt32 }, { "uint32", PlyType::UInt32 }, { "float", PlyType::Float32 },
    { "float32", PlyType::Float32 }, { "double", PlyType::Float64 },
    { "float64", PlyType::Float64 } };
  const auto found = types.find(name);
  if (found == types.end())
  {
    throw Failure("its header has the unknown type '" + name.substr(0, 40) + "'");
  }
  return found->second;
}

PlyFormat FormatNamed(const std::string& name)
{
  if (name == "ascii")
  {
    return PlyFormat::Text;
  }
  if (name != "binary_little_endian" && name != "binary_big_endian")
  {
    throw Failure("its header has the unknown format '" + name.substr(0, 40) + "'");
  }
  return name == "binary_big_endian" ? PlyFormat::BigEndian : PlyFormat::LittleEndian;
}

PlyProperty ReadProperty(std::istream& words)
{
  PlyProperty property;
  std::string type;
  words >> type;
  if (type == "list")
  {
    std::string countType;
    words >> countType >> type;
    property.isList = true;
    property.countType = TypeNamed(countType);
  }
  property.type = TypeNamed(type);
  words >> property.name;
  return property;
}

} // namespace

std::size_t PlySize(PlyType type)
{
  switch (type)
  {
    case PlyType::Int8:
    case PlyType::UInt8:
      return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
      return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float32:
      return 4;
    case PlyType::Float64:
      break;
  }
  return 8;
}

namespace
{

/// The last byte of a line end. A '\r' before a '\n' does not matter.
char LineEndOf(std::string_view file)
{
  const std::size_t first = file.find_first_of("\r\n");
  const bool isCarriageReturn = first != std::string_view::npos && file[first] == '\r' &&
    (first + 1 == file.size() || file[first + 1] != '\n');
  return isCarriageReturn ? '\r' : '\n';
}

} // namespace

PlyHeader ParsePlyHeader(std::string_view file)
{
  PlyHeader header;
  bool hasFormat = false;
  const char lineEnd = LineEndOf(file);
  for (std::size_t lineNumber = 0;; ++lineNumber)
  {
    const std::size_t end = file.find(lineEnd, header.bodyOffset);
    std::istringstream words(
      std::string(file.substr(header.bodyOffset, end - header.bodyOffset))); // ">>" drops a '\r'
    std::string keyword;
    words >> keyword;
    if (lineNumber == 0 && keyword != "ply")
    {
      throw Failure("it does not begin with the line 'ply'");
    }
    if (end == std::string_view::npos)
    {
      throw Failure("it ends within its header");
    }
    header.bodyOffset = end + 1;
    header.lines = lineNumber + 1;

    if (keyword == "end_header")
    {
      break;
    }
    if (keyword == "format")
    {
      std::string name;
      words >> name;
      header.format = FormatNamed(name);
      hasFormat = true;
    }
    else if (keyword == "element")
    {
      PlyElement element;
      words >> element.name >> element.count;
      header.elements.push_back(element);
    }
    else if (keyword == "property" && !header.elements.empty())
    {
      header.elements.back().properties.push_back(ReadProperty(words));
    }
    // Any other line is a comment, or from a later version of the format.
    const bool isRead = keyword == "format" || keyword == "element" || keyword == "property";
    if (isRead && (words.fail() || (keyword != "format" && !(words >> std::ws).eof())))
    {
      throw Failure("line " + std::to_string(lineNumber + 1) + " of its header is incomplete");
    }
  }
  if (!hasFormat)
  {
    throw Failure("its header has no format");
  }
  return header;
}

} // namespace lambent::command
