// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// An unusable setting causes an error with its name and the remedy. The output is then empty, and
// the next good picture is right.
#include "ExpectedErrors.h"
#include "Meshes.h"

#include "vtkMatrix4x4.h"
#include "vtkTransform.h"

#include <limits>

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();
}

TEST(BadSettings, ImageSize)
{
  const int sizes[][2] = { { 0, 5 }, { 5, 0 }, { 0, 0 }, { -1, 5 }, { 5, -1 } };
  for (const auto& size : sizes)
  {
    expectError([&](Studio& s) { s.tracer->SetImageSize(size[0], size[1]); },
      { "image size", std::to_string(size[0]) + " x " + std::to_string(size[1]), "at least 1",
        "SetImageSize()" },
      [](Studio& s) { s.tracer->SetImageSize(32, 24); });
  }
}

TEST(BadSettings, Supersampling)
{
  for (const int samples : { -1, 0, 17, VTK_INT_MAX })
  {
    expectError([&](Studio& s) { s.tracer->SetSupersampling(samples); },
      { "supersampling is " + std::to_string(samples), "1 to 16", "SetSupersampling()" },
      [](Studio& s) { s.tracer->SetSupersampling(1); });
  }
}

TEST(BadSettings, FeatureAngle)
{
  const auto spoil = [](Studio& s)
  {
    s.tracer->UsePointNormalsOff(); // the angle matters to computed normals
    s.tracer->SetFeatureAngle(notANumber);
  };
  expectError(spoil,
    { "feature angle is not a finite number", "SetFeatureAngle()", "0 to 180 degrees" },
    [](Studio& s)
    {
      s.tracer->UsePointNormalsOn();
      s.tracer->SetFeatureAngle(30.0);
    });
}

TEST(BadSettings, TooManySamplesForAnInteger)
{
  const auto spoil = [](Studio& s)
  {
    s.tracer->SetImageSize(1, VTK_INT_MAX / 16 + 1);
    s.tracer->SetSupersampling(16);
  };
  expectError(spoil,
    { "2147483647 samples", "1 x 134217728", "16 x 16", "SetImageSize()", "SetSupersampling()" },
    [](Studio& s)
    {
      s.tracer->SetImageSize(32, 24);
      s.tracer->SetSupersampling(1);
    });
}

TEST(BadSettings, ImageTooLargeForTheMemory)
{
  const int sizes[][2] = { { 1000000, 1000000 }, { VTK_INT_MAX, VTK_INT_MAX },
    { VTK_INT_MAX, 100000 } };
  for (const auto& size : sizes)
  {
    expectError([&](Studio& s) { s.tracer->SetImageSize(size[0], size[1]); },
      { "not enough memory", std::to_string(size[0]) + " x " + std::to_string(size[1]),
        "SetImageSize()", "in parts" },
      [](Studio& s) { s.tracer->SetImageSize(32, 24); });
  }
}

// A part of an image too large for the memory can still be rendered.
TEST(BadSettings, PartOfAnImageTooLargeForTheMemory)
{
  Studio studio(1000000, 1000000);
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeSquare());
  const int extent[6] = { 500000, 500009, 499990, 499999, 0, 0 };
  studio.tracer->UpdateExtent(extent);
  EXPECT_EQ(Picture(studio.tracer->GetOutput()).count(Studio::background()), 0);
  EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 100);
  EXPECT_TRUE(messages.errors().empty());
}

TEST(BadSettings, CameraThatIsNotFinite)
{
  const std::vector<Change> changes{
    [](Studio& s) { s.camera->SetPosition(0.0, notANumber, 5.0); },
    [](Studio& s) { s.camera->SetFocalPoint(infinite, 0.0, 0.0); },
    [](Studio& s) { s.camera->SetViewUp(0.0, notANumber, 0.0); },
    [](Studio& s) { s.camera->SetViewAngle(notANumber); },
    [](Studio& s) { s.camera->SetWindowCenter(0.0, infinite); },
    [](Studio& s)
    {
      s.camera->ParallelProjectionOn();
      s.camera->SetParallelScale(notANumber);
    },
  };
  for (const Change& change : changes)
  {
    expectError(change, { "camera", "not a finite number", "SetPosition()", "SetWindowCenter()" },
      [](Studio& s)
      {
        vtkNew<vtkCamera> fresh;
        s.camera->DeepCopy(fresh);
        s.camera->SetPosition(0.0, 0.0, 5.0);
      });
  }
}

TEST(BadSettings, ViewAngle)
{
  // vtkCamera clamps the argument of SetViewAngle() to [1e-8, 179.9], but a subclass need not.
  class Camera : public vtkCamera
  {
  public:
    static Camera* New() { return new Camera; }
    void SetAnyViewAngle(double angle)
    {
      this->ViewAngle = angle;
      this->Modified();
    }
  };
  for (double angle : { 0.0, -30.0, 180.0, 400.0 })
  {
    vtkNew<Camera> camera;
    camera->SetAnyViewAngle(angle);
    expectError([&](Studio& s) { s.tracer->SetCamera(camera); },
      { "view angle", std::to_string(angle), "between 0 and 180", "SetViewAngle()" },
      [](Studio& s) { s.tracer->SetCamera(s.camera); });
  }
}

TEST(BadSettings, ParallelScale)
{
  for (double scale : { 0.0, -1.0 })
  {
    expectError(
      [&](Studio& s)
      {
        s.camera->ParallelProjectionOn();
        s.camera->SetParallelScale(scale);
      },
      { "parallel scale", std::to_string(scale), "must be positive", "SetParallelScale()" },
      [](Studio& s) { s.camera->ParallelProjectionOff(); });
  }
}

TEST(BadSettings, CameraWithoutADirection)
{
  // vtkCamera keeps the two points 1e-20 apart, which is lost in rounding except near the origin.
  expectError([](Studio& s) { s.camera->SetFocalPoint(0.0, 0.0, 5.0); },
    { "position and focal point coincide", "SetPosition()", "SetFocalPoint()" },
    [](Studio& s) { s.camera->SetFocalPoint(0.0, 0.0, 0.0); });
}

TEST(BadSettings, ViewUpParallelToTheView)
{
  for (const Vec& up : { Vec(0.0, 0.0, 1.0), Vec(0.0, 0.0, -3.0), Vec(1e-12, 0.0, 1.0) })
  {
    expectError([&](Studio& s) { s.camera->SetViewUp(up.x, up.y, up.z); },
      { "view-up", "parallel to its view direction", "SetViewUp()" },
      [](Studio& s) { s.camera->SetViewUp(0.0, 1.0, 0.0); });
  }
}

TEST(BadSettings, LightThatIsNotFinite)
{
  const std::vector<std::function<void(vtkLight*)>> changes{
    [](vtkLight* light) { light->SetPosition(0.0, notANumber, 0.0); },
    [](vtkLight* light) { light->SetFocalPoint(infinite, 0.0, 0.0); },
    [](vtkLight* light) { light->SetColor(1.0, notANumber, 0.0); },
    [](vtkLight* light) { light->SetIntensity(infinite); },
    [](vtkLight* light) { light->SetConeAngle(notANumber); },
    [](vtkLight* light) { light->SetAttenuationValues(1.0, 0.0, notANumber); },
    [](vtkLight* light)
    {
      vtkNew<vtkMatrix4x4> matrix;
      matrix->SetElement(1, 2, notANumber);
      light->SetTransformMatrix(matrix);
    },
  };
  for (const auto& change : changes)
  {
    auto good = makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 });
    auto bad = makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 });
    good->SwitchOff(); // it keeps its number even if it is off
    change(bad);
    expectError(
      [&](Studio& s)
      {
        s.tracer->AddLight(good);
        s.tracer->AddLight(bad);
      },
      { "Light 1 ", "not a finite number", "position", "transform matrix", "attenuation" },
      [](Studio& s) { s.tracer->RemoveAllLights(); });
    // A bad light is harmless while it is off.
    bad->SwitchOff();
    Studio studio;
    const Messages messages(studio.tracer);
    studio.tracer->SetInputData(makeSphere(6));
    studio.tracer->AddLight(bad);
    EXPECT_EQ(render(studio.tracer).at(16, 12), Vec(0.0));
    EXPECT_TRUE(messages.errors().empty());
  }
}

// The light would be divided by zero: NaN or infinity.
TEST(BadSettings, LightWithoutAPositiveAttenuation)
{
  for (const Vec& values : { Vec(0.0), Vec(0.0, -1.0, 0.0), Vec(-1.0, -0.5, -2.0) })
  {
    auto good = makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, Vec(1.0), true);
    auto bad = makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, Vec(1.0), true);
    bad->SetAttenuationValues(values.x, values.y, values.z);
    expectError(
      [&](Studio& s)
      {
        s.tracer->AddLight(good);
        s.tracer->AddLight(bad);
      },
      { "Light 1 ", "no positive attenuation value", "SetAttenuationValues(1, 0, 0)" },
      [](Studio& s) { s.tracer->RemoveAllLights(); });
  }
  // Attenuation does not matter for an infinitely distant light, nor does a single value of 0.
  auto far = makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 });
  far->SetAttenuationValues(0.0, 0.0, 0.0);
  auto near = makeLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, 0.0 }, Vec(1.0), true);
  near->SetAttenuationValues(0.0, 0.0, 0.25);
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeSquare());
  studio.tracer->AddLight(far);
  studio.tracer->AddLight(near);
  EXPECT_GT(render(studio.tracer).at(16, 12).x, 1.2);
  EXPECT_TRUE(messages.errors().empty());
}

TEST(BadSettings, PropertyThatIsNotFinite)
{
  const std::vector<std::function<void(vtkProperty*)>> changes{
    [](vtkProperty* property) { property->SetDiffuseColor(0.0, notANumber, 0.0); },
    [](vtkProperty* property) { property->SetAmbientColor(infinite, 0.0, 0.0); },
  };
  for (const auto& change : changes)
  {
    vtkNew<vtkProperty> bad;
    change(bad);
    bad->SetDiffuse(1.0);
    bad->SetAmbient(1.0);
    expectError(
      [&](Studio& s)
      {
        s.tracer->AddInputDataObject(makeSquare());
        s.tracer->SetInputProperty(1, bad);
      },
      { "Input 1:", "vtkProperty", "not a finite number", "SetColor()", "SetDiffuse()" },
      [](Studio& s)
      {
        s.tracer->SetInputProperty(1, nullptr);
        s.tracer->RemoveInputConnection(0, 1);
      });
  }
}

TEST(BadSettings, BackgroundThatIsNotFinite)
{
  expectError([](Studio& s) { s.tracer->SetBackground(0.0, infinite, 0.0); },
    { "background", "not a finite number", "SetBackground()", "SetBackground2()" },
    [](Studio& s) { s.tracer->SetBackground(-1.0, -2.0, -3.0); });
  expectError(
    [](Studio& s)
    {
      s.tracer->GradientBackgroundOn();
      s.tracer->SetBackground2(notANumber, 0.0, 0.0);
    },
    { "background", "not a finite number", "SetBackground()", "SetBackground2()" },
    [](Studio& s) { s.tracer->GradientBackgroundOff(); });
}

// One warning names all camera settings that are not supported.
TEST(BadSettings, UnsupportedCameraSettingsCauseAWarning)
{
  vtkNew<vtkTransform> transform;
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, 1.0);
  const std::vector<std::pair<std::string, std::function<void(vtkCamera*)>>> settings{
    { ": UserTransform.", [&](vtkCamera* camera) { camera->SetUserTransform(transform); } },
    { ": UserViewTransform.", [&](vtkCamera* camera) { camera->SetUserViewTransform(transform); } },
    { ": ModelTransformMatrix.",
      [&](vtkCamera* camera) { camera->SetModelTransformMatrix(matrix); } },
    { ": UseOffAxisProjection.", [](vtkCamera* camera) { camera->UseOffAxisProjectionOn(); } },
    { ": UseExplicitProjectionTransformMatrix.",
      [&](vtkCamera* camera)
      {
        camera->SetExplicitProjectionTransformMatrix(matrix);
        camera->UseExplicitProjectionTransformMatrixOn();
      } },
    { ": ViewShear.", [](vtkCamera* camera) { camera->SetViewShear(0.1, 0.0, 1.0); } },
    { ": UserTransform, ViewShear.",
      [&](vtkCamera* camera)
      {
        camera->SetUserTransform(transform);
        camera->SetViewShear(0.0, 0.1, 1.0);
      } },
  };
  for (const auto& setting : settings)
  {
    Studio studio;
    const Messages messages(studio.tracer);
    studio.tracer->SetInputData(makeSphere(6));
    setting.second(studio.camera);
    EXPECT_NE(render(studio.tracer).at(16, 12), Studio::background());
    expectMessage(messages.warnings(), { "camera", "not supported", setting.first });
    EXPECT_TRUE(messages.errors().empty());
  }
}
