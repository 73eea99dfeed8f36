// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ParseMtl.h"
#include "TextCursor.h"
#include "TextNumber.h"

#include <algorithm>

namespace lambent::command
{
namespace
{

class MtlParser
{
public:
  explicit MtlParser(std::string_view text)
    : Cursor(text)
  {
  }

  std::vector<Material> Parse();

private:
  void ParseLine(const std::string& keyword);
  void ParseNumber(const std::string& keyword);
  std::optional<std::array<double, 3>> TakeColor();
  bool IsAtNumber() const;
  void TakeNumbers(std::array<double, 2>& values);
  void ParseImage();

  TextCursor Cursor;
  std::vector<Material> Materials;
};

std::vector<Material> MtlParser::Parse()
{
  while (!this->Cursor.IsAtEnd())
  {
    this->Cursor.SkipBlanks();
    if (!this->Cursor.IsAtLineEnd())
    {
      this->ParseLine(std::string(this->Cursor.TakeWord()));
    }
    this->Cursor.NextLine();
  }
  return std::move(this->Materials);
}

void MtlParser::ParseLine(const std::string& keyword)
{
  if (keyword == "newmtl")
  {
    this->Materials.emplace_back();
    this->Materials.back().name = this->Cursor.TakeRest();
  }
  else if (this->Materials.empty())
  {
    return;
  }
  else if (keyword == "Kd")
  {
    this->Materials.back().diffuse = this->TakeColor();
  }
  else if (keyword == "Ka")
  {
    this->Materials.back().ambient = this->TakeColor();
  }
  else if (keyword == "Ks")
  {
    this->Materials.back().specular = this->TakeColor();
  }
  else if (keyword == "map_Kd")
  {
    this->ParseImage();
  }
  else
  {
    this->ParseNumber(keyword);
  }
}

void MtlParser::ParseNumber(const std::string& keyword)
{
  Material& material = this->Materials.back();
  const auto take = [this](double largest)
  {
    this->Cursor.SkipBlanks();
    TextCursor behind = this->Cursor;
    if (behind.TakeWord() == "-halo") // more transparent where it faces the viewer; not supported
    {
      this->Cursor = behind;
      this->Cursor.SkipBlanks();
    }
    return std::clamp(this->Cursor.TakeFiniteNumber(), 0.0, largest);
  };
  if (keyword == "Ns")
  {
    material.specularPower = take(128);
  }
  else if (keyword == "d")
  {
    material.opacity = take(1);
  }
  else if (keyword == "Tr")
  {
    material.transparency = take(1);
  }
  else if (keyword == "illum")
  {
    material.hasHighlights = take(10) >= 2;
  }
}

/// Empty if it is not a list of numbers.
std::optional<std::array<double, 3>> MtlParser::TakeColor()
{
  this->Cursor.SkipBlanks();
  if (this->Cursor.QuotedWord() == "'spectral'" || this->Cursor.QuotedWord() == "'xyz'")
  {
    return std::nullopt;
  }
  std::array<double, 3> color;
  color.fill(this->Cursor.TakeFiniteNumber());
  for (std::size_t k = 1; k < 3 && !this->Cursor.IsAtLineEnd(); ++k)
  {
    color[k] = this->Cursor.TakeFiniteNumber();
  }
  for (double& channel : color)
  {
    channel = std::clamp(channel, 0.0, 1.0);
  }
  return color;
}

bool MtlParser::IsAtNumber() const
{
  TextCursor ahead = this->Cursor;
  const std::string_view word = ahead.TakeWord();
  double value = 0;
  const char* const behind = ReadNumber(word.data(), word.data() + word.size(), value);
  return !word.empty() && behind == word.data() + word.size();
}

/// Reads up to three numbers, of which the first two are kept.
void MtlParser::TakeNumbers(std::array<double, 2>& values)
{
  for (std::size_t k = 0; k < 3 && this->IsAtNumber(); ++k)
  {
    const double value = this->Cursor.TakeFiniteNumber();
    if (k < values.size())
    {
      values[k] = value;
    }
  }
}

/// The options and the file name, which may contain spaces.
void MtlParser::ParseImage()
{
  Material& material = this->Materials.back();
  std::array<double, 2> unused;
  for (this->Cursor.SkipBlanks(); *this->Cursor.Position() == '-'; this->Cursor.SkipBlanks())
  {
    const TextCursor before = this->Cursor;
    const std::string option(this->Cursor.TakeWord());
    this->Cursor.SkipBlanks();
    if (option == "-s")
    {
      this->TakeNumbers(material.scale);
    }
    else if (option == "-o")
    {
      this->TakeNumbers(material.offset);
    }
    else if (option == "-t" || option == "-mm" || option == "-bm" || option == "-boost" ||
      option == "-texres")
    {
      this->TakeNumbers(unused);
    }
    else if (option == "-clamp")
    {
      material.isClamped = this->Cursor.TakeWord() == "on";
    }
    else if (option == "-blendu" || option == "-blendv" || option == "-cc" || option == "-imfchan")
    {
      this->Cursor.TakeWord();
    }
    else
    {
      this->Cursor = before; // a file name that begins with a minus
      break;
    }
  }
  material.image = this->Cursor.TakeRest();
}

} // namespace

std::vector<Material> ParseMtl(std::string_view text)
{
  return MtlParser(text).Parse();
}

} // namespace lambent::command
