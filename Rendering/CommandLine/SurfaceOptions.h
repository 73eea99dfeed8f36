// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the command-line options of the surfaces: their material, how they are drawn, and the data
 *        that colours them
 */

#ifndef SurfaceOptions_h
#define SurfaceOptions_h

#include "Options.h"

namespace CLI
{
class App;
}

namespace lambent::command
{

/// The value of `--color` that stands for its default: the colours in the files, or else white.
constexpr const char* ColorsOfFiles = "file";

void AddSurface(CLI::App& app, Options& options);

/// Throws a CLI::ValidationError if options of colours contradict one another, or have no effect
/// without `--color-by`.
void CheckColors(const CLI::App& app, const Options& options);

} // namespace lambent::command

#endif
