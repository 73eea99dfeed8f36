// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of every kind that the command reads, cut after each byte, and with flipped bits. The
// result must be everything in the file, or one line with the reason; never a crash, and never a
// part without a message. TestReading.py repeats some of this with the command itself.

#include "BrokenFiles.h"

#include <gtest/gtest.h>

#include <cctype>

namespace
{

bool IsText(const File& file)
{
  return file.bytes.find('\0') == std::string::npos;
}

/// A file that is cut after all of its points can be a complete file without polygons.
bool HasLostAllPolygons(const Content& cut)
{
  return cut.values.empty() && cut.warnings.find("and no polygons") != std::string::npos;
}

/// Whether a cut file may be read without a message. An OBJ file has no counts. In text, the last
/// line need not end, and half of the number at its end is another number.
bool MayPass(const File& file, std::size_t size)
{
  const std::size_t end = file.bytes.find_last_not_of(" \n");
  const bool isInLastNumber = file.bytes.find_last_of(" \n", end) < size;
  return file.extension == ".obj" || (IsText(file) && isInLastNumber);
}

void ExpectOneLine(const std::string& failure, const Scratch& scratch)
{
  EXPECT_EQ(failure.rfind("cannot read '" + scratch.path + "': ", 0), 0u) << failure;
  EXPECT_EQ(failure.find('\n'), std::string::npos) << failure;
}

} // namespace

TEST(BrokenFiles, CutAfterEachByte)
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
      EXPECT_LE(cut.values.size(), whole.values.size());
      if (!cut.failure.empty())
      {
        ExpectOneLine(cut.failure, scratch);
      }
      else if (cut.values != whole.values && !MayPass(file, size) && !HasLostAllPolygons(cut))
      {
        EXPECT_NE(cut.warnings.find("incomplete"), std::string::npos) << size << " bytes";
        EXPECT_TRUE(IsText(file)) << size << " bytes";
      }
    }
  }
}

namespace
{

/// Reads the file with one bit flipped; returns false if that fails.
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

TEST(BrokenFiles, WithAFlippedBit)
{
  for (const File& file : MakeFiles())
  {
    SCOPED_TRACE(file.name + file.extension);
    const Scratch scratch(file.extension);
    std::size_t failures = 0;
    const std::size_t bits = 8 * file.bytes.size();
    const std::size_t step = bits > 8000 ? 31 : 7; // trying all would take minutes
    for (std::size_t bit = 0; bit < bits; bit += step)
    {
      failures += !ReadsWithBitTurned(file, scratch, bit);
    }
    EXPECT_GT(failures, 0u);
  }
}

// Compressed data starts with three 32-bit numbers, and one for the only block.
TEST(BrokenFiles, WithAFlippedBitInTheSizes)
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
