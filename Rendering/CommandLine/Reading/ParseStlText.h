// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief from the text of an STL file to its points and facets
 *
 *     solid NAME
 *       facet normal nx ny nz
 *         outer loop
 *           vertex x y z       (three times, or more often)
 *         endloop
 *       endfacet
 *     endsolid NAME
 *
 * Keywords may be in capitals, and line ends are blanks but for those behind a
 * name. What stands where the normal should be is not looked at: writers put nan
 * and worse there.
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
  std::size_t ignoredFrom = 0; ///< the line from which on all is ignored; 0 if none is
};

/// Whether the file begins as a text does.
bool IsStlText(std::string_view file);

/// Throws Failure, with the line, if something else is there than what is due, or the text ends
/// within a solid. A zero byte must follow the text.
StlText ParseStlText(std::string_view text, const std::function<void(double)>& progress);

} // namespace lambent::command

#endif
