// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief one pass of `--pass`: data to store in addition to the picture
 */

#ifndef PassValue_h
#define PassValue_h

#include <string>

namespace lambent::command
{

struct PassValue
{
  enum class Content
  {
    Depth,
    Normals,
    Positions,
    CellIds,
    InputIds,
    Array ///< a point or cell array of the inputs
  };
  enum class Association
  {
    Any, ///< points or cells, whichever the inputs have
    Points,
    Cells
  };
  Content content = Content::Depth;
  Association association = Association::Any; ///< for Content::Array
  std::string array;                          ///< its name in the picture
  std::string text;                           ///< as it was typed, without the file
  std::string file; ///< a .tif or .vti; empty: the pass is only in the picture
};

/// Whether the picture itself may have an array of that name, which an input's array cannot
/// replace.
bool IsOwnArray(const std::string& name);

/// Parses NAME or NAME=FILE. NAME is depth, normals, positions, ids, input-ids or the name of an
/// array, optionally after point: or cell:. Throws BadValue.
PassValue ParsePass(const std::string& text);

} // namespace lambent::command

#endif
