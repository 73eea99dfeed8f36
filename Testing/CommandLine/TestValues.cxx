// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Values.h"

#include <gtest/gtest.h>

using namespace lambent::command;

TEST(Values, NumbersAreFiniteAndWhole)
{
  EXPECT_EQ(ParseNumber("1.5"), 1.5);
  EXPECT_EQ(ParseNumber("-2e3"), -2000);
  for (const char* text : { "", "x", "1x", "1 2", "nan", "inf", "-inf", "1e999", "1,5" })
  {
    EXPECT_THROW(ParseNumber(text), BadValue) << text;
  }
}

TEST(Values, NumbersAreInTheirRange)
{
  EXPECT_EQ(ParseNumber("0", 0, 1), 0);
  EXPECT_EQ(ParseNumber("1", 0, 1), 1);
  EXPECT_THROW(ParseNumber("1.0000001", 0, 1), BadValue);
  EXPECT_THROW(ParseNumber("-1e-300", 0, 1), BadValue);
  EXPECT_THROW(ParsePositive("0"), BadValue);
  EXPECT_EQ(ParsePositive("1e-300"), 1e-300);
  EXPECT_EQ(ParseNotNegative("0"), 0);
  EXPECT_THROW(ParseNotNegative("-1"), BadValue);
}

TEST(Values, Triples)
{
  EXPECT_EQ(ParseTriple("1,-2.5,3e2"), (Triple{ 1, -2.5, 300 }));
  for (const char* text : { "", "1", "1,2", "1,2,3,4", "1,2,", "1,,3", "1 2 3" })
  {
    EXPECT_THROW(ParseTriple(text), BadValue) << text;
  }
  EXPECT_THROW(ParseDirection("0,-0,0"), BadValue);
  EXPECT_EQ(ParseDirection("0,0,1e-300"), (Triple{ 0, 0, 1e-300 }));
}

TEST(Values, ColorsInThreeWays)
{
  const Triple tomato = { 1, 99 / 255.0, 71 / 255.0 };
  EXPECT_EQ(ParseColor("#ff6347"), tomato);
  EXPECT_EQ(ParseColor("#FF6347"), tomato);
  EXPECT_EQ(ParseColor("tomato"), tomato);
  EXPECT_EQ(ParseColor("0,0.5,1"), (Triple{ 0, 0.5, 1 }));
  for (const char* text : { "", "#fff", "#ff634", "#ff634g", "nonesuch", "0,0,1.1", "-1,0,0" })
  {
    EXPECT_THROW(ParseColor(text), BadValue) << text;
  }
}

TEST(Values, Sizes)
{
  EXPECT_EQ(ParseSize("1920x1080"), (std::array<int, 2>{ 1920, 1080 }));
  EXPECT_EQ(ParseSize("1x999999999"), (std::array<int, 2>{ 1, 999999999 }));
  for (const char* text :
    { "", "x", "0x0", "1x0", "1x", "x1", "1X1", "-1x1", "1x1x1", "1e3x1", "1x9999999999" })
  {
    EXPECT_THROW(ParseSize(text), BadValue) << text;
  }
}

TEST(Values, PositionalLight)
{
  const LightValue light = ParseLight("position=1,2,3;color=0,1,0;intensity=0.5;cone=20;exponent=4;"
                                      "attenuation=0,1,2;focal=4,5,6");
  EXPECT_EQ(light.kind, LightValue::Kind::Positional);
  EXPECT_EQ(light.place, (Triple{ 1, 2, 3 }));
  EXPECT_EQ(light.color, (Triple{ 0, 1, 0 }));
  EXPECT_EQ(light.intensity, 0.5);
  EXPECT_EQ(light.cone, 20);
  EXPECT_EQ(light.exponent, 4);
  EXPECT_EQ(light.attenuation, (Triple{ 0, 1, 2 }));
  EXPECT_TRUE(light.hasFocus);
  EXPECT_EQ(light.focus, (Triple{ 4, 5, 6 }));
}

// CMake's lists preserve colons, and shells need no quotes around them.
TEST(Values, AttenuationMustBePositive)
{
  for (const char* text : { "0,0,0", "0,-1,0", "-1,0,0" })
  {
    EXPECT_THROW(ParseLight(std::string("position=1,2,3:attenuation=") + text), BadValue) << text;
  }
  EXPECT_EQ(ParseLight("position=1,2,3:attenuation=0,0,2").attenuation, (Triple{ 0, 0, 2 }));
}

TEST(Values, LightsAreJoinedByColonsOrSemicolons)
{
  for (const char* text : { "position=1,2,3:color=#0000ff:cone=20:focal=4,5,6",
         "position=1,2,3;color=#0000ff:cone=20;focal=4,5,6" })
  {
    const LightValue light = ParseLight(text);
    EXPECT_EQ(light.text, text);
    EXPECT_EQ(light.kind, LightValue::Kind::Positional);
    EXPECT_EQ(light.place, (Triple{ 1, 2, 3 }));
    EXPECT_EQ(light.color, (Triple{ 0, 0, 1 }));
    EXPECT_EQ(light.cone, 20);
    EXPECT_EQ(light.focus, (Triple{ 4, 5, 6 }));
  }
}

TEST(Values, LightDefaults)
{
  const LightValue light = ParseLight("position=1,2,3");
  EXPECT_EQ(light.color, (Triple{ 1, 1, 1 }));
  EXPECT_EQ(light.intensity, 1);
  EXPECT_GE(light.cone, 90); // the light shines in all directions
  EXPECT_FALSE(light.hasFocus);
  EXPECT_EQ(ParseLight("color=red;direction=0,0,-1").kind, LightValue::Kind::Directional);
}

TEST(Values, InvalidLights)
{
  for (const char* text : { "", "position", "color=red", "position=1,2,3;",
         "position=1,2,3:", ":position=1,2,3", "position=1,2,3::color=red", "position:1,2,3",
         "position=1,2,3;direction=0,0,1", "direction=0,0,0", "direction=0,0,1;cone=10",
         "position=1,2,3;radius=2", "position=1,2,3;intensity=-1", "position=1,2,3;cone=200" })
  {
    EXPECT_THROW(ParseLight(text), BadValue) << text;
  }
}
