// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The pass "Normals", compared with geometry.
#include "PassScene.h"

namespace
{
constexpr int width = passWidth, height = passHeight;
}

// On the ball, point normals are interpolated. The box has face normals.
TEST(PassNormals, AreTheUnitNormalsThatShadingUses)
{
  for (const bool isParallel : { false, true })
  {
    const BallAndBox scene(Vec(0.0), isParallel);
    int onBall = 0, onBox = 0;
    for (vtkIdType pixel = 0; pixel < width * height; ++pixel)
    {
      const Ray ray = scene.studio.ray(pixel % width, pixel / width);
      const LongHit hit = scene.rays.find(ray);
      if (!hit.isHit() || !hit.isCertain)
      {
        continue;
      }
      const Vec normal = scene.tuple("Normals", pixel);
      EXPECT_NEAR(glm::length(normal), 1.0, 2e-7);
      if (hit.input == 0)
      {
        vtkDataArray* const normals = scene.meshes[0]->GetPointData()->GetNormals();
        const Vec sum(static_cast<double>(hit.interpolate(normals, 0)),
          static_cast<double>(hit.interpolate(normals, 1)),
          static_cast<double>(hit.interpolate(normals, 2)));
        EXPECT_LT(glm::distance(normal, glm::normalize(sum)), 2e-7);
        EXPECT_LT(glm::distance(normal, glm::normalize(scene.tuple("Positions", pixel))), 0.03);
        ++onBall;
      }
      else
      {
        const Vec axis = glm::abs(normal);
        EXPECT_NEAR(std::max({ axis.x, axis.y, axis.z }), 1.0, 1e-7);
        EXPECT_LT(glm::dot(normal, ray.direction), 0.0);
        ++onBox;
      }
    }
    EXPECT_GT(onBall, 50);
    EXPECT_GT(onBox, 300);
  }
}

// The view is into a tube, whose inside is seen from behind.
TEST(PassNormals, FaceTheViewerWithTwoSidedLighting)
{
  for (const bool isTwoSided : { true, false })
  {
    for (const int interpolation : { VTK_FLAT, VTK_PHONG })
    {
      Studio studio(width, height);
      studio.look({ 0.5, 5.0, 0.25 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
      studio.property->SetInterpolation(interpolation);
      studio.tracer->SetTwoSidedLighting(isTwoSided);
      studio.tracer->SetInputData(makeCylinder(24));
      wantAll(studio);
      studio.tracer->Update();
      int inside = 0;
      for (vtkIdType pixel = 0; pixel < width * height; ++pixel)
      {
        Vec position, normal;
        passOf(studio.tracer->GetOutput(), "Positions")->GetTuple(pixel, &position.x);
        passOf(studio.tracer->GetOutput(), "Normals")->GetTuple(pixel, &normal.x);
        const Vec outwards(position.x, 0.0, position.z);
        const Vec direction = studio.ray(pixel % width, pixel / width).direction;
        if (!std::isnan(position.x) && glm::dot(outwards, direction) > 0.3)
        {
          EXPECT_EQ(glm::dot(normal, outwards) < 0.0, isTwoSided);
          ++inside;
        }
      }
      EXPECT_GT(inside, 100);
    }
  }
}

// Flat and unlit surfaces show face normals, even if they have point normals.
TEST(PassNormals, AreFaceNormalsOnFlatAndUnlitSurfaces)
{
  const Mesh slanted =
    makeMesh({ { -9.0, -9.0, -9.0 }, { 9.0, -9.0, 9.0 }, { 9.0, 9.0, 9.0 }, { -9.0, 9.0, -9.0 } },
      { { 0, 1, 2, 3 } });
  setPointNormals(slanted, std::vector<Vec>(4, Vec(0.0, 0.0, 1.0)));
  for (const bool isLit : { true, false })
  {
    Studio studio(5, 5);
    studio.property->SetInterpolation(isLit ? VTK_FLAT : VTK_PHONG);
    studio.property->SetLighting(isLit);
    studio.tracer->SetInputData(slanted);
    wantAll(studio);
    studio.tracer->Update();
    Vec normal;
    passOf(studio.tracer->GetOutput(), "Normals")->GetTuple(12, &normal.x);
    EXPECT_LT(glm::distance(normal, glm::normalize(Vec(-1.0, 0.0, 1.0))), 1e-7);
  }
}

TEST(PassNormals, AreNaNWhereThePointNormalsAreZero)
{
  const Mesh square = makeSquare();
  setPointNormals(square, std::vector<Vec>(4, Vec(0.0)));
  Studio studio(3, 3);
  studio.tracer->SetInputData(square);
  wantAll(studio);
  studio.tracer->Update();
  for (vtkIdType pixel = 0; pixel < 9; ++pixel)
  {
    EXPECT_EQ(tupleBits(passOf(studio.tracer->GetOutput(), "Normals"), pixel), bitsOfNan<float>(3));
    EXPECT_EQ(passOf(studio.tracer->GetOutput(), "Depth")->GetComponent(pixel, 0), 5.0);
  }
}
