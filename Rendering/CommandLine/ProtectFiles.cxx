// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ProtectFiles.h"
#include "Messages.h"

#include "LambentSameFile.h"

#include <utility>

namespace lambent::command
{
namespace
{

/// Paths and their roles.
using Files = std::vector<std::pair<std::string, std::string>>;

/// The files that the command reads.
Files ReadFiles(const Options& options)
{
  Files files;
  for (const std::string& input : options.inputs)
  {
    files.emplace_back(input, "an input");
  }
  files.emplace_back(options.backgroundImage, "the background image");
  files.emplace_back(options.texture, "the texture");
  files.emplace_back(options.picture, "the picture to compare");
  files.emplace_back(options.comparison.baseline, "the baseline");
  return files;
}

/// The files that the command writes.
Files WrittenFiles(const Options& options)
{
  Files files = { { options.output == "-" ? "" : options.output, "the output" } };
  for (const PassValue& pass : options.passes)
  {
    files.emplace_back(pass.file, "the pass " + pass.text);
  }
  files.emplace_back(options.comparison.difference, "the difference");
  files.emplace_back(options.comparison.report, "the report");
  return files;
}

} // namespace

void ProtectFiles(const Options& options)
{
  const std::string& baseline = options.comparison.baseline;
  if (lambentFiles::isSameFile(options.picture, baseline))
  {
    throw Failure("cannot compare '" + options.picture + "' with " +
      (options.picture == baseline ? "itself" : "'" + baseline + "': they are the same file") +
      "; name two files");
  }
  Files kept = ReadFiles(options);
  for (const auto& [path, what] : WrittenFiles(options))
  {
    for (const auto& [other, role] : kept)
    {
      if (lambentFiles::isSameFile(path, other))
      {
        throw Failure("cannot write '" + path + "': it is " + role +
          (path == other ? "" : ", '" + other + "'") + "; choose another name");
      }
    }
    kept.emplace_back(path, what);
  }
}

} // namespace lambent::command
