// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief one pass as `--pass` describes it: data to store beside the picture
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
    Any, ///< of points or of cells, whichever the inputs have
    Points,
    Cells
  };
  Content content = Content::Depth;
  Association association = Association::Any; ///< of an Array
  std::string array;                          ///< its name in the picture
  std::string text;                           ///< as it was typed, without the file
  std::string file; ///< a .tif or .vti; empty: the pass is only in the picture
};

/// Whether the picture itself has an array of that name, so that no input's can be stored under it.
bool IsOwnArray(const std::string& name);

/// depth, normals, positions, ids, input-ids, or the name of an array, perhaps after point: or
/// cell:, and then perhaps =FILE. Throws BadValue.
PassValue ParsePass(const std::string& text);

} // namespace lambent::command

#endif
