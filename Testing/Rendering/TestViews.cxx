// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Where objects appear: a convex mesh covers the pixels whose centres lie in the convex hull of its
// projected points, in every kind of view.
#include "Meshes.h"

#include <algorithm>

namespace
{
double cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

/// The convex hull, counter-clockwise, by A. M. Andrew's monotone chain (1979).
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points)
{
  std::sort(points.begin(), points.end(),
    [](const glm::dvec2& a, const glm::dvec2& b)
    { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<glm::dvec2> hull;
  for (int side = 0; side < 2; ++side)
  {
    const std::size_t start = hull.size();
    for (const glm::dvec2& p : points)
    {
      while (hull.size() >= start + 2 &&
        cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The depth of a point inside the hull, in pixels; negative outside.
double depthInside(const std::vector<glm::dvec2>& hull, const glm::dvec2& p)
{
  double depth = 1e9;
  for (std::size_t k = 0; k < hull.size(); ++k)
  {
    const glm::dvec2 edge = hull[(k + 1) % hull.size()] - hull[k];
    depth = std::min(depth, cross(edge, p - hull[k]) / glm::length(edge));
  }
  return depth;
}

/// Returns the number of covered pixels.
int expectSilhouette(Studio& studio, vtkPolyData* mesh)
{
  studio.tracer->SetInputData(mesh);
  const Picture picture = render(studio.tracer);
  std::vector<glm::dvec2> projected;
  for (const Vec& point : pointsOf(mesh))
  {
    projected.push_back(studio.project(point));
  }
  const std::vector<glm::dvec2> hull = convexHull(projected);
  int covered = 0;
  for (int j = 0; j < studio.height(); ++j)
  {
    for (int i = 0; i < studio.width(); ++i)
    {
      const double depth = depthInside(hull, { i + 0.5, j + 0.5 });
      const bool isHit = picture.at(i, j) != Studio::background();
      EXPECT_EQ(isHit, depth > 0.0) << pixelName(i, j) << ", " << depth << " pixels inside";
      covered += isHit;
    }
  }
  return covered;
}

/// A box, a cylinder and a sphere, entirely or partly in view.
void expectSilhouettes(Studio& studio)
{
  const int most = studio.width() * studio.height();
  for (const Mesh& mesh : { makeBox(0.5, 0.7, 0.9), makeCylinder(9), makeSphere(8) })
  {
    const int covered = expectSilhouette(studio, mesh);
    EXPECT_GT(covered, most / 100);
    EXPECT_LT(covered, most);
  }
}
}

TEST(Views, Perspective)
{
  Studio studio(45, 31);
  studio.look({ 2.0, 3.0, 5.0 }, { 0.1, 0.2, 0.0 }, { 0.3, 1.0, 0.0 });
  expectSilhouettes(studio);
  studio.camera->SetViewAngle(80.0);
  expectSilhouettes(studio);
}

TEST(Views, PerspectiveOfATallImage)
{
  Studio studio(21, 53);
  studio.look({ -2.0, 1.0, 5.0 }, { 0.1, 0.2, 0.0 }, { 0.3, 1.0, 0.0 });
  expectSilhouettes(studio);
}

TEST(Views, HorizontalViewAngle)
{
  for (const auto& size : { std::pair<int, int>{ 45, 31 }, { 21, 53 } })
  {
    Studio studio(size.first, size.second);
    studio.look({ 2.0, 3.0, 5.0 }, { 0.1, 0.2, 0.0 });
    studio.camera->UseHorizontalViewAngleOn();
    expectSilhouettes(studio);
  }
}

TEST(Views, Parallel)
{
  for (const auto& size : { std::pair<int, int>{ 45, 31 }, { 21, 53 } })
  {
    Studio studio(size.first, size.second);
    studio.look({ 2.0, 3.0, 5.0 }, { 0.1, 0.2, 0.0 }, { 0.3, 1.0, 0.0 });
    studio.camera->ParallelProjectionOn();
    studio.camera->SetParallelScale(1.75);
    expectSilhouettes(studio);
  }
}

TEST(Views, WindowCenter)
{
  for (int parallel : { 0, 1 })
  {
    Studio studio(45, 31);
    studio.look({ 2.0, 3.0, 5.0 }, { 0.1, 0.2, 0.0 });
    studio.camera->SetParallelProjection(parallel);
    studio.camera->SetParallelScale(1.75);
    studio.camera->SetWindowCenter(0.375, -0.25);
    expectSilhouettes(studio);
  }
}

// The clipping range clips nothing.
TEST(Views, ClippingRangeIsIgnored)
{
  Studio studio(45, 31);
  studio.camera->SetClippingRange(100.0, 200.0);
  expectSilhouettes(studio);
}

// Nothing behind the eye is visible; of a surface that passes it, only the part in front is.
TEST(Views, BehindTheEye)
{
  for (int parallel : { 0, 1 })
  {
    Studio studio(21, 21);
    studio.camera->SetParallelProjection(parallel);
    studio.look({ 0.0, 0.0, 5.0 }, { 0.0, 0.0, 6.0 });
    studio.tracer->SetInputData(makeSphere(8));
    EXPECT_EQ(render(studio.tracer).count(Studio::background()), 21 * 21);
  }
  // A floor that extends from far behind the eye to far in front of it covers the lower half.
  Studio studio(21, 20);
  studio.tracer->SetInputData(
    makeMesh({ { -1e4, -1.0, 1e4 }, { 1e4, -1.0, 1e4 }, { 1e4, -1.0, -1e6 }, { -1e4, -1.0, -1e6 } },
      { { 0, 1, 2, 3 } }));
  const Picture picture = render(studio.tracer);
  for (int j = 0; j < 20; ++j)
  {
    for (int i = 0; i < 21; ++i)
    {
      EXPECT_EQ(picture.at(i, j) != Studio::background(), j < 10) << pixelName(i, j);
    }
  }
}

// Row 0 is the bottom one, column 0 the left one.
TEST(Views, Orientation)
{
  Studio studio(20, 20);
  studio.property->LightingOff();
  studio.tracer->SetInputData(
    makeMesh({ { 0.0, 0.0, 0.0 }, { 9.0, 0.0, 0.0 }, { 9.0, 9.0, 0.0 }, { 0.0, 9.0, 0.0 } },
      { { 0, 1, 2, 3 } }));
  const Picture picture = render(studio.tracer);
  for (int j = 0; j < 20; ++j)
  {
    for (int i = 0; i < 20; ++i)
    {
      EXPECT_EQ(picture.at(i, j) == Vec(1.0), i >= 10 && j >= 10) << pixelName(i, j);
    }
  }
}

TEST(Views, Background)
{
  Studio studio(3, 8);
  studio.tracer->SetInputData(makeMesh({}, {}));
  studio.tracer->SetBackground(0.25, 0.5, 2.0);
  studio.tracer->SetBackground2(1.0, 0.0, -1.0);
  EXPECT_EQ(render(studio.tracer).count({ 0.25, 0.5, 2.0 }), 24);
  studio.tracer->GradientBackgroundOn();
  const Picture gradient = render(studio.tracer);
  for (int j = 0; j < 8; ++j)
  {
    const double up = (j + 0.5) / 8.0; // from the bottom edge to the top edge
    const Vec expected = (1.0 - up) * Vec(0.25, 0.5, 2.0) + up * Vec(1.0, 0.0, -1.0);
    expectColor(gradient.at(1, j), expected, pixelName(1, j));
  }
  studio.tracer->SetOutputScalarTypeToUnsignedChar();
  EXPECT_EQ(render(studio.tracer).at(0, 7),
    Vec(std::floor(255.0 * (0.25 + 0.75 * 7.5 / 8.0) + 0.5),
      std::floor(255.0 * 0.5 * 0.5 / 8.0 + 0.5), 0.0));
}

// The nearest of two surfaces is visible, in any order; at the same depth, the first is.
TEST(Views, NearestWins)
{
  Studio studio(9, 9);
  const Mesh near = makeSquare(100.0, 1.0), far = makeSquare(100.0, 0.0);
  vtkNew<vtkProperty> red, green;
  red->SetColor(1.0, 0.0, 0.0);
  green->SetColor(0.0, 1.0, 0.0);
  for (vtkProperty* property : { red.Get(), green.Get() })
  {
    property->LightingOff();
  }
  studio.tracer->SetInputProperty(0, red);
  studio.tracer->SetInputProperty(1, green);
  const auto seen = [&](vtkPolyData* first, vtkPolyData* second)
  {
    studio.tracer->RemoveAllInputConnections(0);
    studio.tracer->AddInputDataObject(first);
    studio.tracer->AddInputDataObject(second);
    return render(studio.tracer);
  };
  EXPECT_EQ(seen(near, far).count({ 1.0, 0.0, 0.0 }), 81);
  EXPECT_EQ(seen(far, near).count({ 0.0, 1.0, 0.0 }), 81);
  EXPECT_EQ(seen(near, near).count({ 1.0, 0.0, 0.0 }), 81);
}
