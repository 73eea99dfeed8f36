// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Transforms as settings of connections, and matrices that cannot be used.
#include "ExpectedErrors.h"

#include "vtkMatrix4x4.h"

#include <limits>

namespace
{
void expectErrorForElement(int row, int column, double value, const std::vector<std::string>& parts)
{
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(row, column, value);
  std::vector<std::string> all{ "Input 1: its transform ", "SetInputTransform(1, nullptr)" };
  all.insert(all.end(), parts.begin(), parts.end());
  expectError(
    [&](Studio& studio)
    {
      studio.tracer->AddInputDataObject(makeMesh({}, {})); // also if there is nothing to transform
      studio.tracer->SetInputTransform(1, matrix);
    },
    all, [](Studio& studio) { studio.tracer->SetInputTransform(1, nullptr); });
}
}

TEST(TransformSettings, ThatAreNotFiniteAreAnError)
{
  for (const double value :
    { std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    expectErrorForElement(1, 2, value, { "an element that is not a finite number" });
    expectErrorForElement(2, 3, value, { "an element that is not a finite number" });
  }
}

TEST(TransformSettings, ThatAreSingularAreAnError)
{
  expectErrorForElement(1, 1, 0.0, { "is singular", "Scale each axis" });
}

TEST(TransformSettings, ThatAreProjectiveAreAnError)
{
  for (int column = 0; column < 4; ++column)
  {
    expectErrorForElement(3, column, 2.0, { "a last row other than 0 0 0 1" });
  }
  expectErrorForElement(3, 1, std::numeric_limits<double>::quiet_NaN(), { "0 0 0 1" });
}

TEST(TransformSettings, ThatAreWrongFailResetCamera)
{
  Studio studio;
  vtkNew<vtkMatrix4x4> zero;
  zero->Zero();
  studio.tracer->SetInputData(makeSphere(4));
  studio.tracer->SetInputTransform(0, zero);
  const Messages messages(studio.tracer);
  studio.tracer->ResetCamera();
  expectMessage(messages.errors(), { "Input 0: its transform is singular" });
}

TEST(TransformSettings, BelongToTheirConnections)
{
  Studio studio;
  vtkNew<vtkMatrix4x4> first, second;
  for (int k = 0; k < 3; ++k)
  {
    studio.tracer->AddInputDataObject(makeSphere(4 + k));
  }
  studio.tracer->SetInputTransform(1, first);
  studio.tracer->SetInputProperty(1, studio.property);
  studio.tracer->SetInputTransform(2, second);
  EXPECT_EQ(studio.tracer->GetInputTransform(0), nullptr);
  studio.tracer->RemoveInputConnection(0, 0);
  EXPECT_EQ(studio.tracer->GetInputTransform(0), first);
  EXPECT_EQ(studio.tracer->GetInputProperty(0), studio.property);
  EXPECT_EQ(studio.tracer->GetInputTransform(1), second);
  studio.tracer->SetInputProperty(0, nullptr); // does not drop the transform
  EXPECT_EQ(studio.tracer->GetInputTransform(0), first);
  EXPECT_EQ(first->GetReferenceCount(), 2);
  studio.tracer->RemoveInputConnection(0, 0);
  EXPECT_EQ(first->GetReferenceCount(), 1);
  EXPECT_EQ(studio.tracer->GetInputTransform(0), second);
  studio.tracer->SetInputTransform(0, nullptr);
  EXPECT_EQ(second->GetReferenceCount(), 1);
  const Messages messages(studio.tracer);
  studio.tracer->SetInputTransform(-1, first);
  expectMessage(messages.errors(), { "SetInputTransform() was given connection -1" });
  EXPECT_EQ(studio.tracer->GetInputTransform(-1), nullptr);
}

TEST(TransformSettings, MakeThePictureOutOfDate)
{
  Studio studio;
  vtkNew<vtkMatrix4x4> matrix;
  studio.tracer->SetInputData(makeSphere(6));
  studio.tracer->SetInputTransform(0, matrix);
  const Picture before = render(studio.tracer);
  const vtkMTimeType time = studio.tracer->GetMTime();
  matrix->SetElement(0, 3, 0.5);
  EXPECT_GT(studio.tracer->GetMTime(), time);
  EXPECT_NE(render(studio.tracer).bits(), before.bits());
  studio.tracer->SetInputTransform(0, nullptr);
  EXPECT_SAME_BITS(render(studio.tracer), before);
}
