// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Messages.h"
#include "Options.h"

#include <gtest/gtest.h>

using namespace lambent::command;

namespace
{

Parsed Parse(std::vector<const char*> arguments)
{
  arguments.insert(arguments.begin(), "lambent");
  return ParseOptions(static_cast<int>(arguments.size()), arguments.data(), "lambent 1.2.3");
}

} // namespace

TEST(Options, Defaults)
{
  const Parsed parsed = Parse({ "a.ply", "b.vtp", "-o", "x.png" });
  ASSERT_FALSE(parsed.exitStatus) << parsed.standardError;
  const Options& options = parsed.options;
  EXPECT_EQ(options.inputs, (std::vector<std::string>{ "a.ply", "b.vtp" }));
  EXPECT_EQ(options.output, "x.png");
  EXPECT_FALSE(options.size || options.cameraPosition || options.focalPoint || options.viewUp ||
    options.direction || options.viewAngle || options.parallelScale || options.ambientColor);
  EXPECT_FALSE(options.alpha);
  EXPECT_TRUE(options.passes.empty() && options.backgroundImage.empty());
  EXPECT_EQ(options.zoom, 1);
  EXPECT_TRUE(options.lights.empty());
  EXPECT_EQ(options.shading, Shading::Smooth);
  EXPECT_EQ(options.ambientModel, AmbientModel::PerLight);
  EXPECT_EQ(options.diffuse, 1);
  EXPECT_EQ(options.ambient, 0);
  EXPECT_EQ(options.threads, 0);
  EXPECT_FALSE(options.quiet || options.verbose);
}

TEST(Options, LightsKeepTheirOrderAndDoNotConsumeInputs)
{
  const Parsed parsed = Parse({ "--light", "position=1,2,3", "a.ply", "--headlight", "--light",
    "direction=0,0,1", "b.ply", "-o", "-" });
  ASSERT_FALSE(parsed.exitStatus) << parsed.standardError;
  EXPECT_EQ(parsed.options.inputs, (std::vector<std::string>{ "a.ply", "b.ply" }));
  EXPECT_EQ(parsed.options.output, "-");
  ASSERT_EQ(parsed.options.lights.size(), 3u);
  const auto count = [&parsed](LightValue::Kind kind)
  {
    return std::count_if(parsed.options.lights.begin(), parsed.options.lights.end(),
      [kind](const LightValue& light) { return light.kind == kind; });
  };
  EXPECT_EQ(count(LightValue::Kind::Positional), 1);
  EXPECT_EQ(count(LightValue::Kind::Headlight), 1);
  EXPECT_EQ(count(LightValue::Kind::Directional), 1);
}

TEST(Options, NegativeNumbersAreNotOptions)
{
  const Parsed parsed = Parse({ "a.ply", "-o", "x.png", "--direction", "-1,-2,-3", "--view-up",
    "-.5,0,1", "--focal-point=-1,0,0" });
  ASSERT_FALSE(parsed.exitStatus) << parsed.standardError;
  EXPECT_EQ(parsed.options.direction, (Triple{ -1, -2, -3 }));
  EXPECT_EQ(parsed.options.viewUp, (Triple{ -0.5, 0, 1 }));
}

TEST(Options, PassesAreParsedInOrder)
{
  const Parsed parsed = Parse({ "--pass", "depth", "--pass", "point:a b=c=d.TIF", "a.ply", "--pass",
    "cell:x", "--pass", "ids=i.tiff", "-o", "x.vti", "--alpha" });
  ASSERT_FALSE(parsed.exitStatus) << parsed.standardError;
  EXPECT_TRUE(parsed.options.alpha);
  const std::vector<PassValue>& passes = parsed.options.passes;
  ASSERT_EQ(passes.size(), 4u);
  EXPECT_EQ(passes[0].content, PassValue::Content::Depth);
  EXPECT_EQ(passes[0].array, "Depth");
  EXPECT_EQ(passes[0].file, "");
  EXPECT_EQ(passes[1].content, PassValue::Content::Array);
  EXPECT_EQ(passes[1].association, PassValue::Association::Points);
  EXPECT_EQ(passes[1].array, "a b");
  EXPECT_EQ(passes[1].text, "point:a b");
  EXPECT_EQ(passes[1].file, "c=d.TIF"); // an array's name ends at the first =
  EXPECT_EQ(passes[2].association, PassValue::Association::Cells);
  EXPECT_EQ(passes[3].content, PassValue::Content::CellIds);
  EXPECT_EQ(passes[3].array, "CellIds");
}

TEST(Options, VersionAndHelp)
{
  const Parsed version = Parse({ "--version" });
  EXPECT_EQ(version.exitStatus, 0);
  EXPECT_EQ(version.standardOutput, "lambent 1.2.3\n");
  EXPECT_EQ(version.standardError, "");
  const Parsed help = Parse({ "--help" });
  EXPECT_EQ(help.exitStatus, 0);
  EXPECT_NE(help.standardOutput.find("--camera-position"), std::string::npos);
}

TEST(Options, WrongUsageIsOneLineAndAHint)
{
  const Parsed parsed = Parse({ "a.ply", "-o", "x.png", "--zoom", "nan" });
  EXPECT_EQ(parsed.exitStatus, 2);
  EXPECT_EQ(parsed.standardOutput, "");
  EXPECT_EQ(
    parsed.standardError, "lambent: --zoom: 'nan' is not a finite number\nTry 'lambent --help'.\n");
  // This also holds if the argument has several lines.
  EXPECT_EQ(Parse({ "a.ply", "-o", "x.png", "--size", "1\n2" }).standardError,
    "lambent: --size: '1 2' is not a size in pixels of at least 1x1, such as 1920x1080\n"
    "Try 'lambent --help'.\n");
}

TEST(Options, RepeatedOptionsAreReportedClearly)
{
  EXPECT_EQ(Parse({ "a.ply", "-o", "x.png", "-o", "y.png", "-o", "z.png" }).standardError,
    "lambent: --output is given 3 times; give it once\nTry 'lambent --help'.\n");
}

TEST(Messages, PipelineRequestsAreOmitted)
{
  for (const std::string address : { "(0x55d0c8a3)", " (0x55d0c8a3)" })
  {
    EXPECT_EQ(
      OneLine("ERROR: In vtkExecutive.cxx, line 752\nvtkCompositeDataPipeline (0x55d0c8a4): "
              "Algorithm vtkPLYReader" +
        address + " returned failure for request: vtkInformation (0x5614)\n  Debug: Off\n"),
      "vtkPLYReader failed without a reason");
  }
}
