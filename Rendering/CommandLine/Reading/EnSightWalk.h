// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief walks through EnSight Gold files by the counts in them
 *
 * Both functions throw EndOfEnSightFile if a file ends too early, and EnSightNotUnderstood at
 * unknown content.
 */

#ifndef EnSightWalk_h
#define EnSightWalk_h

#include <cstdint>
#include <map>
#include <string>

namespace lambent::command
{

class EnSightFile;

/// The number of values of a variable in a part.
struct EnSightPart
{
  std::int64_t points = 0;
  std::map<std::string, std::int64_t> elements; ///< by type; "block": the cells of a block
};

using EnSightParts = std::map<std::int64_t, EnSightPart>; ///< by part number

EnSightParts WalkEnSightGeometry(EnSightFile& file);

/// Walks through a variable with this many components, at the points or at the elements.
void WalkEnSightVariable(
  EnSightFile& file, const EnSightParts& parts, bool isAtPoints, int components);

} // namespace lambent::command

#endif
