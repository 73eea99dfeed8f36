// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckEnSight.h"
#include "EnSightFile.h"
#include "EnSightWalk.h"
#include "Messages.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>

namespace lambent::command
{
namespace
{

struct Variable
{
  std::string name;
  std::string file;
  bool isAtPoints;
  int components;
};

/// The files named by a case file.
struct Case
{
  bool isGold = false;
  std::string geometry;
  std::vector<Variable> variables;
};

bool IsNumber(const std::string& word)
{
  return std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c); });
}

/// Parses a line such as "scalar per node: pressure file". The name may follow the numbers of a
/// time set and a file set.
void AddVariable(Case& all, const std::vector<std::string>& words)
{
  static const std::map<std::string, int> kinds{ { "scalar per ", 1 }, { "vector per ", 3 },
    { "tensor symm per ", 6 }, { "tensor asym per ", 9 } };
  std::string kind;
  for (const std::string& word : words)
  {
    const auto found = kinds.find(kind);
    if (found != kinds.end() && (word == "node:" || word == "element:") && words.size() > 2)
    {
      all.variables.push_back(
        { words[words.size() - 2], words.back(), word == "node:", found->second });
      return;
    }
    kind += word + " ";
  }
}

Case ReadCase(const std::string& path)
{
  Case all;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    const std::vector<std::string> words = WordsOf(line);
    if (words.size() < 2)
    {
      continue;
    }
    if (words[0] == "type:")
    {
      all.isGold = words.back() == "gold";
    }
    else if (words[0] == "model:")
    {
      const auto found = std::find_if_not(words.begin() + 1, words.end(), IsNumber);
      all.geometry = found == words.end() ? words[1] : *found;
    }
    else
    {
      AddVariable(all, words);
    }
  }
  return all;
}

/// Calls walk(file) if the file exists. Returns false if the file is truncated.
template <typename Visit>
bool IsWhole(const std::filesystem::path& path, EnSightEncoding encoding, Visit&& walk)
{
  const auto file = EnSightFile::Open(path.string(), encoding);
  try
  {
    if (file)
    {
      walk(*file);
    }
  }
  catch (const EndOfEnSightFile&)
  {
    return false;
  }
  catch (const EnSightNotUnderstood&)
  {
  }
  return true;
}

} // namespace

std::vector<BrokenVariable> CheckEnSight(const std::string& casePath)
{
  const Case all = ReadCase(casePath);
  const auto folder = std::filesystem::path(casePath).parent_path();
  const std::string geometry = (folder / all.geometry).string();
  const EnSightEncoding encoding = EncodingOfEnSight(geometry);
  const auto isOneOfMany = [](const std::string& name) // a file for each time step
  { return name.find('*') != std::string::npos; };
  if (!all.isGold || isOneOfMany(all.geometry) || encoding == EnSightEncoding::Other)
  {
    return {};
  }
  EnSightParts parts;
  if (!IsWhole(geometry, encoding,
        [&](EnSightFile& file)
        {
          if (encoding == EnSightEncoding::Binary)
          {
            file.TakeDescription(); // "C Binary"
          }
          parts = WalkEnSightGeometry(file);
        }))
  {
    throw Failure("its geometry file '" + all.geometry + "' is incomplete; use a complete copy");
  }
  std::vector<BrokenVariable> broken;
  for (const Variable& variable : all.variables)
  {
    if (!parts.empty() && !isOneOfMany(variable.file) &&
      !IsWhole(folder / variable.file, encoding,
        [&](EnSightFile& file)
        { WalkEnSightVariable(file, parts, variable.isAtPoints, variable.components); }))
    {
      broken.push_back({ variable.isAtPoints, variable.name, variable.file });
    }
  }
  return broken;
}

} // namespace lambent::command
