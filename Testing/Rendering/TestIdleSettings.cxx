// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// A warning names a setting without effect, and what to do instead. It is given once, and never for
// defaults.
#include "Meshes.h"
#include "Messages.h"

#include "vtkMatrix4x4.h"
#include "vtkTexture.h"

#include <functional>

namespace
{
using PropertyChange = std::function<void(vtkProperty*)>;

const std::vector<std::pair<std::vector<std::string>, PropertyChange>>& idleProperties()
{
  static const std::vector<std::pair<std::vector<std::string>, PropertyChange>> settings{
    { { "SetInterpolationToPBR()", "SetInterpolationToPhong()" },
      [](vtkProperty* property) { property->SetInterpolationToPBR(); } },
    { { "SetTexture()", "RemoveAllTextures()" },
      [](vtkProperty* property)
      {
        vtkNew<vtkTexture> texture;
        property->SetTexture("paint", texture);
      } },
  };
  return settings;
}
}

TEST(IdleSettings, CommonPropertyIsNamedOnce)
{
  for (const auto& [parts, change] : idleProperties())
  {
    SCOPED_TRACE(parts.front());
    Studio studio;
    studio.tracer->SetInputData(makeSquare());
    Messages messages(studio.tracer);
    const Picture expected = render(studio.tracer);
    EXPECT_TRUE(messages.warnings().empty());

    change(studio.property);
    const Picture picture = render(studio.tracer);
    std::vector<std::string> all = parts;
    all.insert(all.begin(), "The property of all inputs: vtkProperty::");
    expectMessage(messages.warnings(), all);
    EXPECT_TRUE(messages.errors().empty());
    EXPECT_SAME_BITS(expected, picture);

    for (int k = 0; k < 3; ++k) // not once per picture
    {
      studio.camera->Azimuth(1.0);
      studio.tracer->Update();
    }
    EXPECT_EQ(messages.warnings().size(), 1u);
  }
}

TEST(IdleSettings, InputPropertyIsNamedWithItsInput)
{
  for (const auto& [parts, change] : idleProperties())
  {
    Studio studio;
    const Messages messages(studio.tracer);
    studio.tracer->AddInputDataObject(makeSquare());
    studio.tracer->AddInputDataObject(makeSphere(6));
    vtkNew<vtkProperty> own;
    change(own);
    studio.tracer->SetInputProperty(1, own);
    studio.tracer->Update();
    expectMessage(messages.warnings(), { "Input 1: vtkProperty::", parts.front() });
  }
}

// There may be thousands of inputs that share a property; there is one warning.
TEST(IdleSettings, SharedPropertyIsNamedOnce)
{
  Studio studio;
  Messages messages(studio.tracer);
  vtkNew<vtkProperty> shared, other;
  shared->SetInterpolationToPBR();
  for (int k = 0; k < 5; ++k)
  {
    studio.tracer->AddInputDataObject(makeSquare());
    studio.tracer->SetInputProperty(k, k == 2 ? other.Get() : shared.Get());
  }
  studio.tracer->SetInputProperty(0, other);
  studio.tracer->Update();
  expectMessage(
    messages.warnings(), { "Input 1 and 2 more: vtkProperty::", "SetInterpolationToPBR()" });

  messages.clear();
  vtkNew<vtkTexture> texture;
  other->SetTexture("paint", texture);
  studio.tracer->Update();
  expectMessage(messages.warnings(), { "Input 0 and 1 more: vtkProperty::", "SetTexture()" });

  messages.clear();
  studio.tracer->SetProperty(other);
  studio.tracer->Update(); // the same property, so one message
  expectMessage(messages.warnings(), { "The property of all inputs: vtkProperty::SetTexture()" });
}

// A common property that no input uses causes no warning.
TEST(IdleSettings, UnusedPropertyIsNotNamed)
{
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeSquare());
  vtkNew<vtkProperty> own;
  studio.tracer->SetInputProperty(0, own);
  studio.property->SetInterpolationToPBR();
  studio.tracer->Update();
  EXPECT_TRUE(messages.warnings().empty());
}

TEST(IdleSettings, AreNamedAgainWhenTheyReturn)
{
  Studio studio;
  Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeSquare());
  for (int interpolation : { VTK_PBR, VTK_PBR, VTK_FLAT, VTK_PBR })
  {
    studio.property->SetInterpolation(interpolation);
    studio.property->Modified();
    studio.tracer->Update();
  }
  EXPECT_EQ(messages.warnings().size(), 2u);
}

TEST(IdleSettings, DefaultsAndEffectiveSettingsAreNotNamed)
{
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeSquare());
  studio.property->SetInterpolationToPhong();
  studio.property->SetAmbient(0.5);
  studio.property->SetSpecular(0.5);
  studio.property->SetSpecularPower(30.0);
  studio.property->EdgeVisibilityOn();
  studio.property->SetLineWidth(3.0);
  studio.property->BackfaceCullingOn();
  vtkNew<vtkLight> fresh, head;
  head->SetLightTypeToHeadlight();
  studio.tracer->AddLight(fresh);
  studio.tracer->AddLight(head);
  studio.tracer->Update();
  studio.tracer->SetCamera(nullptr);
  studio.tracer->SetProperty(nullptr);
  studio.tracer->Update();
  EXPECT_TRUE(messages.warnings().empty());
}

TEST(IdleSettings, ALightAtItsOwnFocalPointIsNamed)
{
  for (int kind = 0; kind < 2; ++kind)
  {
    Studio studio;
    const Messages messages(studio.tracer);
    studio.tracer->SetInputData(makeSquare());
    vtkNew<vtkLight> good, bad;
    bad->SetPosition(1.0, 2.0, 3.0);
    bad->SetFocalPoint(1.0, 2.0, 3.0);
    bad->SetPositional(kind == 1); // with the default cone
    good->SwitchOff();             // it keeps its number even if it is off
    studio.tracer->AddLight(good);
    studio.tracer->AddLight(bad);
    EXPECT_EQ(render(studio.tracer).at(16, 12), Vec(0.0));
    expectMessage(messages.warnings(), { "Light 1 ", "its own focal point", "SetFocalPoint()" });
  }
}

// A light that shines in all directions needs no focal point, and a light that is off needs none
// either.
TEST(IdleSettings, ALightThatNeedsNoFocalPointIsNotNamed)
{
  for (int kind = 0; kind < 3; ++kind)
  {
    Studio studio;
    const Messages messages(studio.tracer);
    studio.tracer->SetInputData(makeSquare());
    vtkNew<vtkLight> light;
    light->SetPosition(0.0, 0.0, 2.0);
    light->SetFocalPoint(0.0, 0.0, 2.0);
    light->SetPositional(kind == 0);
    light->SetConeAngle(90.0);
    light->SetSwitch(kind != 1);
    if (kind == 2)
    {
      light->SetLightTypeToHeadlight();
    }
    studio.tracer->AddLight(light);
    EXPECT_EQ(render(studio.tracer).at(16, 12).x > 0.5, kind != 1);
    EXPECT_TRUE(messages.warnings().empty());
  }
}

namespace
{
vtkSmartPointer<vtkPolyData> makeSquareWithNormals()
{
  const auto square = makeSquare();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType k = 0; k < square->GetNumberOfPoints(); ++k)
  {
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
  }
  square->GetPointData()->SetNormals(normals);
  return square;
}

const std::vector<std::pair<std::string, std::function<void(vtkLambentRayTracer*)>>> normalSettings{
  { "SetFeatureAngle()", [](vtkLambentRayTracer* tracer) { tracer->SetFeatureAngle(40.0); } },
  { "SplittingOff()", [](vtkLambentRayTracer* tracer) { tracer->SplittingOff(); } },
};
}

TEST(IdleSettings, NormalSettingsAreNamedIfAllInputsHaveNormals)
{
  for (const auto& [name, change] : normalSettings)
  {
    Studio studio;
    Messages messages(studio.tracer);
    studio.tracer->AddInputDataObject(makeSquareWithNormals());
    studio.tracer->AddInputDataObject(makeSquareWithNormals());
    vtkNew<vtkProperty> flat;
    flat->SetInterpolationToFlat();
    studio.tracer->SetInputProperty(1, flat);
    studio.tracer->Update();
    EXPECT_TRUE(messages.warnings().empty());
    change(studio.tracer);
    studio.tracer->Update();
    expectMessage(messages.warnings(), { name + " has no effect", "UsePointNormalsOff()" });

    messages.clear();
    studio.tracer->UsePointNormalsOff(); // the remedy
    studio.tracer->Update();
    EXPECT_TRUE(messages.warnings().empty());
  }
}

TEST(IdleSettings, NormalSettingsAreNamedIfNothingIsSmooth)
{
  for (const auto& [name, change] : normalSettings)
  {
    for (const bool isLit : { true, false })
    {
      Studio studio;
      Messages messages(studio.tracer);
      studio.tracer->SetInputData(makeSquare());
      isLit ? studio.property->SetInterpolationToFlat() : studio.property->LightingOff();
      change(studio.tracer);
      studio.tracer->Update();
      expectMessage(messages.warnings(),
        { name + " has no effect", "LightingOn()", "SetInterpolationToPhong()" });

      messages.clear();
      studio.property->LightingOn(); // the remedy
      studio.property->SetInterpolationToPhong();
      studio.tracer->Update();
      EXPECT_TRUE(messages.warnings().empty());
    }
  }
}

TEST(IdleSettings, NormalSettingsAreNotNamedIfAnInputNeedsThem)
{
  for (const auto& [name, change] : normalSettings)
  {
    Studio studio;
    const Messages messages(studio.tracer);
    studio.tracer->AddInputDataObject(makeSquareWithNormals());
    studio.tracer->AddInputDataObject(makeSquare());
    change(studio.tracer);
    studio.tracer->Update();
    EXPECT_TRUE(messages.warnings().empty()) << name;
    studio.tracer->RemoveAllInputs();
    studio.tracer->SetInputData(vtkSmartPointer<vtkPolyData>::New()); // nothing to shade
    studio.tracer->Update();
    EXPECT_TRUE(messages.warnings().empty()) << name;
  }
}
