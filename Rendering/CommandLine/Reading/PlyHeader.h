// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief parses the header of a PLY file, which lists the elements and their layout
 */

#ifndef PlyHeader_h
#define PlyHeader_h

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::command
{

enum class PlyFormat
{
  Text,
  LittleEndian,
  BigEndian
};

enum class PlyType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64
};

/// The size of a value in a binary file, in bytes.
std::size_t PlySize(PlyType type);

struct PlyProperty
{
  std::string name;
  PlyType type = PlyType::Float32;
  bool isList = false;
  PlyType countType = PlyType::UInt8; ///< the type of the count before a list
};

struct PlyElement
{
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader
{
  PlyFormat format = PlyFormat::Text;
  std::vector<PlyElement> elements;
  std::size_t lines = 0;      ///< the number of lines of the header
  std::size_t bodyOffset = 0; ///< the offset of the first element in the file
};

/// Parses the header at the start of a file. Throws Failure if it is invalid. All its lines end
/// like the first one, with LF, CR LF or CR, since any byte may follow the last line.
PlyHeader ParsePlyHeader(std::string_view file);

} // namespace lambent::command

#endif
