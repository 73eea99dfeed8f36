// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Recipe.h"
#include "Messages.h"
#include "SurfaceOptions.h"

#include "vtkLambentPNGReader.h"
#include "vtkLambentRayTracer.h"

#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <set>

namespace lambent::command
{
namespace
{

const char* const ContractKey = "Lambent image contract";
const char* const CommandKey = "Lambent command";

/// The word, quoted for a POSIX shell if necessary.
std::string Quoted(const std::string& word)
{
  bool isPlain = !word.empty();
  std::string quoted = "'";
  for (const char c : word)
  {
    isPlain =
      isPlain && (std::isalnum(static_cast<unsigned char>(c)) || std::strchr("_./,:=+@-", c));
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return isPlain ? word : quoted + "'";
}

std::string TextOf(const Triple& direction)
{
  char text[100];
  std::snprintf(text, sizeof(text), "%g,%g,%g", direction[0], direction[1], direction[2]);
  return text;
}

bool HasOption(const std::vector<std::string>& words, const std::string& option)
{
  return std::any_of(words.begin(), words.end(),
    [&option](const std::string& word) { return word.rfind(option, 0) == 0; });
}

/// Parses the command stored in a picture.
Options ParseRecipe(const std::string& command)
{
  std::vector<std::string> words = SplitWords(command);
  if (words.empty() || words.front() != "lambent")
  {
    throw Failure("its command is not a lambent command: " + OneLine(command));
  }
  // Written by an older version.
  if (!HasOption(words, "--direction") && !HasOption(words, "--camera-position"))
  {
    words.insert(words.end(), { "--direction", TextOf(FormerDirection) });
  }
  if (!HasOption(words, "--color")) // nor --color-by, which always comes with it
  {
    words.insert(words.end(), { "--color", FormerColor });
  }
  if (!HasOption(words, "--supersampling"))
  {
    words.insert(words.end(), { "--supersampling", std::to_string(FormerSupersampling) });
  }
  words.insert(words.end(), { "-o", "-" }); // the parser requires an output
  std::vector<const char*> argv;
  for (const std::string& word : words)
  {
    argv.push_back(word.c_str());
  }
  const Parsed parsed = ParseOptions(static_cast<int>(argv.size()), argv.data(), "");
  if (parsed.exitStatus || parsed.options.recipe.empty())
  {
    throw Failure("its command is invalid: " + OneLine(command));
  }
  return parsed.options;
}

} // namespace

std::string MakeRecipe(const CLI::App& app, const Options& options)
{
  static const std::set<std::string> notOfTheScene = { "INPUT", "--help", "--output", "--size",
    "--supersampling", "--compare", "--metric", "--tolerance", "--difference", "--report", "--name",
    "--recreate", "--light", "--headlight", "--pass", "--threads", "--quiet", "--verbose",
    "--version" };
  std::string recipe = "lambent";
  for (const std::string& input : options.inputs)
  {
    recipe += " " + Quoted(input);
  }
  for (const CLI::Option* option : app.get_options())
  {
    const std::string name = option->get_single_name();
    const std::string full = option->get_positional() ? name : "--" + name;
    if (option->count() > 0 && notOfTheScene.count(full) == 0)
    {
      const bool isFlag = option->get_items_expected() == 0;
      recipe += " " + full + (isFlag ? "" : " " + Quoted(option->results().back()));
    }
    else if (full == "--color")
    {
      recipe += " --color " + std::string(ColorsOfFiles);
    }
    else if (full == "--direction" && !options.direction && !options.cameraPosition)
    {
      recipe += " " + full + " " + TextOf(DefaultDirection);
    }
  }
  for (const LightValue& light : options.lights)
  {
    recipe +=
      light.kind == LightValue::Kind::Headlight ? " --headlight" : " --light " + Quoted(light.text);
  }
  return recipe;
}

PictureText DescribeDrawing(const Options& options)
{
  if (options.recipe.empty())
  {
    return {};
  }
  const std::string size =
    std::to_string((*options.size)[0]) + "x" + std::to_string((*options.size)[1]);
  return { { ContractKey, std::to_string(vtkLambentRayTracer::GetImageContractVersion()) },
    { CommandKey,
      options.recipe + " --size " + size + " --supersampling " +
        std::to_string(*options.supersampling) } };
}

std::vector<std::string> SplitWords(const std::string& command)
{
  std::vector<std::string> words;
  bool isQuoted = false, isInWord = false;
  for (std::size_t k = 0; k < command.size(); ++k)
  {
    const char c = command[k];
    if (!isQuoted && c == ' ')
    {
      isInWord = false;
      continue;
    }
    if (!isInWord)
    {
      words.emplace_back();
      isInWord = true;
    }
    if (c == '\'')
    {
      isQuoted = !isQuoted;
    }
    else if (!isQuoted && c == '\\' && k + 1 < command.size())
    {
      words.back() += command[++k];
    }
    else
    {
      words.back() += c;
    }
  }
  return words;
}

int RecordedSupersampling(const std::string& path)
{
  vtkNew<vtkLambentPNGReader> reader;
  reader->SetFileName(path.c_str());
  const char* const command = reader->Read() ? reader->GetText(CommandKey) : nullptr;
  try
  {
    return command ? *ParseRecipe(command).supersampling : FormerSupersampling;
  }
  catch (const Failure&)
  {
    return FormerSupersampling;
  }
}

Options ReadRecipe(const Options& options)
{
  const std::string& path = options.recreate;
  try
  {
    vtkNew<vtkLambentPNGReader> reader;
    reader->SetFileName(path.c_str());
    if (!reader->Read())
    {
      throw Failure(reader->GetMessage());
    }
    const char *const contract = reader->GetText(ContractKey),
                      *const command = reader->GetText(CommandKey);
    if (!contract || !command)
    {
      throw Failure(
        "it does not store the command that rendered it; only PNG files of this command do");
    }
    const std::string ours = std::to_string(vtkLambentRayTracer::GetImageContractVersion());
    if (contract != ours && !options.quiet)
    {
      Say("warning: '" + path + "' was rendered under image contract " + OneLine(contract) +
        ", but this version has " + ours + "; bits may differ");
    }
    Options drawing = ParseRecipe(command);
    drawing.output = options.output;
    drawing.passes = options.passes;
    drawing.comparison = ComparisonOptions();
    if (options.output.empty())
    {
      drawing.comparison.baseline = path;
    }
    drawing.threads = options.threads;
    drawing.quiet = options.quiet;
    drawing.verbose = options.verbose;
    return drawing;
  }
  catch (const Failure& reason)
  {
    throw Failure("cannot recreate '" + path + "': " + reason.what());
  }
}

} // namespace lambent::command
