// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The light model on shapes whose points and normals are known without a mesh: each
// pixel is compared with the formula, at the point where trigonometry says that its
// ray meets the shape.
#include "Meshes.h"

namespace
{
const Vec red(0.9, 0.2, 0.1), dim(0.05, 0.1, 0.2), white(1.0);

/// Where a ray meets the plane z = 0.
Vec meetPlane(const Ray& ray)
{
  return ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
}

/// The parameter at which a ray enters the unit sphere, or NaN.
double enterSphere(const Ray& ray)
{
  const double a = glm::dot(ray.direction, ray.direction);
  const double b = glm::dot(ray.origin, ray.direction);
  const double c = glm::dot(ray.origin, ray.origin) - 1.0;
  return (-b - std::sqrt(b * b - a * c)) / a;
}

/// Every pixel of a plane in a view, against the sum of what the lights give.
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
  studio.property->SetSpecular(1.0); // not of this model
  studio.property->SetOpacity(0.5);
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

// At a vertex the interpolated normal is the vertex's own, and that of a sphere is
// known: each vertex in turn is brought to the centre of the image.
TEST(LightFormula, SphereAtItsVertices)
{
  Studio studio(5, 5);
  studio.reflect(red, dim);
  const Vec lamp(2.0, 3.0, 1.5);
  const Mesh sphere = makeSphere(12);
  studio.tracer->SetInputData(sphere);
  studio.tracer->AddLight(makeLight(lamp, { 0.0, 0.0, 0.0 }, white, true));
  for (const Vec& point : pointsOf(sphere))
  {
    studio.look(3.0 * point, point, { 0.3, 0.2, 1.0 });
    expectColor(
      render(studio.tracer).at(2, 2), reflected(red, dim, white, lamp - point, point), "sphere");
  }
}

// A fine mesh comes as near to the true sphere as its facets are small.
TEST(LightFormula, SphereAsAWhole)
{
  Studio studio;
  studio.look({ 1.0, 2.0, 4.0 }, { 0.1, 0.0, 0.0 });
  studio.reflect(red, dim);
  const Vec lamp(2.0, 3.0, 1.5);
  studio.tracer->SetInputData(makeSphere(600));
  studio.tracer->AddLight(makeLight(lamp, { 0.0, 0.0, 0.0 }, white, true));
  const Picture picture = render(studio.tracer);
  int covered = 0;
  for (int j = 0; j < studio.height(); ++j)
  {
    for (int i = 0; i < studio.width(); ++i)
    {
      const Ray ray = studio.ray(i, j);
      const Vec point = ray.origin + ray.direction * enterSphere(ray);
      const double facing = -glm::dot(point, glm::normalize(ray.direction));
      if (std::isnan(facing))
      {
        EXPECT_EQ(picture.at(i, j), Studio::background());
      }
      else if (facing > 0.2) // else the facet's depth matters more
      {
        expectColor(
          picture.at(i, j), reflected(red, dim, white, lamp - point, point), pixelName(i, j), 1e-4);
        ++covered;
      }
    }
  }
  EXPECT_GT(covered, 150);
}

namespace
{
/// A cylinder of seven facets, seen from outside along rays in the plane of its
/// middle: each pixel shows a known facet at a known place.
void expectCylinder(bool smooth)
{
  const int n = 7;
  Studio studio(64, 1);
  studio.look({ 0.5, 0.0, 4.0 }, { 0.0, 0.0, 0.0 });
  studio.camera->SetViewAngle(0.5); // of a single row
  studio.reflect(red, dim);
  studio.property->SetInterpolation(smooth ? VTK_PHONG : VTK_FLAT);
  const Vec lamp(2.0, 1.0, 3.0);
  studio.tracer->SetInputData(makeCylinder(n));
  studio.tracer->AddLight(makeLight(lamp, { 0.0, 0.0, 0.0 }, white, true));
  const Picture picture = render(studio.tracer);
  int covered = 0;
  for (int i = 0; i < studio.width(); ++i)
  {
    const Ray ray = studio.ray(i, 0);
    Vec expected = Studio::background();
    double nearest = 1e9;
    for (int k = 0; k < n; ++k)
    {
      const double from = 2.0 * pi * k / n, to = 2.0 * pi * (k + 1) / n;
      const Vec a(std::sin(from), 0.0, std::cos(from)), b(std::sin(to), 0.0, std::cos(to));
      const Vec facet = a + b; // perpendicular to the facet
      const double t = glm::dot(a - ray.origin, facet) / glm::dot(ray.direction, facet);
      const Vec point = ray.origin + t * ray.direction;
      const double u = glm::dot(point - a, b - a) / glm::dot(b - a, b - a);
      if (u >= 0.0 && u <= 1.0 && t < nearest)
      {
        nearest = t;
        const Vec normal = smooth ? a * (1.0 - u) + b * u : facet;
        expected = reflected(red, dim, white, lamp - point, normal);
      }
    }
    covered += nearest < 1e9;
    expectColor(picture.at(i, 0), expected, pixelName(i, 0));
  }
  EXPECT_GT(covered, 20);
  EXPECT_LT(covered, studio.width());
}
}

TEST(LightFormula, CylinderFlat)
{
  expectCylinder(false);
}

TEST(LightFormula, CylinderSmooth)
{
  expectCylinder(true);
}

TEST(LightFormula, BoxFlat)
{
  Studio studio(40, 30);
  studio.look({ 3.0, 4.0, 5.0 }, { 0.0, 0.0, 0.0 });
  studio.reflect(red, dim);
  studio.property->SetInterpolationToFlat();
  const Vec half(1.0, 0.75, 0.5), lamp(1.5, 3.0, 2.5);
  studio.tracer->SetInputData(makeBox(half.x, half.y, half.z));
  studio.tracer->AddLight(makeLight(lamp, { 0.0, 0.0, 0.0 }, white, true));
  const Picture picture = render(studio.tracer);
  int covered = 0;
  for (int j = 0; j < studio.height(); ++j)
  {
    for (int i = 0; i < studio.width(); ++i)
    {
      // By slabs: the last of the three entries, if it comes before the first exit.
      const Ray ray = studio.ray(i, j);
      const Vec a = (-half - ray.origin) / ray.direction, b = (half - ray.origin) / ray.direction;
      const Vec enter = glm::min(a, b), leave = glm::max(a, b);
      const int axis =
        enter.x > enter.y ? (enter.x > enter.z ? 0 : 2) : (enter.y > enter.z ? 1 : 2);
      Vec expected = Studio::background();
      if (enter[axis] < std::min(leave.x, std::min(leave.y, leave.z)))
      {
        const Vec point = ray.origin + enter[axis] * ray.direction;
        Vec normal(0.0);
        normal[axis] = ray.direction[axis] < 0.0 ? 1.0 : -1.0;
        expected = reflected(red, dim, white, lamp - point, normal);
        ++covered;
      }
      expectColor(picture.at(i, j), expected, pixelName(i, j));
    }
  }
  EXPECT_GT(covered, 200);
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
