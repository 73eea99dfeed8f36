// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The light model on a sphere, a cylinder and a box. Each pixel is compared with the formula at the
// known point of the shape, with the known normal there.
#include "Meshes.h"

namespace
{
const Vec red(0.9, 0.2, 0.1), dim(0.05, 0.1, 0.2), white(1.0);

/// The parameter at which a ray enters the unit sphere, or NaN.
double enterSphere(const Ray& ray)
{
  const double a = glm::dot(ray.direction, ray.direction);
  const double b = glm::dot(ray.origin, ray.direction);
  const double c = glm::dot(ray.origin, ray.origin) - 1.0;
  return (-b - std::sqrt(b * b - a * c)) / a;
}
}

// At a vertex the interpolated normal is the vertex's own, which is known for a sphere. Each vertex
// in turn is at the centre of the image.
TEST(LightOnSolids, SphereAtItsVertices)
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

// A fine mesh is as close to the true sphere as its facets are small.
TEST(LightOnSolids, SphereAsAWhole)
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
      else if (facing > 0.2) // otherwise the facet's depth matters more
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
/// A cylinder of seven facets, seen from outside along rays in its middle plane. Each pixel shows a
/// known point of a known facet.
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

TEST(LightOnSolids, CylinderFlat)
{
  expectCylinder(false);
}

TEST(LightOnSolids, CylinderSmooth)
{
  expectCylinder(true);
}

TEST(LightOnSolids, BoxFlat)
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
      // By slabs: the last of the three entries, if it precedes the first exit.
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
