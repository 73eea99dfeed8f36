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

struct Options
{
  std::vector<std::string> inputs;
  std::string output; ///< "-" is PNG to standard output

  std::array<int, 2> size{ 1920, 1080 };
  Triple background{ 0, 0, 0 };

  std::optional<Triple> cameraPosition;
  std::optional<Triple> focalPoint;
  std::optional<Triple> viewUp;
  std::optional<Triple> direction; ///< the side from which the camera looks
  std::optional<double> viewAngle; ///< degrees, across the height of the picture
  std::optional<double> parallelScale;
  double zoom = 1;

  std::vector<LightValue> lights; ///< none: a headlight

  Shading shading = Shading::Smooth;
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
