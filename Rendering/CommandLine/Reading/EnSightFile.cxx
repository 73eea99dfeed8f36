// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EnSightFile.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

namespace lambent::command
{
namespace
{

constexpr std::size_t BinaryLine = 80;

std::string Trimmed(const std::string& line)
{
  const char* const blanks = " \t\r\n";
  const std::size_t begin = line.find_first_not_of(blanks);
  return begin == std::string::npos ? std::string()
                                    : line.substr(begin, line.find_last_not_of(blanks) + 1 - begin);
}

bool IsBlank(const std::string& line)
{
  return line.find_first_not_of(" \t\r\n") == std::string::npos;
}

class TextFile : public EnSightFile
{
public:
  explicit TextFile(std::ifstream file)
    : File(std::move(file))
  {
  }

  bool IsAtEnd() override
  {
    const std::streampos here = this->File.tellg();
    std::string line;
    while (std::getline(this->File, line) && IsBlank(line))
    {
    }
    const bool isAtEnd = !this->File;
    this->File.clear();
    this->File.seekg(here);
    return isAtEnd;
  }

  std::string TakeDescription() override
  {
    std::string line;
    if (!std::getline(this->File, line))
    {
      throw EndOfEnSightFile();
    }
    return Trimmed(line);
  }

  std::string TakeLine() override { return Trimmed(this->TakeDataLine()); }

  std::int64_t TakePartNumber() override { return this->TakeRow(1)[0]; }

  std::vector<std::int64_t> TakeRow(int count) override
  {
    std::istringstream words(this->TakeDataLine());
    std::vector<std::int64_t> numbers(static_cast<std::size_t>(count));
    for (std::int64_t& number : numbers)
    {
      if (!(words >> number))
      {
        if (this->File.eof())
        {
          throw EndOfEnSightFile();
        }
        throw EnSightNotUnderstood();
      }
    }
    return numbers;
  }

  void SkipRows(std::int64_t rows, std::int64_t numbersInRow) override
  {
    std::size_t widthBefore = 0;
    for (std::int64_t row = 0; row < rows; ++row)
    {
      const std::string line = this->TakeDataLine();
      if (this->File.eof() && IsCut(line, numbersInRow, widthBefore))
      {
        throw EndOfEnSightFile();
      }
      widthBefore = line.size();
    }
  }

private:
  /// Skips blank lines and comments, as VTK's readers do.
  std::string TakeDataLine()
  {
    std::string line;
    do
    {
      if (!std::getline(this->File, line))
      {
        throw EndOfEnSightFile();
      }
    } while (line[0] == '#' || IsBlank(line));
    return line;
  }

  /// Whether the last line of a file, without a line end, is truncated. Numbers usually have 10 or
  /// 12 columns each; then the last line is as wide as the one before.
  static bool IsCut(const std::string& line, std::int64_t numbersInRow, std::size_t widthBefore)
  {
    std::istringstream words(line);
    std::string word;
    std::int64_t count = 0;
    while (words >> word)
    {
      ++count;
    }
    const auto numbers = static_cast<std::size_t>(numbersInRow);
    const bool isInColumns = widthBefore == 10 * numbers || widthBefore == 12 * numbers;
    return isInColumns ? line.size() < widthBefore : count < numbersInRow;
  }

  std::ifstream File;
};

class BinaryFile : public EnSightFile
{
public:
  explicit BinaryFile(std::ifstream file)
    : File(std::move(file))
  {
    this->File.seekg(0, std::ios::end);
    this->Size = this->File.tellg();
    this->File.seekg(0);
  }

  bool IsAtEnd() override { return this->Left() == 0; }
  std::string TakeDescription() override { return this->TakeLine(); }

  std::string TakeLine() override
  {
    char line[BinaryLine + 1] = {};
    this->Take(line, BinaryLine);
    return Trimmed(line);
  }

  std::int64_t TakePartNumber() override
  {
    unsigned char bytes[4];
    this->Take(bytes, sizeof(bytes));
    this->IsBigEndian = bytes[0] == 0 && bytes[1] == 0 && (bytes[2] != 0 || bytes[3] != 0);
    return this->NumberOf(bytes);
  }

  std::vector<std::int64_t> TakeRow(int count) override
  {
    std::vector<std::int64_t> numbers;
    for (int k = 0; k < count; ++k)
    {
      unsigned char bytes[4];
      this->Take(bytes, sizeof(bytes));
      numbers.push_back(this->NumberOf(bytes));
    }
    return numbers;
  }

  void SkipRows(std::int64_t rows, std::int64_t numbersInRow) override
  {
    if (numbersInRow > 0 && rows > this->Left() / 4 / numbersInRow)
    {
      throw EndOfEnSightFile();
    }
    this->File.seekg(4 * rows * numbersInRow, std::ios::cur);
  }

private:
  std::int64_t Left() { return this->Size - static_cast<std::int64_t>(this->File.tellg()); }

  void Take(void* bytes, std::size_t size)
  {
    if (!this->File.read(static_cast<char*>(bytes), static_cast<std::streamsize>(size)))
    {
      throw EndOfEnSightFile();
    }
  }

  std::int64_t NumberOf(const unsigned char* bytes) const
  {
    std::uint32_t number = 0;
    for (int k = 0; k < 4; ++k)
    {
      number |= static_cast<std::uint32_t>(bytes[this->IsBigEndian ? 3 - k : k]) << 8 * k;
    }
    return static_cast<std::int32_t>(number);
  }

  std::ifstream File;
  std::int64_t Size = 0;
  bool IsBigEndian = false;
};

} // namespace

EnSightEncoding EncodingOfEnSight(const std::string& geometryPath)
{
  std::ifstream file(geometryPath, std::ios::binary);
  char first[BinaryLine + 1] = {};
  file.read(first, BinaryLine);
  std::string text = Trimmed(first);
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text.rfind("c binary", 0) == 0    ? EnSightEncoding::Binary
    : text.rfind("fortran binary", 0) == 0 ? EnSightEncoding::Other
                                           : EnSightEncoding::Text;
}

std::vector<std::string> WordsOf(const std::string& line)
{
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

std::unique_ptr<EnSightFile> EnSightFile::Open(const std::string& path, EnSightEncoding encoding)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    return nullptr;
  }
  if (encoding == EnSightEncoding::Binary)
  {
    return std::make_unique<BinaryFile>(std::move(file));
  }
  return std::make_unique<TextFile>(std::move(file));
}

std::vector<std::int64_t> EnSightFile::TakeCounts(std::int64_t rows, int numbersInRow)
{
  std::vector<std::int64_t> counts;
  for (std::int64_t row = 0; row < rows; ++row)
  {
    for (const std::int64_t count : this->TakeRow(numbersInRow))
    {
      if (count < 0 || count > std::numeric_limits<std::int32_t>::max())
      {
        throw EnSightNotUnderstood();
      }
      counts.push_back(count);
    }
  }
  return counts;
}

} // namespace lambent::command
