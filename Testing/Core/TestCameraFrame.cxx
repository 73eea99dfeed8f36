// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraFrame.h"
#include "RandomNumbers.h"

#include <gtest/gtest.h>

using namespace lambent;

namespace
{
constexpr double pi = 3.14159265358979323846;

Camera makeCamera(RandomNumbers& random)
{
  Camera camera;
  camera.position = random.inBox(5.0);
  camera.focalPoint = random.inBox(5.0);
  camera.viewUp = random.inBox(1.0);
  return camera;
}
}

TEST(CameraFrame, IsOrthonormalAndRightHanded)
{
  RandomNumbers random(1);
  for (int k = 0; k < 200; ++k)
  {
    const Camera camera = makeCamera(random);
    const CameraFrame frame(camera, 40, 30);
    EXPECT_NEAR(length(frame.right), 1.0, 1e-15);
    EXPECT_NEAR(length(frame.up), 1.0, 1e-15);
    EXPECT_NEAR(length(frame.forward), 1.0, 1e-15);
    EXPECT_NEAR(dot(frame.right, frame.up), 0.0, 1e-15);
    EXPECT_NEAR(dot(frame.up, frame.forward), 0.0, 1e-15);
    EXPECT_NEAR(length(cross(frame.right, frame.up) + frame.forward), 0.0, 1e-15);
    EXPECT_GT(dot(frame.up, camera.viewUp), 0.0);
    EXPECT_NEAR(dot(frame.right, camera.viewUp), 0.0, 1e-14);
    EXPECT_EQ(frame.eye, camera.position);
  }
}

// The view angle spans the edges of the image, half a pixel outside the outer rays.
TEST(CameraFrame, RaysSpanTheViewAngle)
{
  Camera camera;
  camera.viewAngle = 50.0;
  const double edge = std::tan(25.0 * pi / 180.0);
  const CameraFrame vertical(camera, 64, 20);
  EXPECT_NEAR(vertical.y(19) + 0.5 * vertical.pixel, edge, 1e-15);
  EXPECT_NEAR(vertical.y(0) - 0.5 * vertical.pixel, -edge, 1e-15);
  EXPECT_NEAR(vertical.x(63) + 0.5 * vertical.pixel, edge * 64.0 / 20.0, 1e-15);
  camera.horizontalViewAngle = true;
  const CameraFrame horizontal(camera, 64, 20);
  EXPECT_NEAR(horizontal.x(63) + 0.5 * horizontal.pixel, edge, 1e-15);
  EXPECT_NEAR(horizontal.y(19) + 0.5 * horizontal.pixel, edge * 20.0 / 64.0, 1e-15);
  camera.parallel = true; // the horizontal angle has no effect here
  camera.parallelScale = 3.0;
  const CameraFrame parallel(camera, 64, 20);
  EXPECT_EQ(parallel.y(19) + 0.5 * parallel.pixel, 3.0);
  EXPECT_NEAR(parallel.x(0) - 0.5 * parallel.pixel, -3.0 * 64.0 / 20.0, 1e-14);
}

TEST(CameraFrame, RaysAreSymmetric)
{
  for (int size : { 1, 2, 37, 64 })
  {
    const CameraFrame frame(Camera(), size, size);
    for (int i = 0; i < size; ++i)
    {
      EXPECT_EQ(frame.x(i), -frame.x(size - 1 - i));
      EXPECT_EQ(frame.y(i), frame.x(i));
    }
  }
}

// A window centre of 1 moves the image's centre to its edge.
TEST(CameraFrame, WindowCenter)
{
  Camera camera;
  camera.windowCenter[0] = 1.0;
  camera.windowCenter[1] = -0.5;
  const CameraFrame frame(camera, 40, 20);
  EXPECT_EQ(frame.x(0), 0.5 * frame.pixel);
  EXPECT_NEAR(frame.y(14) + 0.5 * frame.pixel, 0.0, 1e-16);
}

TEST(CameraFrame, TransformsToTheFrameAndBack)
{
  RandomNumbers random(2);
  for (int k = 0; k < 200; ++k)
  {
    Camera camera = makeCamera(random);
    camera.parallel = k % 2 == 0;
    const CameraFrame frame(camera, 40, 30);
    const Vec3 point = random.inBox(9.0);
    const FramePoint p = frame.toFrame(point);
    EXPECT_NEAR(p.z, dot(point - camera.position, frame.forward), 1e-13);
    EXPECT_EQ(p.w, camera.parallel ? 1.0 : p.z);
    const Vec3 back = frame.fromEye(p.x / p.w, p.y / p.w, p.z);
    EXPECT_NEAR(length(back - (point - camera.position)), 0.0, 1e-12);
  }
}

TEST(CameraFrame, DefectsAreFound)
{
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const auto defect = [](auto&& spoil)
  {
    Camera camera;
    spoil(camera);
    return findDefect(camera);
  };
  EXPECT_EQ(findDefect(Camera()), CameraDefect::None);
  EXPECT_EQ(defect([&](Camera& c) { c.position.x = notANumber; }), CameraDefect::NotFinite);
  EXPECT_EQ(defect([&](Camera& c) { c.focalPoint.y = infinite; }), CameraDefect::NotFinite);
  EXPECT_EQ(defect([&](Camera& c) { c.viewUp.z = notANumber; }), CameraDefect::NotFinite);
  EXPECT_EQ(defect([&](Camera& c) { c.windowCenter[1] = infinite; }), CameraDefect::NotFinite);
  EXPECT_EQ(defect([&](Camera& c) { c.viewAngle = notANumber; }), CameraDefect::NotFinite);
  EXPECT_EQ(defect([](Camera& c) { c.viewAngle = 0.0; }), CameraDefect::ViewAngle);
  EXPECT_EQ(defect([](Camera& c) { c.viewAngle = 180.0; }), CameraDefect::ViewAngle);
  EXPECT_EQ(defect([](Camera& c) { c.viewAngle = 179.9; }), CameraDefect::None);
  EXPECT_EQ(defect([](Camera& c) { c.parallelScale = 0.0; }), CameraDefect::None);
  EXPECT_EQ(defect(
              [](Camera& c)
              {
                c.parallel = true;
                c.viewAngle = 0.0;
              }),
    CameraDefect::None);
  EXPECT_EQ(defect(
              [](Camera& c)
              {
                c.parallel = true;
                c.parallelScale = 0.0;
              }),
    CameraDefect::ParallelScale);
  EXPECT_EQ(defect([](Camera& c) { c.focalPoint = c.position; }), CameraDefect::NoDirection);
  EXPECT_EQ(defect([](Camera& c) { c.viewUp = Vec3(0.0); }), CameraDefect::ViewUp);
  EXPECT_EQ(defect([](Camera& c) { c.viewUp = Vec3(0.0, 0.0, -2.0); }), CameraDefect::ViewUp);
  EXPECT_EQ(defect([](Camera& c) { c.viewUp = Vec3(1e-9, 0.0, 1.0); }), CameraDefect::None);
}

// Seen from the framed camera, the bounding sphere touches the edges of the shorter side.
TEST(CameraFrame, FramingTouchesTheBoundingSphere)
{
  Bounds bounds;
  bounds.add(Vec3(1.0, 2.0, 3.0));
  bounds.add(Vec3(2.0, 5.0, 3.5));
  const Vec3 center(1.5, 3.5, 3.25);
  const double radius = 0.5 * std::sqrt(1.0 + 9.0 + 0.25);
  RandomNumbers random(3);
  for (int k = 0; k < 40; ++k)
  {
    Camera camera = makeCamera(random);
    camera.viewAngle = 70.0;
    camera.horizontalViewAngle = k % 2 != 0;
    const int width = k % 4 < 2 ? 200 : 50, height = 100;
    const Camera framed = frameBounds(camera, bounds, width, height);
    EXPECT_EQ(framed.focalPoint, center);
    EXPECT_EQ(framed.viewAngle, 30.0);
    EXPECT_EQ(framed.viewUp, camera.viewUp);
    const CameraFrame frame(framed, width, height);
    EXPECT_NEAR(
      length(frame.forward - normalized(camera.focalPoint - camera.position)), 0.0, 1e-14);
    const double sine = radius / length(framed.position - center);
    const double tangent = 0.5 * std::min(width, height) * frame.pixel;
    EXPECT_NEAR(sine, tangent / std::sqrt(1.0 + tangent * tangent), 1e-14);
    // The same holds in a parallel view.
    EXPECT_NEAR(framed.parallelScale * std::min(1.0, width / 100.0), radius, 1e-14);
  }
}

TEST(CameraFrame, FramingEmptyBoundsChangesNothing)
{
  RandomNumbers random(4);
  const Camera camera = makeCamera(random);
  const Camera framed = frameBounds(camera, Bounds(), 30, 20);
  EXPECT_EQ(framed.position, camera.position);
  EXPECT_EQ(framed.focalPoint, camera.focalPoint);
}
