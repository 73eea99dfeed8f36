// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EnSightWalk.h"
#include "EnSightFile.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace lambent::command
{
namespace
{

bool Has(const std::vector<std::string>& words, const char* word)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Throws for an unknown word: at the end of the file it is a truncated one.
[[noreturn]] void ThrowUnknown(EnSightFile& file)
{
  if (file.IsAtEnd())
  {
    throw EndOfEnSightFile();
  }
  throw EnSightNotUnderstood();
}

/// The number of points of an element; 0 for polygons and polyhedra, -1 for unknown types.
int PointsOf(std::string type)
{
  static const std::map<std::string, int> points{ { "point", 1 }, { "bar2", 2 }, { "bar3", 3 },
    { "tria3", 3 }, { "tria6", 6 }, { "quad4", 4 }, { "quad8", 8 }, { "tetra4", 4 },
    { "tetra10", 10 }, { "pyramid5", 5 }, { "pyramid13", 13 }, { "penta6", 6 }, { "penta15", 15 },
    { "hexa8", 8 }, { "hexa20", 20 }, { "nsided", 0 }, { "nfaced", 0 } };
  type.erase(0, type.rfind("g_", 0) == 0 ? 2 : 0); // ghost elements
  const auto found = points.find(type);
  return found == points.end() ? -1 : found->second;
}

/// Walks through a geometry file. Throws EndOfEnSightFile or EnSightNotUnderstood.
class GeometryWalk
{
public:
  explicit GeometryWalk(EnSightFile& file)
    : File(file)
  {
  }

  EnSightParts Run()
  {
    this->File.TakeDescription();
    this->File.TakeDescription();
    this->HasPointIds = this->TakeIsListed();
    this->HasElementIds = this->TakeIsListed();
    while (!this->File.IsAtEnd())
    {
      const std::string keyword = this->File.TakeLine();
      if (keyword.rfind("part", 0) == 0)
      {
        this->Part = &this->Parts[this->File.TakePartNumber()];
        this->File.TakeDescription();
      }
      else if (keyword.rfind("extents", 0) == 0)
      {
        this->File.SkipRows(3, 2);
      }
      else if (keyword.rfind("coordinates", 0) == 0)
      {
        const std::int64_t count = this->File.TakeCount();
        this->Part->points = count;
        this->File.SkipRows(this->HasPointIds ? count : 0, 1);
        this->File.SkipRows(3 * count, 1);
      }
      else if (keyword.rfind("block", 0) == 0)
      {
        this->SkipBlock(WordsOf(keyword));
      }
      else
      {
        this->SkipElements(keyword);
      }
    }
    return std::move(this->Parts);
  }

private:
  /// Whether ids are listed, from a line such as "node id given".
  bool TakeIsListed()
  {
    const std::vector<std::string> words = WordsOf(this->File.TakeLine());
    return Has(words, "given") || Has(words, "ignore");
  }

  void SkipBlock(const std::vector<std::string>& words)
  {
    if (Has(words, "range") || Has(words, "with_ghost") || this->HasPointIds || this->HasElementIds)
    {
      throw EnSightNotUnderstood();
    }
    const std::vector<std::int64_t> size = this->File.TakeCounts(1, 3);
    constexpr std::int64_t mostPoints = std::int64_t(1) << 40; // beyond any real file
    if (size[0] * size[1] > mostPoints || size[0] * size[1] * size[2] > mostPoints)
    {
      throw EnSightNotUnderstood();
    }
    const std::int64_t points = size[0] * size[1] * size[2];
    this->Part->points = points;
    std::int64_t& cells = this->Part->elements["block"] = 1;
    for (const std::int64_t along : size)
    {
      cells *= std::max<std::int64_t>(along - 1, 1);
    }
    this->File.SkipRows(Has(words, "uniform") ? 6
        : Has(words, "rectilinear")           ? size[0] + size[1] + size[2]
                                              : 3 * points,
      1);
    this->File.SkipRows(Has(words, "iblanked") ? points : 0, 1);
  }

  void SkipElements(const std::string& type)
  {
    const int points = PointsOf(type);
    if (points < 0)
    {
      ThrowUnknown(this->File);
    }
    const std::int64_t count = this->File.TakeCount();
    this->Part->elements[type] = count;
    this->File.SkipRows(this->HasElementIds ? count : 0, 1);
    if (points > 0)
    {
      this->File.SkipRows(count, points);
      return;
    }
    std::vector<std::int64_t> corners = this->File.TakeCounts(count, 1);
    if (type.find("nfaced") != std::string::npos) // these were the numbers of faces
    {
      corners =
        this->File.TakeCounts(std::accumulate(corners.begin(), corners.end(), std::int64_t(0)), 1);
    }
    for (const std::int64_t ofFace : corners)
    {
      this->File.SkipRows(1, ofFace);
    }
  }

  EnSightFile& File;
  EnSightParts Parts;
  EnSightPart Nowhere; ///< before the first part
  EnSightPart* Part = &this->Nowhere;
  bool HasPointIds = false, HasElementIds = false;
};

/// The number of values after a keyword in a part; -1 if the keyword is unknown, such as
/// "coordinates undef".
std::int64_t ValuesAt(const EnSightPart& part, const std::string& keyword, bool isAtPoints)
{
  if (isAtPoints)
  {
    return keyword == "coordinates" || keyword == "block" ? part.points : -1;
  }
  const auto found = part.elements.find(keyword);
  return found == part.elements.end() ? -1 : found->second;
}

} // namespace

EnSightParts WalkEnSightGeometry(EnSightFile& file)
{
  return GeometryWalk(file).Run();
}

void WalkEnSightVariable(
  EnSightFile& file, const EnSightParts& parts, bool isAtPoints, int components)
{
  file.TakeDescription();
  const EnSightPart nowhere;
  const EnSightPart* part = &nowhere;
  while (!file.IsAtEnd())
  {
    const std::string keyword = file.TakeLine();
    if (keyword == "part")
    {
      const auto found = parts.find(file.TakePartNumber());
      part = found == parts.end() ? &nowhere : &found->second;
      continue;
    }
    const std::int64_t values = ValuesAt(*part, keyword, isAtPoints);
    if (values < 0 || part == &nowhere)
    {
      ThrowUnknown(file);
    }
    file.SkipRows(components * values, 1);
  }
}

} // namespace lambent::command
