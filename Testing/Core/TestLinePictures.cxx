// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Which pixels lines cover, and the surface points on them.
#include "LinesOnRays.h"
#include "RandomNumbers.h"
#include "SurfacePoints.h"

#include <limits>

using namespace lambent;

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();
}

// Rays at halves: a width of 1 covers one row, a width of 2 centred between two rows covers both.
TEST(Lines, CoverTheirWidthInPixels)
{
  for (const double width : { 1.0, 2.0, 3.0, 7.0, 50.0 })
  {
    const double y = static_cast<int>(width) % 2 ? 0.5 : 0.0;
    const LinesOnRays scene({ { -20.5, y, 0.0 }, { 20.5, y, 0.0 } }, width - 0.001);
    const FilmPicture picture = scene.picture();
    int rows = 0, columns = 0;
    for (int k = 0; k < 64; ++k)
    {
      rows += LinesOnRays::isHit(picture, 32, k);
      columns += LinesOnRays::isHit(picture, k, 32);
    }
    EXPECT_EQ(rows, static_cast<int>(width)) << width;
    const double half = 0.5 * (width - 0.001);
    const double cap = std::sqrt(half * half - (0.5 - y) * (0.5 - y));
    EXPECT_EQ(columns, std::min(64, 2 * static_cast<int>(std::floor(20.5 + cap + 0.5)))) << width;
  }
}

TEST(Lines, PointsAreDiscs)
{
  const double width = 21.3;
  const LinesOnRays scene({ { 0.2, -0.3, 0.0 }, { 0.2, -0.3, 0.0 } }, width);
  const FilmPicture picture = scene.picture();
  for (int j = 0; j < 64; ++j)
  {
    for (int i = 0; i < 64; ++i)
    {
      const double x = i - 31.5 - 0.2, y = j - 31.5 + 0.3;
      EXPECT_EQ(LinesOnRays::isHit(picture, i, j), x * x + y * y <= 0.25 * width * width);
    }
  }
}

// The samples near a joint: all that are within half the width of the polyline are covered.
TEST(Lines, JointsHaveNoGaps)
{
  RandomNumbers random(3);
  for (int k = 0; k < 300; ++k)
  {
    const Vec3 a = random.inBox(30.0), joint = random.inBox(5.0);
    const Vec3 b = k % 2 ? random.inBox(30.0) : joint * 2.0 - a; // straight on
    const double width = random.within(1.0, 20.0);
    const FilmPicture picture = LinesOnRays({ a, joint, joint, b }, width).picture();
    for (int j = 0; j < 64; ++j)
    {
      for (int i = 0; i < 64; ++i)
      {
        const double x = i - 31.5 - joint.x, y = j - 31.5 - joint.y;
        if (std::sqrt(x * x + y * y) < 0.5 * width - 1e-9)
        {
          ASSERT_TRUE(LinesOnRays::isHit(picture, i, j)) << k;
        }
      }
    }
  }
}

// A line on a sloping plane: at every scale the same pixels show the line.
TEST(Lines, OnAPlaneAreVisibleAtEveryScale)
{
  for (const double slope : { 0.0, 0.5, -1.0, 3.0 })
  {
    std::vector<std::uint32_t> first;
    for (const double scale : { 1e-6, 1.0, 1e7 })
    {
      LinesOnRays scene({ { -25.0, 5.3, slope * 5.3 }, { 25.0, -7.1, slope * -7.1 } }, 3.0, scale);
      std::vector<double> plane;
      for (const double corner : { -60.0, 60.0 })
      {
        plane.insert(plane.end(), { -60.0 * scale, corner * scale, slope * corner * scale });
        plane.insert(plane.end(), { 60.0 * scale, corner * scale, slope * corner * scale });
      }
      const std::int32_t corners[] = { 0, 1, 2, 1, 3, 2 };
      Surface face;
      face.points = { plane.data(), true, 4 };
      face.corners = { corners, false, 6 };
      const FilmPicture alone = scene.picture();
      scene.random.scene.surfaces.push_back(face);
      const FilmPicture both = scene.picture();
      const auto count = [](const FilmPicture& picture)
      { return std::count(picture.primitives.begin(), picture.primitives.end(), 0u); };
      EXPECT_GE(2 * count(both), count(alone)) << slope << ", " << scale;
      if (slope == 0.0)
      {
        EXPECT_EQ(count(both), count(alone));
      }
      if (first.empty())
      {
        first = both.primitives;
      }
      EXPECT_TRUE(both.primitives == first) << slope << ", " << scale;
      // Each column between the ends shows it.
      for (int i = 8; i < 56; ++i)
      {
        int rows = 0;
        for (int j = 0; j < 64; ++j)
        {
          rows += both.primitives[64 * j + i] == 0;
        }
        EXPECT_GE(rows, 1) << slope << ", " << scale << ", column " << i;
      }
    }
  }
}

namespace
{
/// The surface point of the ray through a pixel of a scene with one line.
SurfacePoint pointIn(const LinesOnRays& scene, int i, int j)
{
  const SceneMesh mesh(scene.random.scene.surfaces);
  const CameraFrame frame(scene.random.scene.camera, 64, 64);
  const FrameMesh inFrame(mesh, frame);
  return SurfacePoints(inFrame, false).at(0, frame.x(i), frame.y(j));
}

void expectNear(const Vec3& found, const Vec3& expected)
{
  EXPECT_LT(length(found - expected), 1e-12)
    << found.x << " " << found.y << " " << found.z << " instead of " << expected.x << " "
    << expected.y << " " << expected.z;
}
}

TEST(Lines, NormalsArePerpendicularAndLookAtTheViewer)
{
  const Vec3 a(-8.0, 0.5, -8.0), b(8.0, 0.5, 8.0);
  for (const bool isTurned : { false, true })
  {
    const LinesOnRays sloping({ isTurned ? b : a, isTurned ? a : b }, 5.0);
    expectNear(normalized(pointIn(sloping, 34, 32).normal), normalized({ -1.0, 0.0, 1.0 }));
  }
  expectNear(pointIn(LinesOnRays({ a, a }, 5.0), 24, 32).normal, { 0.0, 0.0, 1.0 });
  const Vec3 behind(-8.0, 0.5, -20.0);
  expectNear(pointIn(LinesOnRays({ a, behind }, 5.0), 24, 32).normal, { 0.0, 0.0, 1.0 });
}

TEST(Lines, RoundedNormalsAreThoseOfATube)
{
  LinesOnRays flat({ { -8.0, 0.5, 0.0 }, { 8.0, 0.5, 0.0 } }, 10.0);
  flat.random.scene.surfaces[0].isRounded = true;
  expectNear(pointIn(flat, 32, 35).normal, { 0.0, 0.6, 0.8 });
  expectNear(pointIn(flat, 32, 28).normal, { 0.0, -0.8, 0.6 });
  expectNear(pointIn(flat, 43, 32).normal, { 0.7, 0.0, std::sqrt(0.51) }); // on a cap
  LinesOnRays point({ { 0.5, 0.5, 0.0 }, { 0.5, 0.5, 0.0 } }, 10.0);
  point.random.scene.surfaces[0].isRounded = true;
  expectNear(pointIn(point, 35, 32).normal, { 0.6, 0.0, 0.8 });
  expectNear(pointIn(point, 32, 28).normal, { 0.0, -0.8, 0.6 });
}

// A tube that slopes by 45 degrees: its nearer end hides a part of its side, its farther one is
// hidden by it.
TEST(Lines, RoundedNormalsOfASlopingTube)
{
  const Vec3 far(-8.0, 0.5, -8.0), near(8.0, 0.5, 8.0), side = normalized({ -1.0, 0.0, 1.0 });
  for (const bool isTurned : { false, true })
  {
    LinesOnRays tube({ isTurned ? near : far, isTurned ? far : near }, 10.0);
    tube.random.scene.surfaces[0].isRounded = true;
    const auto normal = [&](int i) { return normalized(pointIn(tube, i, 32).normal); };
    expectNear(normal(19), { -0.9, 0.0, std::sqrt(0.19) });
    expectNear(normal(22), side);
    expectNear(normal(32), side);
    expectNear(normal(38), { -0.3, 0.0, std::sqrt(0.91) });
    expectNear(normal(41), { 0.3, 0.0, std::sqrt(0.91) });
    expectNear(normalized(pointIn(tube, 32, 35).normal), Vec3(0.0, 0.6, 0.0) + side * 0.8);
  }
}

TEST(Lines, GivenNormalsAreInterpolatedAndTurnedToTheViewer)
{
  const float normals[] = { 1.0f, 0.0f, 1.0f, 0.0f, 1.0f, 1.0f };
  LinesOnRays scene({ { -8.0, 0.5, 0.0 }, { 8.0, 0.5, 0.0 } }, 5.0);
  Surface& surface = scene.random.scene.surfaces[0];
  surface.pointNormals = { normals, false, 2 };
  const SurfacePoint point = pointIn(scene, 33, 32);
  expectNear(point.weights, { 6.5 / 16.0, 9.5 / 16.0, 0.0 });
  expectNear(point.normal, { 6.5 / 16.0, 9.5 / 16.0, 1.0 });
  const float away[] = { -1.0f, 0.0f, -1.0f, 0.0f, -1.0f, -1.0f };
  surface.pointNormals = { away, false, 2 };
  expectNear(pointIn(scene, 33, 32).normal, point.normal);
  surface.appearance.shading = Shading::Flat;
  expectNear(pointIn(scene, 33, 32).normal, { 0.0, 0.0, 1.0 });
}

// Each cell counts once, however many of its lines have the point.
TEST(Lines, PointsThatAreNotFiniteAreCountedByCell)
{
  LinesOnRays scene({ { 0.0, 0.0, 0.0 }, { notANumber, 0.0, 0.0 }, { notANumber, 0.0, 0.0 },
                      { 3.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 },
                      { infinite, 0.0, 0.0 }, { infinite, 0.0, 0.0 }, { 5.0, 0.0, 0.0 } },
    1.0);
  const std::int64_t cells[] = { 7, 7, 7, 7, 8 };
  scene.random.scene.surfaces[0].cells = cells;
  std::vector<unsigned char> bytes(3 * 64 * 64);
  Image image;
  image.width = image.height = 64;
  image.part = { 0, 64, 0, 64 };
  image.bytes = bytes.data();
  const MeshDefects defects = render(scene.random.scene, image).defects;
  EXPECT_EQ(defects.notFinite, 2u);
  EXPECT_EQ(defects.firstNotFinite, 0u);
  scene.corners[5] = 10;
  const Report report = render(scene.random.scene, image);
  EXPECT_EQ(report.outcome, Outcome::BadMesh);
  EXPECT_EQ(report.defects.wrongCorner, 2u);
}
