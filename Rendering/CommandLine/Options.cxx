// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Options.h"
#include "AddValue.h"
#include "ComparisonOptions.h"
#include "FileKinds.h"
#include "FilmOptions.h"
#include "Formats.h"
#include "Messages.h"
#include "Recipe.h"
#include "SurfaceOptions.h"

#include <set>

namespace lambent::command
{
namespace
{

const char* const Description =
  "Ray-traces surfaces with Lambert's light model into a picture, without a window or a GPU.";

const char* const Footer = R"(
Vectors are x,y,z without spaces. Colours are r,g,b in 0..1, #rrggbb or a name such as tomato.

A light is key=value pairs joined by colons:
  --light position=3,4,5:color=gold:intensity=0.8   a lamp that shines in all directions
  --light direction=0,-1,0                          light from infinitely far away that
                                                    travels along 0,-1,0: from above
Semicolons work too, but need quotes in a shell and separate the elements of a CMake list.
A lamp with cone=DEG shines only up to that angle from the direction to focal=x,y,z (default: the
camera's focal point); with exponent=E its light falls off inside the cone. attenuation=a,b,c
divides the light by a + b d + c d d at the distance d.

Reads VTK's files, .ply .stl .obj .off .gltf .fbx and others, and all of them gzipped; 'lambent
--formats' lists them. It draws the outer surface of volumes, or with --contour the surface where
an array has a value, and the first step of a time series. Several inputs form one scene.
Writes .png .jpg .tif .bmp .pnm .vti; an existing file is replaced only by a complete new one.

Colours come from the files, if they have any (PLY and OBJ vertices, or bytes of red, green and
blue as active scalars); --color turns that off. --color-by shows an array (point:NAME or
cell:NAME if both kinds have that name; otherwise the point array) in the colours of --colormap:
  viridis plasma inferno magma cividis turbo coolwarm gray x-ray rainbow jet hot black-body cool
  bone copper bwr seismic hsv
_r at the end of a name reverses the colours. 'lambent FILE --list' shows the arrays of a file.

A pass stores what the middle sample of each pixel sees: depth, normals, positions, ids (of cells),
input-ids, or an array of the inputs (point:NAME or cell:NAME if both kinds have that name).
--pass depth=depth.tif writes it to a file, .tif (32-bit floats) or .vti. A .vti picture holds all
passes, so the file may be omitted.

'lambent compare A.png B.png' compares two existing pictures; see 'lambent compare --help'.

Exit status: 0 success, and with --compare no difference; 1 different or failed (one line says
why); 2 wrong usage.

Examples:
  lambent dragon.ply -o dragon.png --direction 1,0.5,2 --color wheat --ambient 0.1
  lambent engine.vtu -o engine.png --color-by temperature --log --range 1,1000)";

/// A whole number from 1 to the largest.
int ParseCount(const std::string& text, int largest)
{
  const double value = ParseNumber(text, 1, largest);
  const int whole = static_cast<int>(value);
  return whole == value ? whole : throw BadValue("'" + text + "' is not a whole number");
}

void AddFiles(CLI::App& app, Options& options)
{
  app.add_option("INPUT", options.inputs, "mesh files, rendered as one scene")->type_name("");
  app
    .add_option("-o,--output", options.output, "picture to write; - writes PNG to standard output")
    ->type_name("FILE");
  AddValue(app, "--contour", "VALUE[,ARRAY]", options.contour, ParseContour,
    "draw the surface of volumes where the array has the value");
  AddValue(app, "--size", "WxH", options.size, ParseSize,
    "pixels [1920x1080; with --compare, those of the baseline]");
  AddValue(
    app, "--supersampling", "N", options.supersampling,
    [](const std::string& text) { return ParseCount(text, 16); },
    "N x N samples per pixel, 1..16, for smooth edges [3; with --compare, those of the baseline]");
}

void AddCamera(CLI::App& app, Options& options)
{
  const auto number = [](const std::string& text) { return ParsePositive(text); };
  const auto angle = [](const std::string& text)
  {
    const double value = ParsePositive(text);
    if (value >= 180)
    {
      throw BadValue("'" + text + "' is not an angle below 180 degrees");
    }
    return value;
  };
  CLI::Option* position = AddValue(app, "--camera-position", "X,Y,Z", options.cameraPosition,
    ParseTriple, "position of the eye [such that all inputs are in view]");
  AddValue(app, "--focal-point", "X,Y,Z", options.focalPoint, ParseTriple,
    "point that the camera looks at [the centre of the scene]");
  AddValue(app, "--view-up", "X,Y,Z", options.viewUp, ParseDirection,
    "the upward direction [0,1,0; 0,0,1 when looking along y]");
  AddValue(app, "--direction", "X,Y,Z", options.direction, ParseDirection,
    "side from which the camera looks, all inputs in view [2,1.5,4: front, right and above]")
    ->excludes(position);
  CLI::Option* viewAngle = AddValue(app, "--view-angle", "DEG", options.viewAngle, angle,
    "opening angle of the view over its height [30]");
  AddValue(app, "--parallel-scale", "S", options.parallelScale, number,
    "parallel projection; half the height of the view")
    ->excludes(viewAngle);
  AddValue(app, "--zoom", "F", options.zoom, number, "narrow the view by this factor [1]");
}

void AddLights(CLI::App& app, Options& options)
{
  AddValue(app, "--light", "SPEC", options.lights, ParseLight, "a light, see below; repeatable");
  app.add_flag_callback(
    "--headlight", [&options] { options.lights.emplace_back(); },
    "a light at the camera [on if there is no --light]");
}

void AddRunning(CLI::App& app, Options& options, const std::string& version)
{
  AddValue(
    app, "--threads", "N", options.threads,
    [](const std::string& text) { return ParseCount(text, 1024); }, "threads to use [all]");
  CLI::Option* quiet =
    app.add_flag("--quiet", options.quiet, "no progress bar and no warnings, only errors");
  app.add_flag("--verbose", options.verbose, "report each step and its time")->excludes(quiet);
  app.add_flag("--list", options.list,
    "print the points, cells, bounds, blocks and arrays of the inputs, and draw nothing");
  app
    .add_flag_callback(
      "--formats", [] { throw CLI::CallForVersion(DescribeFormats(), 0); },
      "list the file formats that can be read and written")
    ->trigger_on_parse();
  app.set_version_flag("--version", version + "\n");
}

std::string IsPng(const std::string& path)
{
  return PictureKindOf(path) == PictureKind::Png ? "" : "'" + path + "' does not end in .png";
}

/// Throws if other options than these are given beside `name`.
void AllowOnly(const CLI::App& app, const std::string& name, const std::set<std::string>& fitting)
{
  for (const CLI::Option* option : app.get_options())
  {
    if (option->count() > 0 && fitting.count(option->get_single_name()) == 0)
    {
      throw CLI::ExcludesError(name, option->get_name());
    }
  }
}

void CheckFiles(const CLI::App& app, const Options& options)
{
  if (!options.recreate.empty()) // the picture defines its scene
  {
    AllowOnly(app, "--recreate", { "recreate", "output", "pass", "threads", "quiet", "verbose" });
  }
  else if (options.inputs.empty())
  {
    throw CLI::RequiredError("INPUT");
  }
  else if (options.list)
  {
    AllowOnly(app, "--list", { "list", "INPUT", "quiet" });
  }
  else if (app.count("--output") == 0 && options.comparison.baseline.empty())
  {
    throw CLI::RequiredError("--output or --compare");
  }
  const std::string error =
    app.count("--output") > 0 && options.output != "-" ? IsPicture(options.output) : "";
  if (!error.empty())
  {
    throw CLI::ValidationError("--output", error);
  }
}

/// Describes an error in one line. Replaces a message of CLI11 that is hard to understand.
std::string Describe(const CLI::ParseError& error)
{
  const std::string text = OneLine(error.what());
  const std::size_t option = text.find(": At Most 1 required but received ");
  return option == std::string::npos ? text
                                     : text.substr(0, option) + " is given " +
      text.substr(text.rfind(' ') + 1) + " times; give it once";
}

} // namespace

Parsed ParseOptions(int argc, const char* const* argv, const std::string& version)
{
  if (argc > 1 && std::string(argv[1]) == "compare")
  {
    return ParseCompareOptions(argc - 1, argv + 1);
  }
  Parsed parsed;
  CLI::App app(Description, "lambent");
  app.footer(Footer);
  AddFiles(app, parsed.options);
  AddFilm(app, parsed.options);
  AddCamera(app, parsed.options);
  AddLights(app, parsed.options);
  AddSurface(app, parsed.options);
  AddComparison(app, parsed.options.comparison,
    app
      .add_option("--compare", parsed.options.comparison.baseline,
        "compare the picture with this .png or .vti; -o is then optional")
      ->type_name("BASELINE")
      ->check(IsComparable));
  app
    .add_option("--recreate", parsed.options.recreate,
      "render a .png of this command again, with its stored options; without -o, compare the two")
    ->type_name("PICTURE")
    ->check(IsPng);
  AddRunning(app, parsed.options, version);
  try
  {
    app.parse(argc, argv);
    CheckFiles(app, parsed.options);
    CheckFilm(parsed.options);
    CheckColors(app, parsed.options);
    parsed.options.recipe = parsed.options.recreate.empty() ? MakeRecipe(app, parsed.options) : "";
  }
  catch (const CLI::CallForHelp&)
  {
    parsed.exitStatus = 0;
    parsed.standardOutput = app.help();
  }
  catch (const CLI::CallForVersion& text) // or for the formats
  {
    parsed.exitStatus = 0;
    parsed.standardOutput = text.what();
  }
  catch (const CLI::ParseError& error)
  {
    parsed.exitStatus = 2;
    parsed.standardError = "lambent: " + Describe(error) + "\nTry 'lambent --help'.\n";
  }
  return parsed;
}

} // namespace lambent::command
