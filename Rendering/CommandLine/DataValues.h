// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief parses the values of the options that show data: `--range`, `--colormap`, `--spheres`
 *
 * Each function parses its whole text, or throws BadValue.
 */

#ifndef DataValues_h
#define DataValues_h

#include "Values.h"

#include <array>
#include <string>

namespace lambent::command
{

/// The radii of `--spheres`: a number, the values of a point array, or the product of both.
struct SpheresValue
{
  double radius = 1; ///< world units, or the factor of the array
  std::string array; ///< empty: all spheres have the radius
};

/// LOW,HIGH: finite numbers, the first not above the second.
std::array<double, 2> ParseRange(const std::string& text);

/// The name of a colour map, see ColorMaps.h.
std::string ParseColorMap(const std::string& text);

/// RADIUS, ARRAY or RADIUS,ARRAY; the array's name may contain commas.
SpheresValue ParseSpheres(const std::string& text);

} // namespace lambent::command

#endif
