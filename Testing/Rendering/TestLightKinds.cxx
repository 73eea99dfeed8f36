// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The meaning of vtkLight's settings, as in its documentation and VTK's own renderer. A white plane
// z = 0 with diffuse 1 is lit and seen from above. Its pixels show the cosine times the arriving
// light.
#include "Meshes.h"

#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkTransform.h"

namespace
{
struct Plane : Studio
{
  Plane()
    : Studio(9, 9)
  {
    this->tracer->SetInputData(makeSquare());
    this->property->SetInterpolationToFlat();
  }

  vtkSmartPointer<vtkLight> light(const Vec& position, const Vec& focalPoint, bool positional)
  {
    auto added = makeLight(position, focalPoint, Vec(1.0), positional);
    this->tracer->AddLight(added);
    return added;
  }

  Vec point(int i, int j) const
  {
    const Ray seen = this->ray(i, j);
    return seen.origin - seen.direction * (seen.origin.z / seen.direction.z);
  }

  /// The cosine at the plane for a light in the direction s.
  static double cosine(const Vec& s) { return std::max(0.0, s.z / glm::length(s)); }

  /// Expects value(point) at every pixel, in all channels.
  template <typename Function>
  void expectEverywhere(const Function& value)
  {
    const Picture picture = render(this->tracer);
    for (int j = 0; j < this->height(); ++j)
    {
      for (int i = 0; i < this->width(); ++i)
      {
        expectColor(picture.at(i, j), Vec(value(this->point(i, j))), pixelName(i, j));
      }
    }
  }
};
}

TEST(LightKinds, WithoutLightsThereIsAHeadlight)
{
  Plane plane;
  plane.look({ 2.0, 1.0, 5.0 }, { 0.5, 0.0, 1.0 });
  const double facing = plane.cosine(-plane.forward());
  plane.expectEverywhere([&](const Vec&) { return facing; });
  plane.look({ -3.0, 0.0, 4.0 }, { 0.0, 0.0, 0.0 });
  plane.expectEverywhere([](const Vec&) { return 0.8; });
}

TEST(LightKinds, AllSwitchedOffIsDark)
{
  Plane plane;
  auto light = plane.light({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, false);
  plane.property->SetAmbient(1.0);
  light->SwitchOff();
  plane.expectEverywhere([](const Vec&) { return 0.0; });
  plane.light({ 0.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 }, false)->SetIntensity(0.5);
  plane.expectEverywhere([](const Vec&) { return 0.5 * (0.8 + 1.0); });
  light->SwitchOn();
  plane.expectEverywhere([](const Vec&) { return 0.5 * (0.8 + 1.0) + 2.0; });
}

TEST(LightKinds, HeadlightMovesWithTheCamera)
{
  Plane plane;
  plane.look({ 2.0, 1.0, 5.0 }, { 0.5, 0.0, 1.0 });
  auto light = plane.light({ 70.0, 80.0, 90.0 }, { -1.0, -2.0, -3.0 }, false);
  light->SetLightTypeToHeadlight();
  const double facing = plane.cosine(-plane.forward());
  plane.expectEverywhere([&](const Vec&) { return facing; });

  light->PositionalOn(); // it is then at the camera's position
  plane.expectEverywhere([&](const Vec& p) { return plane.cosine(plane.position() - p); });

  // The caller's light is not modified.
  EXPECT_EQ(glm::make_vec3(light->GetPosition()), Vec(70.0, 80.0, 90.0));
  EXPECT_EQ(light->GetTransformMatrix(), nullptr);
}

TEST(LightKinds, PositionalHeadlightHasItsConeAroundTheViewDirection)
{
  Plane plane;
  plane.camera->SetViewAngle(60.0);
  auto light = plane.light({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, true);
  light->SetLightTypeToHeadlight();
  light->SetConeAngle(20.0);
  light->SetExponent(0.0);
  plane.expectEverywhere(
    [&](const Vec& p)
    {
      const Vec s = plane.position() - p;
      return plane.cosine(s) < std::cos(20.0 * pi / 180.0) ? 0.0 : plane.cosine(s);
    });
}

// In camera space the camera is at (0, 0, 1) and looks at the origin, y is up, and the unit is the
// distance to the focal point.
TEST(LightKinds, CameraLightIsInCameraSpace)
{
  Plane plane;
  plane.look({ 2.0, 1.0, 5.0 }, { 0.5, 0.0, 1.0 }, { 0.3, 1.0, 0.1 });
  auto light = plane.light({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, false);
  light->SetLightTypeToCameraLight();
  light->SetPosition(0.5, 0.25, 1.5);
  light->SetFocalPoint(0.1, -0.2, 0.25);
  const Vec focalPoint(0.5, 0.0, 1.0);
  const double unit = glm::length(plane.position() - focalPoint);
  const auto toWorld = [&](double x, double y, double z)
  { return focalPoint + unit * (x * plane.right() + y * plane.up() - z * plane.forward()); };
  const Vec lamp = toWorld(0.5, 0.25, 1.5), target = toWorld(0.1, -0.2, 0.25);
  plane.expectEverywhere([&](const Vec&) { return plane.cosine(lamp - target); });
  light->PositionalOn();
  light->SetConeAngle(90.0);
  plane.expectEverywhere([&](const Vec& p) { return plane.cosine(lamp - p); });
}

// The same, with VTK's own matrix.
TEST(LightKinds, CameraLightIsWhereVTKPutsIt)
{
  Plane plane;
  plane.look({ -1.0, 1.0, 6.0 }, { 0.5, 0.2, 1.0 }, { 0.3, 1.0, 0.1 });
  auto light = plane.light({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, true);
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.5, 0.25, 0.75);
  light->SetConeAngle(90.0);
  const double position[4] = { -0.5, 0.25, 0.75, 1.0 };
  double world[4];
  plane.camera->GetCameraLightTransformMatrix()->MultiplyPoint(position, world);
  const Vec lamp = glm::make_vec3(world) / world[3];
  plane.expectEverywhere([&](const Vec& p) { return plane.cosine(lamp - p); });
}

TEST(LightKinds, SceneLightIsMovedByItsMatrix)
{
  Plane plane;
  vtkNew<vtkTransform> move;
  move->Translate(0.5, -1.0, 2.0);
  move->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  move->Scale(1.0, 1.5, 2.0);
  auto light = plane.light({ 0.25, 0.5, 0.75 }, { 0.0, 0.1, -0.5 }, true);
  light->SetTransformMatrix(move->GetMatrix());
  double lamp[3], target[3];
  light->GetTransformedPosition(lamp);
  light->GetTransformedFocalPoint(target);
  plane.expectEverywhere([&](const Vec& p) { return plane.cosine(glm::make_vec3(lamp) - p); });
  light->PositionalOff();
  const Vec s = glm::make_vec3(lamp) - glm::make_vec3(target);
  plane.expectEverywhere([&](const Vec&) { return plane.cosine(s); });
}

TEST(LightKinds, DirectionalLightIgnoresConeAndAttenuation)
{
  Plane plane;
  auto light = plane.light({ 0.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 }, false);
  light->SetConeAngle(1.0);
  light->SetExponent(5.0);
  light->SetAttenuationValues(2.0, 3.0, 4.0);
  plane.expectEverywhere([](const Vec&) { return 0.8; });
}

TEST(LightKinds, Attenuation)
{
  Plane plane;
  const Vec lamp(0.3, 0.2, 1.5), a(0.5, 0.25, 0.125);
  plane.light(lamp, { 0.0, 0.0, 0.0 }, true)->SetAttenuationValues(a.x, a.y, a.z);
  plane.property->SetAmbient(0.5); // attenuation applies to both terms
  plane.expectEverywhere(
    [&](const Vec& p)
    {
      const double d = glm::length(lamp - p);
      return (plane.cosine(lamp - p) + 0.5) / (a.x + a.y * d + a.z * d * d);
    });
}

// By default a positional vtkLight is a spot light of 30 degrees.
TEST(LightKinds, ConeOfThirtyDegreesByDefault)
{
  Plane plane;
  plane.camera->SetViewAngle(50.0);
  const Vec lamp(0.5, 0.25, 2.0), target(0.2, -0.1, 0.0);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(lamp.x, lamp.y, lamp.z);
  light->SetFocalPoint(target.x, target.y, target.z);
  light->PositionalOn();
  plane.tracer->AddLight(light);
  plane.property->SetAmbient(0.25);
  int lit = 0;
  plane.expectEverywhere(
    [&](const Vec& p)
    {
      const Vec s = lamp - p;
      const double cosine = glm::dot(glm::normalize(s), glm::normalize(lamp - target));
      const bool inside = std::acos(cosine) <= 30.0 * pi / 180.0;
      lit += inside;
      return inside ? cosine * (plane.cosine(s) + 0.25) : 0.0; // vtkLight's exponent is 1
    });
  EXPECT_GT(lit, 10);
  EXPECT_LT(lit, 60);
}

TEST(LightKinds, ConeExponents)
{
  for (double exponent : { 0.0, 0.5, 1.0, 2.0, 7.25, 64.0 })
  {
    Plane plane;
    const Vec lamp(0.5, 0.25, 2.0);
    auto light = plane.light(lamp, { 0.0, 0.0, 0.0 }, true);
    light->SetConeAngle(75.0);
    light->SetExponent(exponent);
    light->SetAttenuationValues(0.75, 0.5, 0.0);
    plane.expectEverywhere(
      [&](const Vec& p)
      {
        const double d = glm::length(lamp - p);
        const double cosine = glm::dot((lamp - p) / d, glm::normalize(lamp));
        return std::pow(cosine, exponent) * plane.cosine(lamp - p) / (0.75 + 0.5 * d);
      });
  }
}

TEST(LightKinds, NinetyDegreesAndMoreShineInAllDirections)
{
  for (double angle : { 90.0, 91.0, 180.0 })
  {
    Plane plane;
    const Vec lamp(0.5, 0.25, 1.0);
    auto light = plane.light(lamp, { 0.5, 0.25, 3.0 }, true); // aimed away from the plane
    light->SetConeAngle(angle);
    light->SetExponent(3.0);
    plane.expectEverywhere([&](const Vec& p) { return plane.cosine(lamp - p); });
    light->SetConeAngle(89.9);
    plane.expectEverywhere([](const Vec&) { return 0.0; });
  }
}

TEST(LightKinds, ColourIsTheDiffuseOne)
{
  Plane plane;
  plane.property->SetAmbient(0.5);
  auto light = plane.light({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, false);
  light->SetAmbientColor(0.1, 0.2, 0.3);
  light->SetSpecularColor(0.4, 0.5, 0.6);
  light->SetDiffuseColor(0.2, 0.4, 1.0);
  light->SetIntensity(0.5);
  expectColor(render(plane.tracer).at(4, 4), 1.5 * 0.5 * Vec(0.2, 0.4, 1.0), "plane");
}

TEST(LightKinds, LightsCanBeRemoved)
{
  Plane plane;
  auto first = plane.light({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, false);
  auto second = plane.light({ 0.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 }, false);
  EXPECT_EQ(plane.tracer->GetLights()->GetNumberOfItems(), 2);
  plane.expectEverywhere([](const Vec&) { return 1.8; });
  plane.tracer->RemoveLight(first);
  plane.expectEverywhere([](const Vec&) { return 0.8; });
  plane.tracer->RemoveAllLights();
  EXPECT_EQ(plane.tracer->GetLights()->GetNumberOfItems(), 0);
  plane.expectEverywhere([](const Vec&) { return 1.0; }); // the headlight again
}
