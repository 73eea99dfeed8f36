// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures with alpha equal the opaque pictures after compositing over a background, without a dark
// fringe. The tests of the core compare their bits with the definition.
#include "Meshes.h"
#include "Messages.h"

#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace
{
constexpr int width = 61, height = 45;

void setUp(Studio& studio, int samples)
{
  studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
  studio.reflect({ 0.9, 0.5, 0.25 }, { 0.05, 0.1, 0.2 });
  studio.tracer->AddInputDataObject(makeSphere(12));
  studio.tracer->AddInputDataObject(makeBox(0.9, 0.8, 1.3));
  studio.tracer->SetSupersampling(samples);
}

/// A picture with alpha. The background must be black, because otherwise there is a warning.
Picture transparent(int samples, int type)
{
  Studio studio(width, height);
  const Messages messages(studio.tracer);
  setUp(studio, samples);
  studio.tracer->SetBackground(0.0, 0.0, 0.0);
  studio.tracer->SetOutputScalarType(type);
  studio.tracer->OutputAlphaOn();
  const Picture picture = render(studio.tracer);
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_TRUE(messages.warnings().empty());
  return picture;
}
}

TEST(Alpha, CompositingGivesTheOpaquePicture)
{
  const Vec background(0.25, 0.5, 0.75);
  for (const int samples : { 1, 3 })
  {
    Studio studio(width, height);
    setUp(studio, samples);
    studio.tracer->SetBackground(background.x, background.y, background.z);
    const Picture opaque = render(studio.tracer);
    const Picture picture = transparent(samples, VTK_FLOAT);
    int partial = 0, none = 0, full = 0;
    for (int pixel = 0; pixel < width * height; ++pixel)
    {
      const int i = pixel % width, j = pixel / width;
      const double alpha = picture.alpha(i, j);
      (alpha == 0.0 ? none : alpha == 1.0 ? full : partial) += 1;
      expectColor(alpha * picture.at(i, j) + (1.0 - alpha) * background, opaque.at(i, j),
        pixelName(i, j), 3e-7);
      EXPECT_EQ(std::round(alpha * samples * samples),
        static_cast<float>(alpha * samples * samples)); // a fraction of the samples
    }
    EXPECT_GT(none, 300);
    EXPECT_GT(full, 300);
    EXPECT_EQ(partial > 50, samples > 1);
    EXPECT_EQ(partial == 0, samples == 1);
  }
}

TEST(Alpha, IsAFractionOf255InBytes)
{
  for (const int samples : { 1, 3 })
  {
    const Picture bytes = transparent(samples, VTK_UNSIGNED_CHAR);
    const Picture floats = transparent(samples, VTK_FLOAT);
    for (int pixel = 0; pixel < width * height; ++pixel)
    {
      const int i = pixel % width, j = pixel / width;
      EXPECT_EQ(bytes.alpha(i, j), std::floor(255.0 * floats.alpha(i, j) + 0.5));
      expectColor(bytes.at(i, j), glm::round(255.0 * glm::min(floats.at(i, j), Vec(1.0))),
        pixelName(i, j), 1.0 / 1024.0);
    }
  }
}

// A half-covered pixel at the edge of a white square is white, not grey.
TEST(Alpha, HasNoDarkFringe)
{
  for (const int type : { VTK_FLOAT, VTK_UNSIGNED_CHAR })
  {
    Studio studio(4, 1);
    studio.camera->ParallelProjectionOn();
    studio.camera->SetParallelScale(0.5);
    studio.property->LightingOff();
    studio.tracer->SetBackground(0.0, 0.0, 0.0);
    studio.tracer->SetInputData(
      makeMesh({ { -3.0, -1.0, 0.0 }, { 0.5, -1.0, 0.0 }, { 0.5, 1.0, 0.0 }, { -3.0, 1.0, 0.0 } },
        { { 0, 1, 2, 3 } }));
    studio.tracer->SetOutputScalarType(type);
    studio.tracer->SetSupersampling(4);
    studio.tracer->OutputAlphaOn();
    const Picture picture = render(studio.tracer);
    const double one = type == VTK_FLOAT ? 1.0 : 255.0;
    EXPECT_EQ(picture.at(1, 0), Vec(one));
    EXPECT_EQ(picture.alpha(1, 0), one);
    EXPECT_EQ(picture.at(2, 0), Vec(one));
    EXPECT_EQ(picture.alpha(2, 0), type == VTK_FLOAT ? 0.5 : 128.0);
    EXPECT_EQ(picture.at(3, 0), Vec(0.0));
    EXPECT_EQ(picture.alpha(3, 0), 0.0);
  }
}

// With one sample, alpha is 0 or 1, and the colours of surfaces are those of the opaque picture.
TEST(Alpha, ChangesNoColourOfASurface)
{
  Studio studio(width, height);
  setUp(studio, 1);
  const Picture opaque = render(studio.tracer);
  const Picture picture = transparent(1, VTK_FLOAT);
  for (int pixel = 0; pixel < width * height; ++pixel)
  {
    const int i = pixel % width, j = pixel / width;
    const bool isHit = opaque.at(i, j) != Studio::background();
    EXPECT_EQ(picture.alpha(i, j), isHit ? 1.0 : 0.0);
    EXPECT_EQ(picture.at(i, j), isHit ? opaque.at(i, j) : Vec(0.0));
  }
}

TEST(Alpha, IsZeroWithoutSurfaces)
{
  for (const int type : { VTK_FLOAT, VTK_UNSIGNED_CHAR })
  {
    Studio studio(41, 3);
    studio.tracer->SetInputData(Mesh::New());
    studio.tracer->SetOutputScalarType(type);
    studio.tracer->SetBackground(0.0, 0.0, 0.0);
    studio.tracer->OutputAlphaOn();
    const Picture picture = render(studio.tracer);
    EXPECT_EQ(picture.bits(), std::string(picture.bits().size(), '\0'));
    EXPECT_EQ(picture.bits().size(), 41u * 3 * 4 * (type == VTK_FLOAT ? 4 : 1));
  }
}

TEST(Alpha, PartsEqualThoseOfTheWhole)
{
  const Picture whole = transparent(3, VTK_UNSIGNED_CHAR);
  Studio studio(width, height);
  setUp(studio, 3);
  studio.tracer->SetOutputScalarTypeToUnsignedChar();
  studio.tracer->OutputAlphaOn();
  const int extent[6] = { 9, 50, 4, 39, 0, 0 };
  studio.tracer->UpdateExtent(extent);
  const Picture part(studio.tracer->GetOutput());
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    EXPECT_EQ(part.bits(9, 51, j), whole.bits(9, 51, j)) << "row " << j;
  }
}

// Downstream filters get the number of components before the picture is rendered.
TEST(Alpha, IsInThePipelineInformation)
{
  for (const bool hasAlpha : { false, true, false })
  {
    Studio studio(8, 8);
    studio.tracer->SetInputData(makeSquare());
    studio.tracer->SetOutputAlpha(hasAlpha);
    studio.tracer->UpdateInformation();
    vtkInformation* const color =
      vtkDataObject::GetActiveFieldInformation(studio.tracer->GetOutputInformation(0),
        vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
    ASSERT_NE(color, nullptr);
    EXPECT_EQ(color->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()), hasAlpha ? 4 : 3);
    EXPECT_EQ(color->Get(vtkDataObject::FIELD_ARRAY_TYPE()), VTK_FLOAT);
    studio.tracer->Update();
    EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfScalarComponents(), hasAlpha ? 4 : 3);
  }
}

// A background has no effect with alpha, which causes one warning.
TEST(Alpha, CausesAWarningIfThereIsABackground)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(1, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  image->GetPointData()->GetScalars()->Fill(9.0);
  const Picture expected = transparent(1, VTK_FLOAT);
  for (const std::string setting : { "SetBackground()", "SetBackgroundImage()", "Background2" })
  {
    Studio studio(width, height);
    setUp(studio, 1);
    studio.tracer->SetBackground(0.0, 0.0, 0.0);
    Messages messages(studio.tracer);
    studio.tracer->Update();
    EXPECT_TRUE(messages.warnings().empty());
    studio.tracer->OutputAlphaOn();
    studio.tracer->SetBackground(0.0, setting == "SetBackground()" ? 0.5 : 0.0, 0.0);
    studio.tracer->SetBackground2(0.0, 0.0, 0.5);
    studio.tracer->SetGradientBackground(setting == "Background2");
    studio.tracer->SetBackgroundImage(setting == "SetBackgroundImage()" ? image.Get() : nullptr);
    EXPECT_SAME_BITS(render(studio.tracer), expected);
    expectMessage(messages.warnings(),
      { setting == "Background2" ? "SetBackground()" : setting, "no effect", "OutputAlpha",
        "OutputAlphaOff()" });
    studio.camera->Azimuth(1.0);
    studio.tracer->Update(); // not once per picture
    EXPECT_EQ(messages.warnings().size(), 1u);
    EXPECT_TRUE(messages.errors().empty());
  }
}

// What has no effect cannot be wrong either.
TEST(Alpha, IgnoresABackgroundThatCannotBeUsed)
{
  Studio studio(width, height);
  setUp(studio, 1);
  const Messages messages(studio.tracer);
  studio.tracer->OutputAlphaOn();
  vtkNew<vtkImageData> empty;
  studio.tracer->SetBackgroundImage(empty);
  studio.tracer->SetBackground(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  EXPECT_SAME_BITS(render(studio.tracer), transparent(1, VTK_FLOAT));
  expectMessage(messages.warnings(), { "SetBackgroundImage()", "no effect", "OutputAlpha" });
  EXPECT_TRUE(messages.errors().empty());
}
