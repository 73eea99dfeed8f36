// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief parses the values of options
 *
 * Each function parses its whole text, or throws BadValue with a sentence that says what was
 * expected. Only finite numbers are accepted, so the command line never passes on a NaN.
 */

#ifndef Values_h
#define Values_h

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace lambent::command
{

using Triple = std::array<double, 3>;

/// A value that cannot be parsed; what() says what was expected.
struct BadValue : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// One light as `--light` describes it.
struct LightValue
{
  enum class Kind
  {
    Headlight,  ///< at the camera, in its direction of view
    Positional, ///< at `place`
    Directional ///< from infinitely far away, along `place`
  };
  Kind kind = Kind::Headlight;
  std::string text; ///< as it was typed
  Triple place{ 0, 0, 0 };
  Triple color{ 1, 1, 1 };
  double intensity = 1;

  // Only for positional lights.
  double cone = 180; ///< half the opening angle of the cone in degrees; no cone from 90 on
  double exponent = 0;
  Triple attenuation{ 1, 0, 0 };
  bool hasFocus = false;
  Triple focus{ 0, 0, 0 }; ///< what the cone points at; default: the camera's focal point
};

/// A surface in a volume as `--contour` describes it.
struct ContourValue
{
  double value = 0;
  std::string array;        ///< empty: the volume's only or active array, see Contour.h
  bool keepsArrays = false; ///< whether the surface also gets the volume's other point arrays
};

/// The parts of a text between separators; an empty text has one empty part.
std::vector<std::string> Split(const std::string& text, char separator);

/// A finite number.
double ParseNumber(const std::string& text);

/// A finite number in [low, high].
double ParseNumber(const std::string& text, double low, double high);

/// A finite number above zero.
double ParsePositive(const std::string& text);

/// A finite number, zero or above.
double ParseNotNegative(const std::string& text);

/// x,y,z
Triple ParseTriple(const std::string& text);

/// x,y,z that are not all zero.
Triple ParseDirection(const std::string& text);

/// r,g,b in 0..1, \#rrggbb, or a name from vtkNamedColors.
Triple ParseColor(const std::string& text);

/// WIDTHxHEIGHT, each at least 1.
std::array<int, 2> ParseSize(const std::string& text);

/// VALUE or VALUE,ARRAY; the array's name may contain commas.
ContourValue ParseContour(const std::string& text);

/// position=x,y,z or direction=x,y,z, and other key=value pairs, joined by colons or semicolons.
LightValue ParseLight(const std::string& text);

} // namespace lambent::command

#endif
