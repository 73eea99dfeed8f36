// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilmOptions.h"
#include "AddValue.h"
#include "FileKinds.h"

#include <set>

namespace lambent::command
{

std::string IsPicture(const std::string& path)
{
  return PictureKindOf(path) ? "" : "'" + path + "' does not end in one of " + PictureExtensions();
}

void AddFilm(CLI::App& app, Options& options)
{
  CLI::Option* background = AddValue(app, "--background", "COLOUR", options.background, ParseColor,
    "colour where there is no surface [black]");
  CLI::Option* image = app
                         .add_option("--background-image", options.backgroundImage,
                           "picture behind the surfaces, stretched to the whole picture")
                         ->type_name("FILE")
                         ->check(IsPicture);
  app
    .add_flag("--alpha", options.alpha,
      "transparent where there is no surface, for .png .tif .vti; edges keep their colour")
    ->excludes(background)
    ->excludes(image);
  AddValue(app, "--pass", "NAME[=FILE]", options.passes, ParsePass,
    "data to store in addition to the picture, see below; repeatable");
}

void CheckFilm(const Options& options)
{
  if (options.alpha && !WhyNoAlpha(options.output).empty())
  {
    throw CLI::ValidationError("--alpha", WhyNoAlpha(options.output));
  }
  std::set<std::string> names;
  for (const PassValue& pass : options.passes)
  {
    if (!names.insert(pass.array).second)
    {
      throw CLI::ValidationError("--pass",
        "'" + pass.array +
          "' is requested twice, but the picture can hold only one array of that name; omit one");
    }
    if (pass.file.empty() && PictureKindOf(options.output) != PictureKind::Vti)
    {
      if (PictureKindOf(pass.text))
      {
        throw CLI::ValidationError("--pass",
          "'" + pass.text +
            "' is only a file; name the pass to store in it, such as depth=" + pass.text);
      }
      throw CLI::ValidationError("--pass",
        "'" + pass.text + "' needs a file, such as " + pass.text +
          "=FILE.tif; only a .vti picture can hold passes itself");
    }
  }
}

} // namespace lambent::command
