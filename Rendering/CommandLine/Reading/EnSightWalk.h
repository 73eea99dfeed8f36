// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief goes through files of EnSight Gold by the counts in them
 *
 * Both functions throw EndOfEnSightFile where a file ends too early, and EnSightNotUnderstood
 * where it holds something that they do not know.
 */

#ifndef EnSightWalk_h
#define EnSightWalk_h

#include <cstdint>
#include <map>
#include <string>

namespace lambent::command
{

class EnSightFile;

/// How many values a variable has in a part.
struct EnSightPart
{
  std::int64_t points = 0;
  std::map<std::string, std::int64_t> elements; ///< by their types; "block": cells of a block
};

using EnSightParts = std::map<std::int64_t, EnSightPart>; ///< by their numbers

EnSightParts WalkEnSightGeometry(EnSightFile& file);

/// A variable of so many components at the points or, else, at the elements.
void WalkEnSightVariable(
  EnSightFile& file, const EnSightParts& parts, bool isAtPoints, int components);

} // namespace lambent::command

#endif
