// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what the command line asks for, as a plain struct
 *
 * What was not said and has no fixed default is absent (std::nullopt): the
 * scene decides then.
 */

#ifndef Options_h
#define Options_h

#include "Values.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lambent::command
{

/// The side from which the camera looks if nothing else is said: from the front, the right, and
/// above.
constexpr Triple DefaultDirection{ 2, 1.5, 4 };

/// The same before version 2 of the image contract, for pictures that do not name it.
constexpr Triple FormerDirection{ 0, 0, 1 };

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

enum class Metric
{
  MaximumDifference,
  RootMeanSquare,
  StructuralSimilarity
};

struct ComparisonOptions
{
  std::string baseline; ///< a .png or .vti; empty: nothing is compared
  Metric metric = Metric::MaximumDifference;
  double tolerance = 0;
  std::string difference; ///< picture to write; empty: none
  std::string report;     ///< HTML file to write or add to; empty: none
  std::string name;       ///< in the report; empty: the picture's, or the baseline's
};

struct Options
{
  std::vector<std::string> inputs;
  std::string output;  ///< "-" is PNG to standard output; empty: none, only a comparison
  std::string picture; ///< a file to compare, instead of inputs to draw

  std::string recreate; ///< a PNG to draw again as its text says, instead of inputs
  std::string recipe;   ///< the command, without the size, that draws the inputs so

  ComparisonOptions comparison;

  std::optional<std::array<int, 2>> size; ///< absent: that of the baseline, or 1920 x 1080
  Triple background{ 0, 0, 0 };

  std::optional<ContourValue> contour; ///< what to draw of volumes; absent: their outer surface

  std::optional<Triple> cameraPosition;
  std::optional<Triple> focalPoint;
  std::optional<Triple> viewUp;
  std::optional<Triple> direction; ///< the side from which the camera looks
  std::optional<double> viewAngle; ///< degrees, across the height of the picture
  std::optional<double> parallelScale;
  double zoom = 1;

  std::vector<LightValue> lights; ///< none: a headlight

  Shading shading = Shading::Smooth;
  std::optional<double> featureAngle; ///< degrees; sharper edges stay sharp; absent: 30
  AmbientModel ambientModel = AmbientModel::PerLight;
  double diffuse = 1;
  double ambient = 0;
  Triple color{ 1, 1, 1 };
  std::optional<Triple> ambientColor; ///< absent: as `color`

  int threads = 0; ///< 0: as many as VTK sees fit
  bool quiet = false;
  bool verbose = false;
};

/// What became of a command line: options to act on, or a status to leave with.
struct Parsed
{
  Options options;
  std::optional<int> exitStatus; ///< 0 after --help and --version, 2 after wrong usage
  std::string standardOutput;    ///< what to print there before leaving
  std::string standardError;
};

/// Reads a command line. Never prints and never ends the process.
Parsed ParseOptions(int argc, const char* const* argv, const std::string& version);

} // namespace lambent::command

#endif
