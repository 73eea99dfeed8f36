// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextNumber.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>

using namespace lambent::command;

namespace
{

/// Expects the bits of strtod(), and the same number of bytes read.
void ExpectAsStrtod(const std::string& text)
{
  double value = 0;
  const char* const behind = ReadNumber(text.data(), text.data() + text.size(), value);
  char* end = nullptr;
  const double expected = std::strtod(text.c_str(), &end);
  EXPECT_EQ(behind - text.data(), end - text.c_str()) << text;
  EXPECT_EQ(std::memcmp(&value, &expected, sizeof(value)), 0)
    << text << " gives " << value << " and not " << expected;
}

} // namespace

TEST(TextNumber, NumbersOfAllForms)
{
  for (const char* const text :
    { "0", "-0", "+0", "7", "+7", "-7", "1.5", ".5", "-.5", "5.", "1e3", "1E3", "1e+3", "1e-3",
      "1e", "1e+", "1.e2", "1.5x", "1.5.5", "12e3e4", "00012.500", "0.000000000000000000000001",
      "9007199254740992", "9007199254740993", "9007199254740993.0000000000000000000001",
      "123456789012345678901234567890", "1e22", "1e23", "1e-22", "1e-23", "1.7976931348623157e308",
      "2.2250738585072011e-308", "5e-324", "2e-324", "1e-400", "0e999999999999", "1e-99999999999",
      "8.5e22", "3.5844466002796428e+298", "179769313486231570000e288" })
  {
    ExpectAsStrtod(text);
  }
}

TEST(TextNumber, NumbersBeyondADouble)
{
  for (const char* const text : { "1e309", "-1e309", "1e99999999999", "inf", "-Infinity" })
  {
    ExpectAsStrtod(text);
  }
  double value = 0;
  const std::string nan = "-nan(ind)";
  EXPECT_EQ(ReadNumber(nan.data(), nan.data() + nan.size(), value), nan.data() + nan.size());
  EXPECT_TRUE(std::isnan(value));
}

TEST(TextNumber, InvalidNumbers)
{
  for (const std::string text :
    { "", "-", "+", ".", "-.", "e5", ".e5", "x", " 1", "--1", "nothing" })
  {
    double value = 42;
    EXPECT_EQ(ReadNumber(text.data(), text.data() + text.size(), value), text.data()) << text;
  }
}

TEST(TextNumber, HexadecimalIsNotRead)
{
  const std::string text = "0x10";
  double value = 42;
  EXPECT_EQ(ReadNumber(text.data(), text.data() + text.size(), value), text.data() + 1);
  EXPECT_EQ(value, 0);
}

TEST(TextNumber, EveryBitOfRandomNumbers)
{
  std::mt19937_64 random(1);
  for (int k = 0; k < 20000; ++k)
  {
    const std::uint64_t bits = random();
    double number;
    std::memcpy(&number, &bits, sizeof(number));
    number = k % 2 == 0 ? number : static_cast<double>(random() % 2000000) / 1000 - 1000;
    if (!std::isfinite(number))
    {
      continue;
    }
    char text[64];
    std::snprintf(text, sizeof(text), "%.*g", 1 + k % 21, number);
    ExpectAsStrtod(text);
    std::snprintf(text, sizeof(text), "%.*e", 1 + k % 21, number);
    ExpectAsStrtod(text);
  }
}

TEST(TextNumber, IntegersStopAtTheEndOf64Bits)
{
  const auto read = [](const std::string& text)
  {
    std::int64_t value = 42;
    EXPECT_EQ(ReadInteger(text.data(), value), text.data() + text.size()) << text;
    return value;
  };
  EXPECT_EQ(read("0"), 0);
  EXPECT_EQ(read("-12"), -12);
  EXPECT_EQ(read("+12"), 12);
  EXPECT_EQ(read("9223372036854775807"), INT64_MAX);
  EXPECT_EQ(read("9223372036854775808"), INT64_MAX);
  EXPECT_EQ(read("99999999999999999999999"), INT64_MAX);
  EXPECT_EQ(read("-99999999999999999999999"), -INT64_MAX);
  std::int64_t value = 42;
  for (const std::string text : { "", "-", "/1", "x" })
  {
    EXPECT_EQ(ReadInteger(text.data(), value), text.data()) << text;
  }
}
