// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ComparisonOptions.h"
#include "AddValue.h"
#include "FileKinds.h"
#include "FilmOptions.h"
#include "Messages.h"

namespace lambent::command
{
namespace
{

const char* const Description =
  "Compares two pictures, exactly or within a tolerance, and reports the differences.";

const char* const Footer = R"(
Reads .png and .vti. With LAMBENT_UPDATE_BASELINES=1 in the environment a picture that differs, or
has no baseline yet, becomes the baseline.

Exit status: 0 the same, 1 different or cannot be compared, 2 wrong usage.

Example: lambent compare drawn.png expected.png --difference difference.png)";

Metric ParseMetric(const std::string& text)
{
  if (text == "max")
  {
    return Metric::MaximumDifference;
  }
  if (text == "rmse")
  {
    return Metric::RootMeanSquare;
  }
  return text == "ssim" ? Metric::StructuralSimilarity
                        : throw BadValue("'" + text + "' is not max, rmse or ssim");
}

std::string IsPage(const std::string& path)
{
  const std::size_t dot = path.rfind('.');
  const std::string extension = dot == std::string::npos ? "" : path.substr(dot);
  return extension == ".html" || extension == ".htm" ? "" : "'" + path + "' does not end in .html";
}

} // namespace

std::string IsComparable(const std::string& path)
{
  const auto kind = PictureKindOf(path);
  return kind == PictureKind::Png || kind == PictureKind::Vti
    ? ""
    : "'" + path + "' does not end in .png or .vti, the kinds that can be compared";
}

void AddComparison(CLI::App& app, ComparisonOptions& options, CLI::Option* compare)
{
  const auto notNegative = [](const std::string& text) { return ParseNotNegative(text); };
  CLI::Option* const all[] = {
    AddValue(app, "--metric", "max|rmse|ssim", options.metric, ParseMetric,
      "largest difference of a channel, root mean square, or 1 - structural similarity [max]"),
    AddValue(app, "--tolerance", "T", options.tolerance, notNegative,
      "largest permitted value of the metric; channels go to 255 [0: no bit may differ]"),
    app.add_option("--difference", options.difference, "picture of the difference to write")
      ->type_name("FILE")
      ->check(IsPicture),
    app.add_option("--report", options.report, "HTML page to write or append to")
      ->type_name("FILE")
      ->check(IsPage),
    app.add_option("--name", options.name, "title in the report [the file]")->type_name("TEXT"),
  };
  for (CLI::Option* option : all)
  {
    if (compare)
    {
      option->needs(compare);
    }
  }
}

Parsed ParseCompareOptions(int argc, const char* const* argv)
{
  Parsed parsed;
  Options& options = parsed.options;
  CLI::App app(Description, "lambent compare");
  app.footer(Footer);
  app.add_option("PICTURE", options.picture, "the picture to check")
    ->required()
    ->type_name("")
    ->check(IsComparable);
  app.add_option("BASELINE", options.comparison.baseline, "the expected picture")
    ->required()
    ->type_name("")
    ->check(IsComparable);
  AddComparison(app, options.comparison, nullptr);
  app.add_flag("--quiet", options.quiet, "print nothing if they are the same");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::CallForHelp&)
  {
    parsed.exitStatus = 0;
    parsed.standardOutput = app.help();
  }
  catch (const CLI::ParseError& error)
  {
    parsed.exitStatus = 2;
    parsed.standardError =
      "lambent: " + OneLine(error.what()) + "\nTry 'lambent compare --help'.\n";
  }
  return parsed;
}

} // namespace lambent::command
