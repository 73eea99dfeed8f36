// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of samples around spheres, and their bounds in space.
#include "Bounds.h"
#include "FilmPicture.h"
#include "InstructionSets.h"
#include "RandomNumbers.h"
#include "SphereBoxKernel.h"

#include <limits>

using namespace lambent;

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();
}

// A box contains all samples whose rays hit, and hardly more: a margin of one sample is left
// wherever it is not cut off.
TEST(SphereBoxes, AreTight)
{
  onAllTargets(
    []()
    {
      RandomNumbers random(3);
      std::size_t boxes = 0;
      for (int k = 0; k < 3000; ++k)
      {
        Camera camera;
        camera.position = Vec3(0.0);
        camera.focalPoint = { 0.0, 0.0, -1.0 };
        camera.parallel = k % 3 == 0;
        camera.parallelScale = 1.0;
        camera.viewAngle = random.within(5.0, 60.0);
        const CameraFrame frame(camera, 60, 40);
        const PointLattice lattice(frame, { 0, 60, 0, 40 });
        ASSERT_TRUE(haveSphereBoxes(lattice));
        SphereBoxes found;
        found.count = 1;
        found.centers[0][0] = random.within(-2.0, 2.0);
        found.centers[1][0] = random.within(-2.0, 2.0);
        found.centers[2][0] = random.within(-3.0, 1.0);
        found.radii[0] = random.within(0.05, 1.5);
        findSphereBoxes(lattice, found);
        const FramePoint c =
          frame.toFrame({ found.centers[0][0], found.centers[1][0], found.centers[2][0] });
        Window hits{ 60, 0, 40, 0 };
        for (int pixel = 0; pixel < 60 * 40; ++pixel)
        {
          const int i = pixel % 60, j = pixel / 60;
          SphereHit hit{};
          if (intersectSphere({ c.x, c.y, c.z, found.radii[0], true, true }, frame.x(i), frame.y(j),
                frame.parallel, hit))
          {
            hits = { std::min(hits.i0, i), std::max(hits.i1, i + 1), std::min(hits.j0, j),
              std::max(hits.j1, j + 1) };
            EXPECT_GE(hit.depth, found.nearest[0]);
          }
        }
        if (hits.i1 - hits.i0 < 8 || hits.j1 - hits.j0 < 8 || c.z < found.radii[0])
        {
          continue; // too small for its extreme points to be seen, or cut by the plane of the eye
        }
        ++boxes;
        EXPECT_LE(found.i0[0], hits.i0);
        EXPECT_GE(found.i1[0], hits.i1);
        EXPECT_LE(found.j0[0], hits.j0);
        EXPECT_GE(found.j1[0], hits.j1);
        if (hits.i0 > 0 && hits.i1 < 60 && hits.j0 > 0 && hits.j1 < 40)
        {
          EXPECT_GE(found.i0[0], hits.i0 - 2) << k;
          EXPECT_LE(found.i1[0], hits.i1 + 2) << k;
          EXPECT_GE(found.j0[0], hits.j0 - 2) << k;
          EXPECT_LE(found.j1[0], hits.j1 + 2) << k;
        }
      }
      EXPECT_GT(boxes, 500u);
    });
}

TEST(SphereBoxes, BehindTheEyeAreEmpty)
{
  Camera camera;
  camera.position = Vec3(0.0);
  camera.focalPoint = { 0.0, 0.0, -1.0 };
  for (const bool parallel : { false, true })
  {
    camera.parallel = parallel;
    const PointLattice lattice(CameraFrame(camera, 30, 20), { 0, 30, 0, 20 });
    SphereBoxes boxes;
    boxes.count = 2;
    boxes.centers[2][0] = boxes.centers[2][1] = 2.0; // behind
    boxes.radii[0] = 1.9;
    boxes.radii[1] = 2.5;
    findSphereBoxes(lattice, boxes);
    EXPECT_LE(boxes.i1[0], boxes.i0[0]);
    EXPECT_EQ(boxes.i0[1], 0);
    EXPECT_EQ(boxes.i1[1], 30);
  }
}

TEST(SphereBoxes, BoundsIncludeTheRadius)
{
  const float points[9] = { 1, 2, 3, -4, 5, 6, 0, 0, 0 };
  const double radii[3] = { 1.0, 2.0, notANumber };
  Surface surface;
  surface.points = { points, false, 3 };
  surface.radius = 2.0;
  surface.radii = { radii, true, 3 };
  const Bounds bounds = findBounds({ surface }, Parallel());
  EXPECT_EQ(bounds.low, Vec3(-8, 0, 1));
  EXPECT_EQ(bounds.high, Vec3(3, 9, 10));
}

// As for triangles: counted, and not drawn.
TEST(SphereBoxes, CentersThatAreNotFiniteAreReported)
{
  const double points[9] = { 0, 0, 0, infinite, 0, 0, 0, notANumber, 0 };
  RandomScene random;
  random.width = random.height = 16;
  Surface surface;
  surface.points = { points, true, 3 };
  surface.radius = 0.5;
  random.scene.camera.position = { 0.0, 0.0, 5.0 };
  random.scene.surfaces = { surface };
  std::vector<std::uint32_t> primitives(256);
  Image image;
  image.width = image.height = 16;
  image.part = whole(random);
  std::vector<float> floats(3 * primitives.size());
  image.floats = floats.data();
  image.primitives = primitives.data();
  for (const Settings& settings : { Settings(), Settings::bruteForce(image.part) })
  {
    const Report report = render(random.scene, image, Parallel(), nullptr, settings);
    EXPECT_EQ(report.outcome, Outcome::Done);
    EXPECT_EQ(report.defects.notFinite, 2u);
    EXPECT_EQ(report.defects.firstNotFinite, 1u);
  }
}
