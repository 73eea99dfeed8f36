// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of every kind that the command reads, cut behind each of their bytes, and with bits of
// them turned: all that was in the file, or one line that says why not. Never a crash, and never
// less than there was without a word. TestReading.py does a part of this with the command itself.

#include "BrokenFiles.h"

#include <gtest/gtest.h>

#include <cctype>

namespace
{

/// An OBJ file does not tell how much there should be: cut behind a line, it is whole as well.
bool IsWholeAsWell(const File& file, std::size_t size)
{
  return file.extension == ".obj" && file.bytes[size - 1] == '\n';
}

/// The last number of a text may have lost digits at its end; this cannot be told from a text whose
/// last line is not ended.
bool IsWithinLastNumber(const File& file, std::size_t size)
{
  const auto isDigit = [&file](std::size_t at)
  { return at < file.bytes.size() && std::isdigit(static_cast<unsigned char>(file.bytes[at])); };
  const std::size_t end = file.bytes.find_first_not_of("0123456789", size);
  return file.extension == ".vtk" && size > 0 && isDigit(size - 1) && isDigit(size) &&
    file.bytes.find_first_not_of(" \n", end) == std::string::npos;
}

bool IsText(const File& file)
{
  return file.bytes.find('\0') == std::string::npos;
}

void ExpectOneLine(const std::string& failure, const Scratch& scratch)
{
  EXPECT_EQ(failure.rfind("cannot read '" + scratch.path + "': ", 0), 0u) << failure;
  EXPECT_EQ(failure.find('\n'), std::string::npos) << failure;
}

} // namespace

TEST(BrokenFiles, CutBehindEachByte)
{
  for (const File& file : MakeFiles())
  {
    SCOPED_TRACE(file.name + file.extension);
    const Scratch scratch(file.extension);
    const Content whole = Read(scratch, file.bytes);
    ASSERT_EQ(whole.failure, "");
    ASSERT_EQ(whole.warnings, "");
    ASSERT_FALSE(whole.values.empty());
    for (std::size_t size = 0; size < file.bytes.size(); ++size)
    {
      const Content cut = Read(scratch, file.bytes.substr(0, size));
      if (!cut.failure.empty())
      {
        ExpectOneLine(cut.failure, scratch);
      }
      else if (cut.values != whole.values && !IsWholeAsWell(file, size) &&
        !IsWithinLastNumber(file, size))
      {
        EXPECT_NE(cut.warnings.find("cut short"), std::string::npos) << size << " bytes";
        EXPECT_TRUE(IsText(file)) << size << " bytes";
      }
    }
  }
}

namespace
{

/// Reads the file with that bit turned; false if it fails.
bool ReadsWithBitTurned(const File& file, const Scratch& scratch, std::size_t bit)
{
  std::string bytes = file.bytes;
  bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ 1 << bit % 8);
  const Content content = Read(scratch, bytes);
  if (!content.failure.empty())
  {
    ExpectOneLine(content.failure, scratch);
  }
  return content.failure.empty();
}

} // namespace

TEST(BrokenFiles, WithABitTurned)
{
  for (const File& file : MakeFiles())
  {
    SCOPED_TRACE(file.name + file.extension);
    const Scratch scratch(file.extension);
    std::size_t failures = 0;
    const std::size_t bits = 8 * file.bytes.size();
    const std::size_t step = bits > 8000 ? 31 : 7; // all of them would take minutes
    for (std::size_t bit = 0; bit < bits; bit += step)
    {
      failures += !ReadsWithBitTurned(file, scratch, bit);
    }
    EXPECT_GT(failures, 0u);
  }
}

// Three numbers of 32 bits, and one for the only block, stand in front of compressed data.
TEST(BrokenFiles, WithABitOfTheSizesTurned)
{
  const std::string start = "<AppendedData encoding=\"raw\">\n   _";
  int files = 0;
  for (const File& file : MakeFiles())
  {
    const std::size_t at = file.bytes.find(start);
    if (at == std::string::npos || file.bytes.find("compressor=") == std::string::npos)
    {
      continue;
    }
    ++files;
    const Scratch scratch(file.extension);
    for (std::size_t bit = 0; bit < 128; ++bit)
    {
      ReadsWithBitTurned(file, scratch, 8 * (at + start.size()) + bit);
    }
  }
  EXPECT_EQ(files, 3);
}
