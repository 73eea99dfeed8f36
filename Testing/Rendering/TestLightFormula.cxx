// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The light model on a plane. Each pixel is compared with the formula at the point where its ray
// hits the plane, by trigonometry.
#include "Meshes.h"

namespace
{
const Vec red(0.9, 0.2, 0.1), dim(0.05, 0.1, 0.2), white(1.0);

/// The point where a ray hits the plane z = 0.
Vec meetPlane(const Ray& ray)
{
  return ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
}

/// Compares every pixel of a plane in a view with the sum over the lights.
void expectPlane(Studio& studio, const std::vector<vtkSmartPointer<vtkLight>>& lights)
{
  studio.tracer->SetInputData(makeSquare());
  for (const auto& light : lights)
  {
    studio.tracer->AddLight(light);
  }
  const Vec diffuse = glm::make_vec3(studio.property->GetDiffuseColor());
  const Vec ambient = glm::make_vec3(studio.property->GetAmbientColor());
  const Picture picture = render(studio.tracer);
  for (int j = 0; j < studio.height(); ++j)
  {
    for (int i = 0; i < studio.width(); ++i)
    {
      const Vec point = meetPlane(studio.ray(i, j));
      Vec expected(0.0);
      for (const auto& light : lights)
      {
        const Vec position = glm::make_vec3(light->GetPosition());
        const Vec s = light->GetPositional() ? position - point
                                             : position - glm::make_vec3(light->GetFocalPoint());
        const Vec color = glm::make_vec3(light->GetDiffuseColor()) * light->GetIntensity();
        expected += reflected(diffuse, ambient, color, s, { 0.0, 0.0, 1.0 });
      }
      expectColor(picture.at(i, j), expected, pixelName(i, j));
    }
  }
}
}

TEST(LightFormula, PlaneInPerspectiveUnderADirectionalLight)
{
  Studio studio;
  studio.look({ 1.0, -2.0, 6.0 }, { 0.5, 0.25, 0.0 }, { 0.2, 1.0, 0.0 });
  studio.reflect(red, dim);
  expectPlane(studio, { makeLight({ 1.0, 2.0, 3.0 }, { 0.0, 0.5, -1.0 }) });
}

TEST(LightFormula, PlaneInPerspectiveUnderAPositionalLight)
{
  Studio studio;
  studio.look({ 1.0, -2.0, 6.0 }, { 0.5, 0.25, 0.0 }, { 0.2, 1.0, 0.0 });
  studio.reflect(red, dim);
  expectPlane(studio, { makeLight({ 0.5, 0.5, 1.5 }, { 0.0, 0.0, 0.0 }, white, true) });
}

TEST(LightFormula, PlaneInAParallelView)
{
  Studio studio;
  studio.look({ -3.0, 2.0, 4.0 }, { 0.0, 0.0, 0.0 });
  studio.camera->ParallelProjectionOn();
  studio.camera->SetParallelScale(1.7);
  studio.reflect(red, dim);
  expectPlane(studio,
    { makeLight({ 0.5, 0.5, 1.5 }, { 0.0, 0.0, 0.0 }, white, true),
      makeLight({ 4.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, white) });
}

TEST(LightFormula, SeveralColouredLightsAddUp)
{
  Studio studio;
  studio.look({ 0.0, -1.0, 3.0 }, { 0.0, 0.0, 0.0 });
  studio.reflect(red, dim);
  auto weak = makeLight({ -2.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, { 0.3, 0.9, 0.4 });
  weak->SetIntensity(0.35);
  auto strong = makeLight({ 0.0, 0.0, 0.7 }, { 0.0, 0.0, 0.0 }, { 0.9, 0.3, 0.4 }, true);
  strong->SetIntensity(2.5); // floats are not clamped
  expectPlane(studio,
    { weak, strong, makeLight({ 0.0, 2.0, 1.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, true) });
}

TEST(LightFormula, LightBehindThePlaneLeavesTheAmbientTerm)
{
  Studio studio;
  studio.reflect(red, dim);
  studio.tracer->SetInputData(makeSquare());
  studio.tracer->AddLight(makeLight({ 0.5, 0.0, -1.0 }, { 0.0, 0.0, 0.0 }, { 0.5, 1.0, 2.0 }));
  const Picture picture = render(studio.tracer);
  expectColor(picture.at(3, 4), dim * Vec(0.5, 1.0, 2.0), "plane");
}

TEST(LightFormula, RedSurfaceInGreenLightIsBlack)
{
  Studio studio;
  studio.reflect({ 1.0, 0.0, 0.0 }, Vec(0.0));
  studio.tracer->SetInputData(makeSquare());
  studio.tracer->AddLight(makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }));
  const Picture picture = render(studio.tracer);
  EXPECT_EQ(picture.count(Vec(0.0)), 32 * 24);
}

TEST(LightFormula, CoefficientsMultiplyTheColours)
{
  Studio studio;
  studio.property->SetDiffuseColor(red.x, red.y, red.z);
  studio.property->SetDiffuse(0.4);
  studio.property->SetAmbientColor(0.25, 0.5, 1.0);
  studio.property->SetAmbient(0.3);
  studio.tracer->SetInputData(makeSquare());
  studio.tracer->AddLight(makeLight({ 0.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 }));
  const Picture picture = render(studio.tracer);
  expectColor(picture.at(7, 7), 0.4 * red * 0.8 + 0.3 * Vec(0.25, 0.5, 1.0), "plane");
}

TEST(LightFormula, AmbientModels)
{
  Studio studio;
  studio.reflect(red, dim);
  studio.tracer->SetInputData(makeSquare());
  const Vec lights[2] = { { 0.5, 0.25, 1.0 }, { 0.0, 2.0, 0.5 } };
  for (const Vec& light : lights)
  {
    studio.tracer->AddLight(makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, light));
  }
  const Vec both = lights[0] + lights[1];
  expectColor(render(studio.tracer).at(0, 0), (red + dim) * both, "per light");
  studio.tracer->SetAmbientModelToScene();
  expectColor(render(studio.tracer).at(0, 0), red * both + dim, "scene");
  studio.tracer->RemoveAllLights();
  studio.tracer->AddLight(makeLight({ 0.0, 0.0, -1.0 }, { 0.0, 0.0, 0.0 }));
  expectColor(render(studio.tracer).at(0, 0), dim, "scene, light from behind");
  studio.tracer->SetAmbientModelToPerLight();
  expectColor(render(studio.tracer).at(0, 0), dim, "per light, light from behind");
}

TEST(LightFormula, BytesAreRoundedAndClamped)
{
  Studio studio(256, 4);
  studio.property->LightingOff();
  studio.tracer->SetOutputScalarTypeToUnsignedChar();
  studio.tracer->SetInputData(makeSquare());
  for (double value :
    { 0.0, 0.5 / 255.0 - 1e-9, 0.5 / 255.0 + 1e-9, 0.5, 200.49 / 255.0, 200.51 / 255.0, 1.0 })
  {
    studio.property->SetColor(value, 1.0 - value, value);
    const Vec bytes(std::floor(255.0 * value + 0.5), std::floor(255.0 * (1.0 - value) + 0.5),
      std::floor(255.0 * value + 0.5));
    EXPECT_EQ(render(studio.tracer).at(9, 1), bytes) << value;
  }
  studio.property->LightingOn();
  studio.property->SetColor(1.0, 0.6, 0.25);
  auto light = makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 });
  light->SetIntensity(2.0);
  studio.tracer->AddLight(light);
  EXPECT_EQ(render(studio.tracer).at(9, 1), Vec(255.0, 255.0, 128.0));
}
