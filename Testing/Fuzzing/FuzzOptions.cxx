// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line, with a zero byte after each argument: either a message and a status, or
// consistent options.
#include "FuzzInput.h"

#include "Options.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace lambent::command;

namespace
{
void requireFinite(const Triple& v)
{
  require(std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]), "vectors are finite");
}

void requireColor(const Triple& v)
{
  for (const double channel : v)
  {
    require(channel >= 0.0 && channel <= 1.0, "colours lie between 0 and 1");
  }
}

bool endsIn(const std::string& path, std::initializer_list<const char*> extensions)
{
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(extensions.begin(), extensions.end(),
    [&lower](const std::string& extension)
    {
      return lower.size() > extension.size() &&
        lower.compare(lower.size() - extension.size(), extension.size(), extension) == 0;
    });
}

void checkFilm(const Options& options)
{
  const bool hasBackground = options.background != Triple{ 0, 0, 0 };
  require(!options.alpha || (!hasBackground && options.backgroundImage.empty()),
    "with alpha there is no background");
  require(!options.alpha || !endsIn(options.output, { ".jpg", ".jpeg", ".bmp", ".pnm", ".ppm" }),
    "the picture can hold alpha");
  std::set<std::string> names;
  for (const PassValue& pass : options.passes)
  {
    require(!pass.array.empty() && names.insert(pass.array).second, "each pass has a unique name");
    require(pass.file.empty() ? endsIn(options.output, { ".vti" })
                              : endsIn(pass.file, { ".tif", ".tiff", ".vti" }),
      "each pass is stored");
    require(pass.content != PassValue::Content::Array || !IsOwnArray(pass.array),
      "no array of the inputs replaces an array of the picture");
  }
}

void checkSurfaces(const Options& options)
{
  const auto isPositive = [](double value) { return value > 0 && std::isfinite(value); };
  require(!options.specular || (*options.specular >= 0 && *options.specular <= 1),
    "specular lies between 0 and 1");
  require(!options.specularPower || (*options.specularPower >= 0 && *options.specularPower <= 128),
    "the power is one of VTK's");
  require(options.opacity >= 0 && options.opacity <= 1, "opacity lies between 0 and 1");
  require(isPositive(options.lineWidth) && isPositive(options.pointSize), "sizes are positive");
  require(!options.spheres || isPositive(options.spheres->radius), "radii are positive");
  requireColor(options.edgeColor.value_or(Triple{}));
  const ColorOptions& colors = options.colors;
  requireColor(colors.nan.value_or(Triple{}));
  require(
    !colors.array.empty() || (!colors.map && !colors.range && !colors.isLogarithmic && !colors.nan),
    "the scale belongs to an array");
  require(!colors.map || FindColorMap(*colors.map), "the map is known");
  if (colors.range)
  {
    const auto [low, high] = *colors.range;
    require(std::isfinite(low) && std::isfinite(high) && low <= high, "the range is upright");
    require(!colors.isLogarithmic || low > 0, "logarithms need numbers above 0");
  }
}

void check(const Options& options)
{
  checkFilm(options);
  checkSurfaces(options);
  require(!options.inputs.empty() + !options.picture.empty() + !options.recreate.empty() == 1,
    "there are inputs, or a picture to compare or to recreate");
  require(options.list || !options.output.empty() || !options.comparison.baseline.empty() ||
      !options.recreate.empty(),
    "there is something to do");
  require(options.picture.empty() || !options.comparison.baseline.empty(),
    "a picture is compared with a baseline");
  require(options.comparison.tolerance >= 0 && std::isfinite(options.comparison.tolerance),
    "the tolerance is not negative");
  if (options.size)
  {
    require((*options.size)[0] >= 1 && (*options.size)[1] >= 1, "there are pixels");
  }
  require(options.diffuse >= 0 && options.diffuse <= 1, "diffuse lies between 0 and 1");
  require(options.ambient >= 0 && options.ambient <= 1, "ambient lies between 0 and 1");
  require(options.zoom > 0 && std::isfinite(options.zoom), "the zoom is positive");
  require(options.threads >= 0 && options.threads <= 1024, "there are at most 1024 threads");
  require(!(options.quiet && options.verbose), "it is not both quiet and verbose");
  require(!(options.cameraPosition && options.direction),
    "the camera is placed by its position or by a direction, not both");
  requireColor(options.background);
  requireColor(options.color.value_or(Triple{}));
  requireColor(options.ambientColor.value_or(Triple{}));
  for (const auto& v :
    { options.cameraPosition, options.focalPoint, options.viewUp, options.direction })
  {
    requireFinite(v.value_or(Triple{}));
  }
  for (const LightValue& light : options.lights)
  {
    requireColor(light.color);
    requireFinite(light.place);
    requireFinite(light.focus);
    requireFinite(light.attenuation);
    require(std::isfinite(light.intensity) && std::isfinite(light.cone) &&
        std::isfinite(light.exponent) && light.exponent >= 0,
      "lights are finite");
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::vector<std::string> arguments{ "lambent" };
  std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
  for (std::string argument; std::getline(text, argument, '\0');)
  {
    arguments.push_back(argument);
  }
  std::vector<const char*> argv;
  for (const std::string& argument : arguments)
  {
    argv.push_back(argument.c_str());
  }
  const Parsed parsed = ParseOptions(static_cast<int>(argv.size()), argv.data(), "0");
  if (parsed.exitStatus)
  {
    require(*parsed.exitStatus == 0 || *parsed.exitStatus == 2, "the status is 0 or 2");
    const std::string& error = parsed.standardError;
    require(std::count(error.begin(), error.end(), '\n') == *parsed.exitStatus,
      "wrong usage prints an error and a hint");
    require((*parsed.exitStatus == 0) != parsed.standardOutput.empty(), "help is printed");
    return 0;
  }
  check(parsed.options);
  return 0;
}
