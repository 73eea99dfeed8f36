// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DataValues.h"
#include "ColorMaps.h"

#include <optional>

namespace lambent::command
{
namespace
{

/// The number, or nothing if the text is another word: the name of an array.
std::optional<double> NumberIn(const std::string& text)
{
  try
  {
    return ParseNumber(text);
  }
  catch (const BadValue&)
  {
    return std::nullopt;
  }
}

} // namespace

std::array<double, 2> ParseRange(const std::string& text)
{
  const std::vector<std::string> parts = Split(text, ',');
  if (parts.size() != 2)
  {
    throw BadValue("'" + text + "' is not two numbers separated by a comma, such as 0,100");
  }
  const std::array<double, 2> range = { ParseNumber(parts[0]), ParseNumber(parts[1]) };
  if (range[0] > range[1])
  {
    throw BadValue("'" + text + "' is upside down; write " + parts[1] + "," + parts[0] +
      ", and to reverse the colours add _r to the name of --colormap");
  }
  return range;
}

std::string ParseColorMap(const std::string& text)
{
  if (!FindColorMap(text))
  {
    throw BadValue("'" + text + "' is not a colour map; the names are: " + ColorMapNames() +
      "; add _r to reverse one");
  }
  return text;
}

SpheresValue ParseSpheres(const std::string& text)
{
  const std::size_t comma = text.find(',');
  const std::optional<double> first = NumberIn(text.substr(0, comma));
  SpheresValue spheres;
  if (first)
  {
    spheres.radius = ParsePositive(text.substr(0, comma));
    spheres.array = comma == std::string::npos ? "" : text.substr(comma + 1);
  }
  else
  {
    spheres.array = text;
  }
  if (text.empty() || (first && comma != std::string::npos && spheres.array.empty()))
  {
    throw BadValue("'" + text + "' names no array; use RADIUS, ARRAY or RADIUS,ARRAY");
  }
  return spheres;
}

} // namespace lambent::command
