// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the header of a PLY file: which elements follow, and how they are laid out
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

/// Bytes that a value takes in a binary file.
std::size_t PlySize(PlyType type);

struct PlyProperty
{
  std::string name;
  PlyType type = PlyType::Float32;
  bool isList = false;
  PlyType countType = PlyType::UInt8; ///< of the number that precedes a list
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
  std::size_t lines = 0;      ///< how many it has
  std::size_t bodyOffset = 0; ///< where the first element begins in the file
};

/// Reads the header at the start of a file; throws Failure with what is wrong in it. Its lines end
/// as the first one does, with LF, CR LF or CR: behind the last one any byte may follow.
PlyHeader ParsePlyHeader(std::string_view file);

} // namespace lambent::command

#endif
