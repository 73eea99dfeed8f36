// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Values.h"

#include "vtkColor.h"
#include "vtkNamedColors.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lambent::command
{

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

double ParseNumber(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value))
  {
    throw BadValue("'" + text + "' is not a finite number");
  }
  return value;
}

double ParseNumber(const std::string& text, double low, double high)
{
  const double value = ParseNumber(text);
  if (value < low || value > high)
  {
    const auto brief = [](double bound) { return std::to_string(static_cast<int>(bound)); };
    throw BadValue("'" + text + "' is not between " + brief(low) + " and " + brief(high));
  }
  return value;
}

double ParsePositive(const std::string& text)
{
  const double value = ParseNumber(text);
  if (value <= 0)
  {
    throw BadValue("'" + text + "' is not above zero");
  }
  return value;
}

double ParseNotNegative(const std::string& text)
{
  const double value = ParseNumber(text);
  if (value < 0)
  {
    throw BadValue("'" + text + "' is below zero");
  }
  return value;
}

Triple ParseTriple(const std::string& text)
{
  const std::vector<std::string> parts = Split(text, ',');
  if (parts.size() != 3)
  {
    throw BadValue("'" + text + "' is not three numbers separated by commas, such as 0,0,1");
  }
  return { ParseNumber(parts[0]), ParseNumber(parts[1]), ParseNumber(parts[2]) };
}

Triple ParseDirection(const std::string& text)
{
  const Triple value = ParseTriple(text);
  if (value == Triple{ 0, 0, 0 })
  {
    throw BadValue("'" + text + "' has no direction; one of the three must not be zero");
  }
  return value;
}

Triple ParseColor(const std::string& text)
{
  if (text.find(',') != std::string::npos)
  {
    const Triple value = ParseTriple(text);
    if (std::any_of(value.begin(), value.end(), [](double c) { return c < 0 || c > 1; }))
    {
      throw BadValue("'" + text + "' is not a colour; red, green and blue go from 0 to 1");
    }
    return value;
  }
  const bool isHexadecimal = text.size() == 7 && text[0] == '#' &&
    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (isHexadecimal)
  {
    const auto channel = [&text](std::size_t at)
    { return std::stoi(text.substr(at, 2), nullptr, 16) / 255.0; };
    return { channel(1), channel(3), channel(5) };
  }
  vtkNew<vtkNamedColors> names;
  if (text.empty() || !names->ColorExists(text))
  {
    throw BadValue("'" + text + "' is not a colour; use r,g,b in 0..1, #rrggbb or a name");
  }
  const vtkColor3d color = names->GetColor3d(text);
  return { color[0], color[1], color[2] };
}

std::array<int, 2> ParseSize(const std::string& text)
{
  const std::vector<std::string> parts = Split(text, 'x');
  const auto side = [](const std::string& digits)
  {
    // Nine digits always fit an int; whether the picture fits into memory is not known here.
    const bool isNumber = !digits.empty() && digits.size() <= 9 &&
      digits.find_first_not_of("0123456789") == std::string::npos;
    return isNumber ? std::stoi(digits) : 0;
  };
  const std::array<int, 2> size =
    parts.size() == 2 ? std::array<int, 2>{ side(parts[0]), side(parts[1]) } : std::array<int, 2>{};
  if (size[0] < 1 || size[1] < 1)
  {
    throw BadValue("'" + text + "' is not a size in pixels of at least 1x1, such as 1920x1080");
  }
  return size;
}

ContourValue ParseContour(const std::string& text)
{
  const std::size_t comma = text.find(',');
  ContourValue contour;
  contour.value = ParseNumber(text.substr(0, comma));
  if (comma != std::string::npos)
  {
    contour.array = text.substr(comma + 1);
    if (contour.array.empty())
    {
      throw BadValue("'" + text + "' names no array after its comma");
    }
  }
  return contour;
}

namespace
{
void SetLightItem(LightValue& light, const std::string& key, const std::string& value)
{
  if (key == "position" || key == "direction")
  {
    if (light.kind != LightValue::Kind::Headlight)
    {
      throw BadValue("a light has one position or one direction");
    }
    const bool stands = key == "position";
    light.kind = stands ? LightValue::Kind::Positional : LightValue::Kind::Directional;
    light.place = stands ? ParseTriple(value) : ParseDirection(value);
  }
  else if (key == "color")
  {
    light.color = ParseColor(value);
  }
  else if (key == "intensity")
  {
    light.intensity = ParseNotNegative(value);
  }
  else if (key == "cone")
  {
    light.cone = ParseNumber(value, 0, 180);
  }
  else if (key == "exponent")
  {
    light.exponent = ParseNumber(value, 0, 128);
  }
  else if (key == "attenuation")
  {
    light.attenuation = ParseTriple(value);
    if (*std::max_element(light.attenuation.begin(), light.attenuation.end()) <= 0)
    {
      throw BadValue("attenuation " + value + " has no positive value; 1,0,0 does not fade");
    }
  }
  else if (key == "focal")
  {
    light.focus = ParseTriple(value);
    light.hasFocus = true;
  }
  else
  {
    throw BadValue("'" + key +
      "' is not one of position, direction, color, intensity, cone, exponent, attenuation, focal");
  }
}
}

LightValue ParseLight(const std::string& text)
{
  LightValue light;
  light.text = text;
  bool hasPositionalItem = false;
  std::string items = text;
  std::replace(items.begin(), items.end(), ';', ':');
  for (const std::string& item : Split(items, ':'))
  {
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos)
    {
      throw BadValue("'" + item + "' is not key=value, such as position=0,0,1");
    }
    const std::string key = item.substr(0, equals);
    SetLightItem(light, key, item.substr(equals + 1));
    hasPositionalItem |=
      key == "cone" || key == "exponent" || key == "attenuation" || key == "focal";
  }
  if (light.kind == LightValue::Kind::Headlight)
  {
    throw BadValue("'" + text + "' has neither position=x,y,z nor direction=x,y,z");
  }
  if (light.kind == LightValue::Kind::Directional && hasPositionalItem)
  {
    throw BadValue("cone, exponent, attenuation and focal are for lights with a position");
  }
  return light;
}

} // namespace lambent::command
