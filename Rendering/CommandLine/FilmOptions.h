// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the options for the background, alpha and passes
 */

#ifndef FilmOptions_h
#define FilmOptions_h

#include "Options.h"

namespace CLI
{
class App;
}

namespace lambent::command
{

/// A CLI11 check: returns the error if the path is not that of a picture, or an empty string.
std::string IsPicture(const std::string& path);

/// Adds --background, --background-image, --alpha and --pass.
void AddFilm(CLI::App& app, Options& options);

/// Throws CLI::ValidationError if the output cannot hold alpha, if two passes have the same name,
/// or if a pass would not be stored anywhere.
void CheckFilm(const Options& options);

} // namespace lambent::command

#endif
