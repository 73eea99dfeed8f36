// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief how a picture was drawn, in the text of its PNG file, and back
 *
 * Two texts: the version of the image contract, and the command that draws the picture
 * again. The command has the inputs and the options about the scene as they were
 * typed, in a fixed order and quoted for the shell, and the side from which it was drawn
 * even if it was not said, since its default has changed once: a command that names none is of
 * an older version (FormerDirection). It has nothing about when, where or by whom.
 * So a picture that is drawn again from its text is the same file.
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

/// The command, without the size, that was parsed.
std::string MakeRecipe(const CLI::App& app, const Options& options);

/// What belongs into the file of a picture that was drawn so; nothing if it was not drawn.
PictureText DescribeDrawing(const Options& options);

/// The words of a command, as a shell would see them.
std::vector<std::string> SplitWords(const std::string& command);

/// The options that the text of the picture `options.recreate` tells, to be drawn for what
/// else the options ask: into a file, or to be compared with that picture. Throws Failure.
Options ReadRecipe(const Options& options);

} // namespace lambent::command

#endif
