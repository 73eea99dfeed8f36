// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Which entry of a table a number gets. TestColors.cxx of Testing/Rendering compares with VTK's
// lookup tables.
#include "ColorTable.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

using lambent::ColorTable;
using lambent::Vec3;

namespace
{
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Entry k has the red channel k.
std::vector<unsigned char> numbered(int count)
{
  std::vector<unsigned char> entries(4 * count, 10);
  for (int k = 0; k < count; ++k)
  {
    entries[4 * k] = static_cast<unsigned char>(k);
    entries[4 * k + 2] = 20;
  }
  return entries;
}
}

TEST(ColorTable, DividesTheRangeEqually)
{
  const std::vector<unsigned char> entries = numbered(4);
  const ColorTable table(entries.data(), 4, -1.0, 1.0, false);
  const struct
  {
    double value;
    int entry;
  } expected[] = { { -1.0, 0 }, { -0.5000001, 0 }, { -0.5, 1 }, { 0.0, 2 }, { 0.4999999, 2 },
    { 0.5, 3 }, { 1.0, 3 }, { -2.0, 0 }, { 7.0, 3 }, { infinity, 3 }, { -infinity, 0 },
    { notANumber, 0 } };
  for (const auto& e : expected)
  {
    EXPECT_EQ(int(table.entry(e.value)[0]), e.entry) << e.value;
  }
  EXPECT_EQ(table.color(0.0), Vec3(2.0 / 255.0, 10.0 / 255.0, 20.0 / 255.0));
}

TEST(ColorTable, HasColoursForWhatIsOutside)
{
  const std::vector<unsigned char> entries = numbered(8);
  ColorTable table(entries.data(), 3, 0.0, 3.0, false);
  table.setBelow(entries.data() + 4 * 5);
  table.setAbove(entries.data() + 4 * 6);
  table.setNotANumber(entries.data() + 4 * 7);
  EXPECT_EQ(int(table.entry(-0.001)[0]), 5);
  EXPECT_EQ(int(table.entry(0.0)[0]), 0);
  EXPECT_EQ(int(table.entry(3.0)[0]), 2);
  EXPECT_EQ(int(table.entry(3.001)[0]), 6);
  EXPECT_EQ(int(table.entry(notANumber)[0]), 7);
}

TEST(ColorTable, LogarithmicRange)
{
  const std::vector<unsigned char> entries = numbered(8);
  ColorTable table(entries.data(), 3, 1.0, 1000.0, true);
  table.setBelow(entries.data() + 4 * 5);
  table.setAbove(entries.data() + 4 * 6);
  const struct
  {
    double value;
    int entry;
  } expected[] = { { 1.0, 0 }, { 9.99, 0 }, { 10.0, 1 }, { 99.9, 1 }, { 100.0, 2 }, { 1000.0, 2 },
    { 0.5, 5 }, { 1001.0, 6 }, { 0.0, 0 }, { -1.0, 0 }, { infinity, 6 } };
  for (const auto& e : expected)
  {
    EXPECT_EQ(int(table.entry(e.value)[0]), e.entry) << e.value;
  }
}

TEST(ColorTable, EmptyRange)
{
  const std::vector<unsigned char> entries = numbered(4);
  const ColorTable table(entries.data(), 4, 2.0, 2.0, false);
  EXPECT_EQ(int(table.entry(2.0)[0]), 0);
  EXPECT_EQ(int(table.entry(1.0)[0]), 0);
  EXPECT_EQ(int(table.entry(3.0)[0]), 3);
}
