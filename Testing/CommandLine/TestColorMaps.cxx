// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColorMaps.h"
#include "Values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

using namespace lambent::command;

namespace
{

ColorTable256 Table(const std::string& name)
{
  const auto table = FindColorMap(name);
  EXPECT_TRUE(table) << name;
  return table.value_or(ColorTable256());
}

/// The largest difference of a channel between an entry and 0xrrggbb.
int Difference(const ColorTable256& table, int entry, unsigned color)
{
  int largest = 0;
  for (int channel = 0; channel < 3; ++channel)
  {
    const int published = color >> (16 - 8 * channel) & 255;
    largest = std::max(largest, std::abs(table[entry][channel] - published));
  }
  return largest;
}

std::vector<std::string> Names()
{
  std::vector<std::string> names;
  for (const std::string& part : Split(ColorMapNames(), ','))
  {
    names.push_back(part.substr(part[0] == ' ' ? 1 : 0));
  }
  return names;
}

} // namespace

// Entries between the knots. The published ones may differ by 1/255, and both are rounded.
TEST(ColorMaps, SampledMapsAreTheOnesThatWerePublished)
{
  constexpr int entries[] = { 0, 32, 90, 168, 222, 255 };
  const struct
  {
    const char* name;
    unsigned colors[6];
  } published[] = {
    { "viridis", { 0x440154, 0x472d7b, 0x2e6d8e, 0x32b67a, 0xa8db34, 0xfde725 } },
    { "plasma", { 0x0d0887, 0x4c02a1, 0xa21d9a, 0xeb7655, 0xfdc229, 0xf0f921 } },
    { "inferno", { 0x000004, 0x210c4a, 0x801f6c, 0xeb6628, 0xf9c72f, 0xfcffa4 } },
    { "magma", { 0x000004, 0x1d1147, 0x792282, 0xef5d5e, 0xfec185, 0xfcfdbf } },
    { "cividis", { 0x00224e, 0x1a386f, 0x5c616e, 0xa39a74, 0xdcc859, 0xfee838 } },
    { "turbo", { 0x30123b, 0x466be3, 0x22ebaa, 0xf8be39, 0xd43305, 0x7a0403 } },
    { "coolwarm", { 0x3b4cc0, 0x6282ea, 0xb1cbfc, 0xf7ba9f, 0xdf634e, 0xb40426 } },
  };
  for (const auto& map : published)
  {
    const ColorTable256 table = Table(map.name);
    for (int k = 0; k < 6; ++k)
    {
      const bool isEnd = k == 0 || k == 5;
      EXPECT_LE(Difference(table, entries[k], map.colors[k]), isEnd ? 0 : 1)
        << map.name << " " << entries[k];
    }
  }
}

TEST(ColorMaps, FormulasAreExact)
{
  for (int k = 0; k < 256; ++k)
  {
    EXPECT_EQ(Difference(Table("gray"), k, 0x010101u * k), 0) << k;
    EXPECT_EQ(Difference(Table("x-ray"), k, 0x010101u * (255 - k)), 0) << k;
  }
  const struct
  {
    const char* name;
    int entry;
    unsigned color;
  } values[] = { { "rainbow", 0, 0x0000ff }, { "rainbow", 51, 0x00ccff },
    { "rainbow", 255, 0xff0000 }, { "jet", 0, 0x000080 }, { "jet", 30, 0x0000ff },
    { "jet", 168, 0xfeed00 }, { "jet", 222, 0xff2500 }, { "jet", 255, 0x800000 },
    { "hot", 0, 0x0b0000 }, { "hot", 90, 0xf70000 }, { "hot", 168, 0xffc500 },
    { "black-body", 51, 0x730000 }, { "black-body", 204, 0xe6e600 }, { "bone", 90, 0x4f4f6e },
    { "copper", 222, 0xffad6e }, { "cool", 30, 0x1ee1ff }, { "bwr", 222, 0xff4242 },
    { "seismic", 168, 0xff5d5d }, { "hsv", 85, 0x00ff00 } };
  for (const auto& value : values)
  {
    EXPECT_EQ(Difference(Table(value.name), value.entry, value.color), 0)
      << value.name << " " << value.entry;
  }
}

TEST(ColorMaps, NamesMayBeWrittenInSeveralWays)
{
  EXPECT_EQ(Table("Viridis"), Table("viridis"));
  EXPECT_EQ(Table("Viridis (matplotlib)"), Table("viridis"));
  EXPECT_EQ(Table("Cool to Warm"), Table("coolwarm"));
  EXPECT_EQ(Table("Black-Body Radiation"), Table("black-body"));
  EXPECT_EQ(Table("blackbody"), Table("Black_Body"));
  EXPECT_EQ(Table("Blue to Red Rainbow"), Table("rainbow"));
  EXPECT_EQ(Table("grey"), Table("GRAY"));
  EXPECT_EQ(Table("X Ray"), Table("gray_r"));
  for (const char* name : { "", "_r", "virids", "viridis_r_r", "r" })
  {
    EXPECT_FALSE(FindColorMap(name)) << name;
  }
}

TEST(ColorMaps, EachOneCanBeReversed)
{
  EXPECT_GE(Names().size(), 19u);
  for (const std::string& name : Names())
  {
    const ColorTable256 table = Table(name), reversed = Table(name + "_r");
    EXPECT_TRUE(std::equal(table.begin(), table.end(), reversed.rbegin())) << name;
    EXPECT_EQ(Table(name + "_R"), reversed) << name;
  }
}

// The same on every platform: a hash (FNV-1a) of all bytes.
TEST(ColorMaps, TheBytesAreTheSameEverywhere)
{
  std::uint64_t hash = 14695981039346656037u;
  for (const std::string& name : Names())
  {
    for (const auto& color : Table(name))
    {
      for (const unsigned char byte : color)
      {
        hash = (hash ^ byte) * 1099511628211u;
      }
    }
  }
  EXPECT_EQ(hash, 1247118374638887190u);
}
