// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include <functional>
#include <map>
#include <stdexcept>

Options takeOptions(int& argc, char** argv)
{
  Options options;
  using Value = const std::string&;
  const std::map<std::string, std::function<void(Value)>> known = {
    { "--scene", [&](Value value) { options.scene = value; } },
    { "--contests", [&](Value value) { options.contests = value; } },
    { "--data", [&](Value value) { options.data = value; } },
    { "--cache", [&](Value value) { options.cache = value; } },
    { "--pictures", [&](Value value) { options.pictures = value; } },
    { "--memory", [&](Value value) { options.memory = value; } },
    { "--threads", [&](Value value) { options.threads = std::stoi(value); } },
    { "--seconds", [&](Value value) { options.seconds = std::stod(value); } },
    { "--fewest", [&](Value value) { options.fewest = std::stoi(value); } },
    { "--most", [&](Value value) { options.most = std::stoi(value); } },
    { "--quiet", [&](Value) { options.quiet = true; } },
    { "--list", [&](Value) { options.list = true; } },
  };
  int kept = 1;
  for (int k = 1; k < argc; ++k)
  {
    const std::string argument = argv[k];
    const std::size_t equals = argument.find('=');
    const auto option = known.find(argument.substr(0, equals));
    if (option == known.end())
    {
      argv[kept++] = argv[k];
      continue;
    }
    option->second(equals == std::string::npos ? "" : argument.substr(equals + 1));
  }
  argc = kept;
  if (!options.list && options.scene.empty())
  {
    throw std::invalid_argument("--scene=NAME is missing; --list prints the names");
  }
  if (options.threads < 1 || options.fewest < 1 || options.most < options.fewest)
  {
    throw std::invalid_argument("--threads, --fewest and --most are positive and in order");
  }
  return options;
}
