// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ParseObj.h"
#include "ObjIndices.h"
#include "SplitPoints.h"
#include "TextCursor.h"
#include "TextNumber.h"

#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace lambent::command
{
namespace
{

/// The ids that a corner of a face, line or point element names, or NoKey.
struct Corner
{
  std::int32_t point;
  std::int32_t texture;
  std::int32_t normal;
};

class ObjParser
{
public:
  explicit ObjParser(std::string_view text)
    : Cursor(text)
  {
  }

  ObjContent Parse(const std::function<void(double)>& progress);

private:
  void ParseLine(std::string_view keyword);
  int TakeNumbers(double* values, int least, int most, const char* what);
  float ToFloat(double value) const;
  void ParsePoint();
  void ParseTextureCoordinate();
  void ParseNormal();
  void ParseSmoothing();
  void ParseMaterial();
  Corner TakeCorner();
  bool TakeCell(CellLists& cells, std::size_t least);
  void ParseFace();

  TextCursor Cursor;
  ObjContent Content;
  ObjIndices PointIndices{ "point", "v" };
  ObjIndices TextureIndices{ "texture coordinate", "vt" };
  ObjIndices NormalIndices{ "normal", "vn" };
  std::vector<Corner> Corners; ///< of the current line
  std::unordered_map<std::int64_t, std::int32_t> GroupOfNumber;
  std::unordered_map<std::string, std::int32_t> NumberOfMaterial;
  std::int32_t Group = 0;
  bool HasGroups = false;
  std::int32_t Material = ObjMaterials::none;
};

ObjContent ObjParser::Parse(const std::function<void(double)>& progress)
{
  constexpr std::size_t linesBetweenProgress = 65536;
  for (std::size_t line = 1; !this->Cursor.IsAtEnd(); ++line)
  {
    this->Cursor.SkipBlanks();
    if (!this->Cursor.IsAtLineEnd())
    {
      this->ParseLine(this->Cursor.TakeWord());
    }
    this->Cursor.NextLine();
    if (line % linesBetweenProgress == 0)
    {
      progress(this->Cursor.Fraction());
    }
  }
  this->PointIndices.CheckAll();
  this->TextureIndices.CheckAll();
  this->NormalIndices.CheckAll();
  return std::move(this->Content);
}

/// Other lines (names of groups, free-form geometry) are skipped.
void ObjParser::ParseLine(std::string_view keyword)
{
  if (keyword == "v")
  {
    this->ParsePoint();
  }
  else if (keyword == "vt")
  {
    this->ParseTextureCoordinate();
  }
  else if (keyword == "vn")
  {
    this->ParseNormal();
  }
  else if (keyword == "f" || keyword == "fo") // old files have "fo"
  {
    this->ParseFace();
  }
  else if (keyword == "l")
  {
    this->TakeCell(this->Content.lines, 2);
  }
  else if (keyword == "p")
  {
    this->TakeCell(this->Content.vertices, 1);
  }
  else if (keyword == "s")
  {
    this->ParseSmoothing();
  }
  else if (keyword == "usemtl")
  {
    this->ParseMaterial();
  }
  else if (keyword == "mtllib")
  {
    this->Content.materials.libraries.push_back(this->Cursor.TakeRest());
  }
  else if (keyword == "surf")
  {
    ++this->Content.freeFormSurfaces;
  }
}

/// Reads the numbers up to the end of the line and keeps at most `most`. Returns how many it kept.
int ObjParser::TakeNumbers(double* values, int least, int most, const char* what)
{
  int count = 0;
  this->Cursor.SkipBlanks();
  while (!this->Cursor.IsAtLineEnd())
  {
    const double value = this->Cursor.TakeFiniteNumber();
    if (count < most)
    {
      values[count++] = value;
    }
  }
  if (count < least)
  {
    throw this->Cursor.FailureHere(std::string(what) + " has " + std::to_string(count) +
      (count == 1 ? " number" : " numbers") + " and needs " + std::to_string(least));
  }
  return count;
}

float ObjParser::ToFloat(double value) const
{
  if (std::fabs(value) > static_cast<double>(std::numeric_limits<float>::max()))
  {
    throw this->Cursor.FailureHere("it has a number beyond the range of a float");
  }
  return static_cast<float>(value);
}

/// x y z, x y z w, or x y z r g b (and perhaps an alpha). The weight w is for free-form geometry.
void ObjParser::ParsePoint()
{
  double values[7];
  const int count = this->TakeNumbers(values, 3, 7, "a point (v)");
  std::vector<float>& colors = this->Content.colors;
  if (count >= 6 || !colors.empty())
  {
    colors.resize(this->Content.points.size(), 1.0f); // earlier points without a colour are white
    for (int i = 3; i < 6; ++i)
    {
      colors.push_back(count >= 6 ? this->ToFloat(values[i]) : 1.0f);
    }
  }
  this->Content.points.insert(this->Content.points.end(), values, values + 3);
  this->PointIndices.Add();
}

/// u, u v or u v w
void ObjParser::ParseTextureCoordinate()
{
  double values[2] = { 0, 0 };
  this->TakeNumbers(values, 1, 2, "a texture coordinate (vt)");
  for (const double value : values)
  {
    this->Content.textureCoordinates.push_back(this->ToFloat(value));
  }
  this->TextureIndices.Add();
}

void ObjParser::ParseNormal()
{
  double values[3];
  this->TakeNumbers(values, 3, 3, "a normal (vn)");
  for (const double value : values)
  {
    this->Content.normals.push_back(this->ToFloat(value));
  }
  this->NormalIndices.Add();
}

/// A number from 1 or "on"; anything else is "off".
void ObjParser::ParseSmoothing()
{
  this->Cursor.SkipBlanks();
  std::int64_t number = 0;
  if (ReadInteger(this->Cursor.Position(), number) == this->Cursor.Position())
  {
    number = this->Cursor.TakeWord() == "on";
  }
  this->HasGroups = true;
  this->Group = 0;
  if (number > 0)
  {
    const auto [found, isNew] =
      this->GroupOfNumber.emplace(number, this->Content.numberOfGroups + 1);
    this->Content.numberOfGroups += isNew;
    this->Group = found->second;
  }
}

/// Without a name, faces have no material from here on.
void ObjParser::ParseMaterial()
{
  std::vector<std::string>& names = this->Content.materials.names;
  const std::string name = this->Cursor.TakeRest();
  const auto [found, isNew] =
    this->NumberOfMaterial.emplace(name, static_cast<std::int32_t>(names.size()));
  this->Material = name.empty() ? ObjMaterials::none : found->second;
  if (isNew)
  {
    names.push_back(name);
  }
}

/// v, v/, v//, v/t, v/t/, v//n or v/t/n
Corner ObjParser::TakeCorner()
{
  std::int64_t index[3] = { 0, 0, 0 };
  bool isThere[3] = { false, false, false };
  const char* at = this->Cursor.Position();
  for (int i = 0; i < 3; ++i)
  {
    const char* const behind = ReadInteger(at, index[i]);
    isThere[i] = behind != at;
    at = behind;
    if (*at != '/' || i == 2)
    {
      break;
    }
    ++at;
  }
  if (!isThere[0] || !this->Cursor.IsBehindNumber(at))
  {
    throw this->Cursor.FailureHere("found " + this->Cursor.QuotedWord() +
      " where a corner like 1, 1/1, 1//1 or 1/1/1 is expected");
  }
  const std::size_t line = this->Cursor.Line();
  this->Cursor.MoveTo(at);
  this->Cursor.SkipBlanks();
  return { this->PointIndices.Resolve(index[0], line),
    isThere[1] ? this->TextureIndices.Resolve(index[1], line) : NoKey,
    isThere[2] ? this->NormalIndices.Resolve(index[2], line) : NoKey };
}

/// Reads the corners up to the end of the line. If there are too few, skips the cell and returns
/// false.
bool ObjParser::TakeCell(CellLists& cells, std::size_t least)
{
  this->Corners.clear();
  this->Cursor.SkipBlanks();
  while (!this->Cursor.IsAtLineEnd())
  {
    this->Corners.push_back(this->TakeCorner());
  }
  if (this->Corners.size() < least)
  {
    ++this->Content.cellsOfTooFewPoints;
    return false;
  }
  for (const Corner& corner : this->Corners)
  {
    cells.points.push_back(corner.point);
  }
  cells.EndCell();
  return true;
}

/// Appends the keys of the corners. The list stays empty until the first key that is not NoKey.
void Append(std::vector<std::int32_t>& keys, const std::vector<Corner>& corners,
  std::int32_t Corner::*key, std::size_t cornersBefore)
{
  bool isNeeded = !keys.empty();
  for (const Corner& corner : corners)
  {
    isNeeded = isNeeded || corner.*key != NoKey;
  }
  if (!isNeeded)
  {
    return;
  }
  keys.resize(cornersBefore, NoKey);
  for (const Corner& corner : corners)
  {
    keys.push_back(corner.*key);
  }
}

void ObjParser::ParseFace()
{
  CellLists& faces = this->Content.faces;
  const std::size_t facesBefore = faces.size();
  const std::size_t cornersBefore = faces.points.size();
  if (!this->TakeCell(faces, 3))
  {
    return;
  }
  Append(this->Content.textureOfCorner, this->Corners, &Corner::texture, cornersBefore);
  Append(this->Content.normalOfCorner, this->Corners, &Corner::normal, cornersBefore);
  if (this->HasGroups)
  {
    this->Content.groupOfFace.resize(facesBefore, 0);
    this->Content.groupOfFace.push_back(this->Group);
  }
  std::vector<std::int32_t>& materials = this->Content.materials.ofFace;
  if (this->Material != ObjMaterials::none || !materials.empty())
  {
    materials.resize(facesBefore, ObjMaterials::none);
    materials.push_back(this->Material);
  }
}

} // namespace

ObjContent ParseObj(std::string_view text, const std::function<void(double)>& progress)
{
  return ObjParser(text).Parse(progress);
}

} // namespace lambent::command
