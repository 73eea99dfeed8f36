// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ParseStlText.h"
#include "TextCursor.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace lambent::command
{
namespace
{

bool IsWord(std::string_view word, std::string_view keyword)
{
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

class StlTextParser
{
public:
  explicit StlTextParser(std::string_view text)
    : Cursor(text)
  {
  }

  StlText Parse(const std::function<void(double)>& progress);

private:
  bool Take(std::string_view keyword);
  void Require(std::string_view keyword);
  void SkipNormal();
  void ParseFacet();
  Failure NotDue(const std::string& due) const;

  TextCursor Cursor;
  StlText Content;
};

/// If the next word is the keyword, moves to the word after it and returns true.
bool StlTextParser::Take(std::string_view keyword)
{
  const char* const begin = this->Cursor.Position();
  if (!IsWord(this->Cursor.TakeWord(), keyword))
  {
    this->Cursor.MoveTo(begin);
    return false;
  }
  this->Cursor.SkipSpace();
  return true;
}

Failure StlTextParser::NotDue(const std::string& due) const
{
  return this->Cursor.IsAtEnd()
    ? this->Cursor.FailureHere("it is incomplete: it ends where " + due + " is expected")
    : this->Cursor.FailureHere(
        "found " + this->Cursor.QuotedWord() + " where " + due + " is expected");
}

void StlTextParser::Require(std::string_view keyword)
{
  if (!this->Take(keyword))
  {
    throw this->NotDue("'" + std::string(keyword) + "'");
  }
}

bool IsKeyword(std::string_view word)
{
  const std::string_view keywords[] = { "facet", "loop", "vertex", "endloop", "endfacet",
    "endsolid" };
  return std::any_of(std::begin(keywords), std::end(keywords),
    [word](std::string_view keyword) { return IsWord(word, keyword); });
}

/// Moves past the words "outer loop".
void StlTextParser::SkipNormal()
{
  constexpr int mostWords = 8; // "normal", three numbers, and some more for invalid ones
  for (int i = 0; !this->Take("outer"); ++i)
  {
    const char* const begin = this->Cursor.Position();
    const std::string_view word = this->Cursor.TakeWord();
    if (word.empty() || IsKeyword(word) || i == mostWords)
    {
      this->Cursor.MoveTo(begin);
      throw this->NotDue("'outer loop'");
    }
    this->Cursor.SkipSpace();
  }
  this->Require("loop");
}

void StlTextParser::ParseFacet()
{
  this->SkipNormal();
  std::size_t corners = 0;
  for (; this->Take("vertex"); ++corners)
  {
    double point[3];
    for (double& coordinate : point)
    {
      coordinate = this->Cursor.TakeNumber();
    }
    this->Cursor.SkipSpace();
    this->Content.facets.points.push_back(this->Content.points.Add(point));
  }
  if (corners < 3)
  {
    throw this->NotDue("'vertex'");
  }
  this->Require("endloop");
  this->Require("endfacet");
  this->Content.facets.EndCell();
}

StlText StlTextParser::Parse(const std::function<void(double)>& progress)
{
  constexpr std::size_t facetsBetweenProgress = 16384;
  bool isInSolid = true; // some files lack the first "solid"
  this->Cursor.SkipSpace();
  while (!this->Cursor.IsAtEnd())
  {
    const char* const begin = this->Cursor.Position();
    const std::string_view word = this->Cursor.TakeWord();
    if (IsWord(word, "facet"))
    {
      this->Cursor.SkipSpace();
      this->ParseFacet();
      if (this->Content.facets.size() % facetsBetweenProgress == 0)
      {
        progress(this->Cursor.Fraction());
      }
      continue; // ParseFacet() has skipped the space
    }
    const bool isSolid = IsWord(word, "solid");
    if (!isSolid && !IsWord(word, "endsolid"))
    {
      this->Cursor.MoveTo(begin);
      if (isInSolid)
      {
        throw this->NotDue("'facet' or 'endsolid'");
      }
      this->Content.ignoredFrom = this->Cursor.Line();
      break;
    }
    isInSolid = isSolid;
    this->Cursor.NextLine(); // skip the name
    this->Cursor.SkipSpace();
  }
  if (isInSolid)
  {
    throw this->NotDue("'facet' or 'endsolid'");
  }
  return std::move(this->Content);
}

} // namespace

bool IsStlText(std::string_view file)
{
  constexpr std::size_t nearStart = 1024; // a binary file has its count there, with zero bytes
  if (file.substr(0, nearStart).find('\0') != std::string_view::npos)
  {
    return false;
  }
  TextCursor cursor(file);
  cursor.SkipSpace();
  const std::string_view word = cursor.TakeWord();
  return IsWord(word, "solid") || IsWord(word, "facet");
}

StlText ParseStlText(std::string_view text, const std::function<void(double)>& progress)
{
  return StlTextParser(text).Parse(progress);
}

} // namespace lambent::command
