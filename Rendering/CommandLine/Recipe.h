// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the recipe of a picture: text in its PNG file from which it can be rendered again
 *
 * A PNG file holds two texts: the version of the image contract, and the command that renders the
 * picture again. The command has the inputs and the scene's options as they were typed, in a fixed
 * order and quoted for the shell. It always has the direction of view, the colour and the
 * supersampling, even if they were not given, because the defaults have changed: a command without
 * them was written by an older version (see FormerDirection, FormerColor, FormerSupersampling). The
 * command does not record when, where or by whom the picture was rendered, so a picture that is
 * rendered again from its text is the same file.
 */

#ifndef Recipe_h
#define Recipe_h

#include "Options.h"
#include "WritePicture.h"

namespace CLI
{
class App;
}

namespace lambent::command
{

class VtkMessages;

/// The command that was parsed, without size and supersampling.
std::string MakeRecipe(const CLI::App& app, const Options& options);

/// The texts for the file of a picture rendered with these options; empty if it was not rendered.
PictureText DescribeDrawing(const Options& options);

/// The supersampling of the picture in a file; FormerSupersampling if it does not say.
int RecordedSupersampling(const std::string& path);

/// The words of a command, split as a shell would.
std::vector<std::string> SplitWords(const std::string& command);

/// Reads the options in the text of the picture `options.recreate`. The output, passes, threads and
/// verbosity are taken from `options`; without an output, the result is to be compared with that
/// picture. Throws Failure.
Options ReadRecipe(const Options& options);

} // namespace lambent::command

#endif
