// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckLegacyVtk.h"
#include "CheckFile.h"
#include "FileBytes.h"
#include "Messages.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <iterator>

namespace lambent::command
{
namespace
{

/// The numbers of a list: text, or four bytes each with the highest first.
class Numbers
{
public:
  Numbers(const char* begin, const char* end, bool isText)
    : At(begin)
    , End(end)
    , IsText(isText)
  {
  }

  bool Next(long long& number)
  {
    if (this->IsText)
    {
      char* end = nullptr;
      number = std::strtoll(this->At, &end, 10);
      const bool isThere = end != this->At;
      this->At = end;
      return isThere;
    }
    if (this->End - this->At < 4)
    {
      return false;
    }
    number = static_cast<signed char>(*this->At);
    for (int i = 1; i < 4; ++i)
    {
      number = 256 * number + static_cast<unsigned char>(this->At[i]);
    }
    this->At += 4;
    return true;
  }

private:
  const char* At;
  const char* End;
  bool IsText;
};

/// Goes through a list of cells that is said to have so many numbers.
void CheckList(Numbers numbers, long long cells, long long size)
{
  long long used = 0;
  for (long long cell = 0; cell < cells; ++cell)
  {
    long long count = 0;
    bool isThere = numbers.Next(count) && count >= 0 && count < size - used;
    for (long long i = 0, id = 0; i < count && isThere; ++i)
    {
      isThere = numbers.Next(id);
    }
    if (!isThere)
    {
      throw Failure("it is cut short or broken at cell " + std::to_string(cell) + " of " +
        std::to_string(cells) + "; get a whole copy of it");
    }
    used += count + 1;
  }
  if (used != size)
  {
    throw Failure("its list of cells has " + std::to_string(used) + " numbers and promises " +
      std::to_string(size) + "; get a whole copy of it");
  }
}

/// If "cells size" follows a keyword, a list begins on the next line.
void CheckAfterKeyword(const FileBytes& file, const char* at, bool isText)
{
  char* end = nullptr;
  const long long cells = std::strtoll(at, &end, 10);
  const char* const second = end;
  const long long size = std::strtoll(second, &end, 10);
  if (second == at || end == second)
  {
    return; // the word means something else here
  }
  const char* const list = std::find(static_cast<const char*>(end), file.end(), '\n');
  CheckList(Numbers(list + (list < file.end()), file.end(), isText), cells, size);
}

bool IsSpace(char c)
{
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// In letters of any case.
bool StartsWith(std::string_view text, std::string_view word)
{
  return text.size() >= word.size() &&
    std::equal(word.begin(), word.end(), text.begin(),
      [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

/// Like the reader, takes any word for a keyword that begins as one.
void CheckLists(const FileBytes& file, bool isText)
{
  constexpr std::string_view keywords[] = { "vertices", "lines", "polygons", "triangle_strips",
    "cells" };
  for (const char* at = file.begin() + 1; at < file.end(); ++at)
  {
    if (*at < 'A' || !IsSpace(at[-1]))
    {
      continue; // most bytes by far
    }
    const std::string_view word(at, static_cast<std::size_t>(file.end() - at));
    if (std::any_of(std::begin(keywords), std::end(keywords),
          [word](std::string_view keyword) { return StartsWith(word, keyword); }))
    {
      CheckAfterKeyword(file, std::find_if(at, file.end(), IsSpace), isText);
    }
  }
}

/// What the first word behind the first two lines says.
bool IsText(const FileBytes& file)
{
  const char* at = file.begin();
  for (int line = 0; line < 2; ++line)
  {
    at = std::find(at, file.end(), '\n');
    at += at < file.end();
  }
  at = std::find_if_not(at, file.end(), IsSpace);
  return StartsWith({ at, static_cast<std::size_t>(file.end() - at) }, "ascii");
}

} // namespace

void CheckLegacyVtk(const std::string& path)
{
  const FileBytes file(path);
  const std::string_view magic = "# vtk DataFile Version";
  if (file.view().substr(0, magic.size()) != magic)
  {
    return; // not ours to judge
  }
  const bool isText = IsText(file);
  if (isText)
  {
    CheckLastByte(file.view().back());
  }
  // From version 5 on, lists have their sizes in front. What has none is read as an old one.
  int major = 0, minor = 0;
  if (std::sscanf(file.begin() + magic.size(), "%d.%d", &major, &minor) != 2 || major < 5)
  {
    CheckLists(file, isText);
  }
}

} // namespace lambent::command
