// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the options about what is stored: background, alpha and passes
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

/// A CLI11 check: the error in the name of a picture, or an empty string.
std::string IsPicture(const std::string& path);

/// Adds --background, --background-image, --alpha and --pass.
void AddFilm(CLI::App& app, Options& options);

/// Throws CLI::ValidationError if the output cannot hold alpha, if two passes have one name, or if
/// a pass would be stored nowhere.
void CheckFilm(const Options& options);

} // namespace lambent::command

#endif
