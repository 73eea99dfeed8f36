// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckLegacyVtk.h"
#include "FileBytes.h"
#include "Messages.h"

#include <cstdlib>

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

/// Looks at what follows a keyword; if it is "cells size" and a line end, a list begins there.
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
  while (*end == ' ' || *end == '\r')
  {
    ++end;
  }
  const char* const list = end < file.end() ? end + 1 : end;
  CheckList(Numbers(list, file.end(), isText), cells, size);
}

} // namespace

void CheckLegacyVtk(const std::string& path)
{
  const FileBytes file(path);
  const std::string_view text = file.view();
  const std::string_view start = text.substr(0, 1024);
  const std::string_view magic = "# vtk DataFile Version ";
  if (start.substr(0, magic.size()) != magic || std::atoi(start.data() + magic.size()) >= 5)
  {
    return; // not ours to judge, or a version whose lists have their sizes in front
  }
  const bool isText = start.find("\nASCII") != std::string_view::npos;
  for (const std::string_view keyword :
    { "VERTICES ", "LINES ", "POLYGONS ", "TRIANGLE_STRIPS ", "CELLS " })
  {
    for (std::size_t at = text.find(keyword); at != std::string_view::npos;
         at = text.find(keyword, at + 1))
    {
      CheckAfterKeyword(file, file.begin() + at + keyword.size(), isText);
    }
  }
}

} // namespace lambent::command
