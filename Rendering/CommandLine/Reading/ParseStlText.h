// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief parses the points and facets of an STL text file
 *
 *     solid NAME
 *       facet normal nx ny nz
 *         outer loop
 *           vertex x y z       (three times or more)
 *         endloop
 *       endfacet
 *     endsolid NAME
 *
 * Keywords may be in capitals. Line ends are blanks, except after a name. The normal is ignored,
 * because some programs write nan or other text there.
 */

#ifndef ParseStlText_h
#define ParseStlText_h

#include "CellLists.h"
#include "MergedPoints.h"

#include <functional>
#include <string_view>

namespace lambent::command
{

struct StlText
{
  MergedPoints<double> points;
  CellLists facets;
  std::size_t ignoredFrom = 0; ///< the first line of the ignored rest; 0 if there is none
};

/// Whether the file begins like an STL text.
bool IsStlText(std::string_view file);

/// Throws Failure with the line at an unexpected word, or if the text ends within a solid. A zero
/// byte must follow the text.
StlText ParseStlText(std::string_view text, const std::function<void(double)>& progress);

} // namespace lambent::command

#endif
