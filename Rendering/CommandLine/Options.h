// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the command line's options as a plain struct
 *
 * An option that was not given and has no fixed default is absent (std::nullopt); its value then
 * depends on the scene.
 */

#ifndef Options_h
#define Options_h

#include "ColorMaps.h"
#include "DataValues.h"
#include "PassValue.h"
#include "Values.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lambent::command
{

/// The default side from which the camera looks: the front, right and above.
constexpr Triple DefaultDirection{ 2, 1.5, 4 };

/// The default before version 2 of the image contract, for recipes that name no direction.
constexpr Triple FormerDirection{ 0, 0, 1 };

/// The value of `--color` in recipes that do not name it: older versions ignored colours in files.
constexpr const char* FormerColor = "white";

/// Samples along each axis of a pixel: the default, and that of recipes that do not name it.
constexpr int DefaultSupersampling = 3, FormerSupersampling = 1;

enum class Shading
{
  Smooth,
  Flat,
  Unlit
};

enum class AmbientModel
{
  PerLight,
  Scene
};

enum class Representation
{
  Surface,
  Wireframe,
  Points
};

enum class Metric
{
  MaximumDifference,
  RootMeanSquare,
  StructuralSimilarity
};

struct ComparisonOptions
{
  std::string baseline; ///< a .png or .vti; empty: no comparison
  Metric metric = Metric::MaximumDifference;
  double tolerance = 0;
  std::string difference; ///< picture to write; empty: none
  std::string report;     ///< HTML file to write or add to; empty: none
  std::string name;       ///< in the report; empty: the picture's path, or the baseline's
};

/// Colours from an array of the inputs.
struct ColorOptions
{
  std::string array;                          ///< of `--color-by`, as it was typed; empty: none
  std::optional<std::string> map;             ///< absent: DefaultColorMap
  std::optional<std::array<double, 2>> range; ///< absent: that of the array's finite numbers
  bool isLogarithmic = false;
  std::optional<Triple> nan; ///< absent: that of vtkLookupTable
};

struct Options
{
  std::vector<std::string> inputs;
  std::string output;  ///< "-": PNG to standard output; empty: no output, only a comparison
  std::string picture; ///< a file to compare, instead of inputs to draw

  std::string recreate; ///< a PNG to render again from its text, instead of inputs
  std::string recipe;   ///< the command that renders these inputs, without the size

  ComparisonOptions comparison;

  std::optional<std::array<int, 2>> size; ///< absent: the baseline's size, or 1920 x 1080
  std::optional<int> supersampling;       ///< absent: the baseline's, or DefaultSupersampling
  Triple background{ 0, 0, 0 };
  std::string backgroundImage; ///< a picture file; empty: none
  bool alpha = false;          ///< no background, and a fourth channel
  std::vector<PassValue> passes;

  std::optional<ContourValue> contour; ///< the contour of volumes; absent: their outer surface

  std::optional<Triple> cameraPosition;
  std::optional<Triple> focalPoint;
  std::optional<Triple> viewUp;
  std::optional<Triple> direction; ///< the side from which the camera looks
  std::optional<double> viewAngle; ///< degrees, over the height of the picture
  std::optional<double> parallelScale;
  double zoom = 1;

  std::vector<LightValue> lights; ///< none: a headlight

  Shading shading = Shading::Smooth;
  std::optional<double> featureAngle; ///< degrees; sharper edges stay sharp; absent: 30
  AmbientModel ambientModel = AmbientModel::PerLight;
  double diffuse = 1;
  double ambient = 0;
  std::optional<Triple> color;         ///< absent: the colours in the files, or else white
  std::optional<Triple> ambientColor;  ///< absent: as `color`
  std::string texture;                 ///< a picture file that covers the inputs; empty: none
  std::optional<double> specular;      ///< absent: that of materials, or else 0
  std::optional<double> specularPower; ///< absent: that of materials, or else 1
  double opacity = 1;
  Representation representation = Representation::Surface;
  bool edges = false;
  std::optional<Triple> edgeColor; ///< absent: black
  double lineWidth = 1;            ///< pixels
  double pointSize = 1;            ///< pixels
  std::optional<SpheresValue> spheres;
  ColorOptions colors;

  bool list = false; ///< describe the inputs instead of drawing them

  int threads = 0; ///< 0: VTK's default
  bool quiet = false;
  bool verbose = false;
};

/// The result of parsing a command line: options, or a status to exit with.
struct Parsed
{
  Options options;
  std::optional<int> exitStatus; ///< 0 after --help, --version and --formats, 2 after wrong usage
  std::string standardOutput;    ///< to print before exiting
  std::string standardError;
};

/// Parses a command line. Never prints and never ends the process.
Parsed ParseOptions(int argc, const char* const* argv, const std::string& version);

} // namespace lambent::command

#endif
