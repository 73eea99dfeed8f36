// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Backgrounds that do not show cause a warning. TestAlpha.cxx tests those of pictures with alpha.
#include "Meshes.h"
#include "Messages.h"

TEST(IdleBackgrounds, BehindAnOpaqueImageAreNamed)
{
  for (int components = 0; components <= 4; ++components)
  {
    for (const bool isGradient : { false, true })
    {
      Studio studio;
      Messages messages(studio.tracer);
      studio.tracer->SetInputData(makeSquare());
      vtkNew<vtkImageData> image;
      image->SetDimensions(1, 1, 1);
      if (components > 0)
      {
        image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
        image->GetPointData()->GetScalars()->Fill(9.0);
        studio.tracer->SetBackgroundImage(image);
      }
      studio.tracer->SetBackground(0.0, isGradient ? 0.0 : 0.5, 0.0);
      studio.tracer->SetBackground2(0.0, isGradient ? 0.5 : 0.0, 0.0);
      studio.tracer->SetGradientBackground(isGradient);
      studio.tracer->Update();
      if (components % 2 == 0)
      {
        EXPECT_TRUE(messages.warnings().empty());
        continue;
      }
      expectMessage(messages.warnings(),
        { "SetBackground() has no effect", "no alpha", "SetBackgroundImage()",
          "GradientBackgroundOff()" });

      messages.clear();
      studio.tracer->SetBackground(0.0, 0.0, 0.0); // the remedy
      studio.tracer->GradientBackgroundOff();
      studio.tracer->SetBackground2(0.0, 0.0, 0.0);
      studio.tracer->Update();
      EXPECT_TRUE(messages.warnings().empty());
    }
  }
}

TEST(IdleBackgrounds, WithoutGradientAreNamed)
{
  Studio studio;
  Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeSquare());
  studio.tracer->SetBackground2(0.0, 0.0, 0.5);
  studio.tracer->Update();
  expectMessage(
    messages.warnings(), { "SetBackground2() has no effect", "GradientBackgroundOn()" });

  messages.clear();
  studio.tracer->GradientBackgroundOn(); // the remedy
  studio.tracer->Update();
  studio.tracer->GradientBackgroundOff();
  studio.tracer->SetBackground2(-1.0, -2.0, -3.0); // equal to the background
  studio.tracer->Update();
  EXPECT_TRUE(messages.warnings().empty());
}
