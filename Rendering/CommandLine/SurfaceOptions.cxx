// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceOptions.h"
#include "AddValue.h"
#include "FilmOptions.h"

#include <map>

namespace lambent::command
{
namespace
{

double ParseFraction(const std::string& text)
{
  return ParseNumber(text, 0, 1);
}

/// Adds an option whose value is one of a few words.
template <typename Value>
void AddChoice(CLI::App& app, const std::string& name, const std::string& words, Value& target,
  const std::map<std::string, Value>& choices, const std::string& help)
{
  AddValue(
    app, name, words, target,
    [choices](const std::string& text)
    {
      const auto found = choices.find(text);
      if (found != choices.end())
      {
        return found->second;
      }
      std::string list;
      for (const auto& [word, value] : choices)
      {
        list += (list.empty() ? "" : ", ") + word;
      }
      throw BadValue("'" + text + "' is not one of: " + list);
    },
    help);
}

void AddMaterial(CLI::App& app, Options& options)
{
  AddValue(app, "--diffuse", "F", options.diffuse, ParseFraction, "diffuse reflection, 0..1 [1]");
  AddValue(app, "--ambient", "F", options.ambient, ParseFraction, "ambient reflection, 0..1 [0]");
  AddValue(
    app, "--color", "COLOUR", options.color,
    [](const std::string& text)
    { return text == ColorsOfFiles ? std::optional<Triple>() : ParseColor(text); },
    "colour of the surfaces, instead of colours in the files [file: these, or else white]");
  AddValue(app, "--ambient-color", "COLOUR", options.ambientColor, ParseColor,
    "colour of the ambient reflection [as --color]");
  app
    .add_option("--texture", options.texture,
      "picture that covers the surfaces, which need texture coordinates; instead of materials")
    ->type_name("FILE")
    ->check(IsPicture);
  AddValue(
    app, "--specular", "F", options.specular, ParseFraction, "specular reflection, 0..1 [0]");
  AddValue(
    app, "--specular-power", "P", options.specularPower,
    [](const std::string& text) { return ParseNumber(text, 0, 128); },
    "how small and sharp highlights are, 0..128 [1]");
  AddValue(
    app, "--opacity", "F", options.opacity, ParseFraction, "from 0, invisible, to 1, opaque [1]");
}

void AddShading(CLI::App& app, Options& options)
{
  AddChoice(app, "--shading", "smooth|flat|unlit", options.shading,
    { { "smooth", Shading::Smooth }, { "flat", Shading::Flat }, { "unlit", Shading::Unlit } },
    "[smooth]");
  AddValue(
    app, "--feature-angle", "DEG", options.featureAngle,
    [](const std::string& text) { return ParseNumber(text, 0, 180); },
    "meshes without normals: sharper edges stay sharp; 180: all edges are smooth [30]");
  AddChoice(app, "--ambient-model", "per-light|scene", options.ambientModel,
    { { "per-light", AmbientModel::PerLight }, { "scene", AmbientModel::Scene } },
    "add the ambient term for each light, or once [per-light]");
}

void AddRepresentation(CLI::App& app, Options& options)
{
  const auto positive = [](const std::string& text) { return ParsePositive(text); };
  AddChoice(app, "--representation", "surface|wireframe|points", options.representation,
    { { "surface", Representation::Surface }, { "wireframe", Representation::Wireframe },
      { "points", Representation::Points } },
    "[surface]");
  app.add_flag("--edges", options.edges, "draw the edges of the faces, too");
  AddValue(app, "--edge-color", "COLOUR", options.edgeColor, ParseColor,
    "draw the edges in this colour [black]");
  AddValue(
    app, "--line-width", "W", options.lineWidth, positive, "of lines and edges, in pixels [1]");
  AddValue(app, "--point-size", "S", options.pointSize, positive, "of points, in pixels [1]");
  AddValue(app, "--spheres", "RADIUS|ARRAY", options.spheres, ParseSpheres,
    "draw a sphere at each point instead of the faces; RADIUS,ARRAY multiplies them");
}

void AddColors(CLI::App& app, ColorOptions& colors)
{
  app
    .add_option("--color-by", colors.array,
      "colour by this point or cell array; ':0' chooses a component, ':magnitude' the length")
    ->type_name("NAME[:COMPONENT]");
  AddValue(app, "--colormap", "NAME", colors.map, ParseColorMap,
    "colours of the numbers, see below [viridis]");
  AddValue(app, "--range", "LOW,HIGH", colors.range, ParseRange,
    "numbers with the first and the last colour [those of the array]");
  app.add_flag("--log", colors.isLogarithmic, "map the logarithms of the numbers");
  AddValue(
    app, "--nan-color", "COLOUR", colors.nan, ParseColor, "colour of NaN [0.5,0,0, dark red]");
}

} // namespace

void AddSurface(CLI::App& app, Options& options)
{
  AddMaterial(app, options);
  AddShading(app, options);
  AddRepresentation(app, options);
  AddColors(app, options.colors);
}

void CheckColors(const CLI::App& app, const Options& options)
{
  const ColorOptions& colors = options.colors;
  for (const char* const option : { "--colormap", "--range", "--log", "--nan-color" })
  {
    if (app.count(option) > 0 && app.count("--color-by") == 0)
    {
      throw CLI::ValidationError(
        option, "it needs --color-by NAME; 'lambent FILE --list' shows the names of the arrays");
    }
  }
  if (app.count("--color-by") > 0 && colors.array.empty())
  {
    throw CLI::ValidationError(
      "--color-by", "'' names no array; 'lambent FILE --list' shows the names of the arrays");
  }
  if (colors.isLogarithmic && colors.range && (*colors.range)[0] <= 0)
  {
    throw CLI::ValidationError("--log",
      "the numbers of --range must be above 0; a range such as 0.01,100 is, or omit --log");
  }
}

} // namespace lambent::command
