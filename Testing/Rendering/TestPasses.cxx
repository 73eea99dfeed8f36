// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The passes "Depth" and "Positions", compared with geometry, and tests of all passes. The tests of
// the core compare the bits with the definition.
#include "Messages.h"
#include "PassScene.h"

#include "vtkStaticCellLocator.h"

#include <array>

namespace
{
constexpr int width = passWidth, height = passHeight;
}

// The coordinates may be as large as those of maps.
TEST(Passes, DepthsAndPositionsAgreeWithRays)
{
  for (const Vec& place : { Vec(0.0), Vec(691876.25, 5334823.5, 519.125) })
  {
    for (const bool isParallel : { false, true })
    {
      const BallAndBox scene(place, isParallel);
      int hits = 0, uncertain = 0;
      for (vtkIdType pixel = 0; pixel < width * height; ++pixel)
      {
        const Ray ray = scene.studio.ray(pixel % width, pixel / width);
        const LongHit hit = scene.rays.find(ray);
        hits += hit.isHit();
        uncertain += !hit.isCertain;
        if (!hit.isCertain)
        {
          continue;
        }
        if (!hit.isHit())
        {
          expectNothing(scene.image(), pixel);
          continue;
        }
        const auto depth = static_cast<double>(hit.depth);
        EXPECT_NEAR(passOf(scene.image(), "Depth")->GetComponent(pixel, 0), depth, 1e-6 * depth);
        const Vec position = ray.origin + ray.direction * depth;
        EXPECT_LT(glm::distance(scene.tuple("Positions", pixel), position),
          1e-9 + 4e-16 * glm::length(place));
        EXPECT_EQ(passOf(scene.image(), "CellIds")->GetComponent(pixel, 0), hit.cell);
        EXPECT_EQ(passOf(scene.image(), "InputIds")->GetComponent(pixel, 0), hit.input);
      }
      EXPECT_GT(hits, width * height / 4);
      EXPECT_LT(hits, width * height * 9 / 10);
      EXPECT_LT(uncertain, 5);
    }
  }
}

TEST(Passes, CellIdsAndPositionsAgreeWithACellLocator)
{
  const BallAndBox scene(Vec(0.0), false);
  std::vector<vtkSmartPointer<vtkStaticCellLocator>> locators;
  for (const Mesh& mesh : scene.meshes)
  {
    locators.push_back(vtkSmartPointer<vtkStaticCellLocator>::New());
    locators.back()->SetDataSet(mesh);
    locators.back()->BuildLocator();
  }
  int same = 0, hits = 0;
  for (vtkIdType pixel = 0; pixel < width * height; ++pixel)
  {
    const Ray ray = scene.studio.ray(pixel % width, pixel / width);
    const Vec end = ray.origin + 100.0 * ray.direction;
    double nearest = 2.0;
    vtkIdType cell = -1;
    Vec position(0.0);
    for (const auto& locator : locators)
    {
      double t;
      Vec x, pcoords;
      int subId;
      vtkIdType found;
      if (locator->IntersectWithLine(
            &ray.origin.x, &end.x, 0.0, t, &x.x, &pcoords.x, subId, found) &&
        t < nearest)
      {
        nearest = t;
        cell = found;
        position = x;
      }
    }
    hits += cell >= 0;
    same += passOf(scene.image(), "CellIds")->GetComponent(pixel, 0) == cell;
    if (cell >= 0 && passOf(scene.image(), "CellIds")->GetComponent(pixel, 0) >= 0)
    {
      EXPECT_LT(glm::distance(scene.tuple("Positions", pixel), position), 1e-9);
    }
  }
  EXPECT_GT(hits, width * height / 4);
  EXPECT_GE(same, width * height - 4); // its tolerance differs at edges
}

TEST(Passes, HaveTheirNamesTypesAndSizes)
{
  Studio studio(7, 3);
  studio.tracer->SetInputData(makeSquare());
  wantAll(studio);
  studio.tracer->Update();
  vtkPointData* const data = studio.tracer->GetOutput()->GetPointData();
  const struct
  {
    const char* name;
    int type, components;
  } expected[] = { { "Color", VTK_FLOAT, 3 }, { "Depth", VTK_FLOAT, 1 },
    { "Normals", VTK_FLOAT, 3 }, { "Positions", VTK_DOUBLE, 3 }, { "CellIds", VTK_ID_TYPE, 1 },
    { "InputIds", VTK_ID_TYPE, 1 } };
  EXPECT_EQ(data->GetNumberOfArrays(), 6);
  for (const auto& array : expected)
  {
    vtkDataArray* const found = passOf(studio.tracer->GetOutput(), array.name);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->GetDataType(), array.type) << array.name;
    EXPECT_EQ(found->GetNumberOfComponents(), array.components) << array.name;
    EXPECT_EQ(found->GetNumberOfTuples(), 21) << array.name;
  }
  EXPECT_STREQ(data->GetScalars()->GetName(), "Color");
  EXPECT_EQ(data->GetNormals(), nullptr); // not the active normals of the image
}

TEST(Passes, DoNotChangeColours)
{
  Studio studio(width, height);
  studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
  studio.tracer->AddInputDataObject(makeSphere(12));
  const Picture without = render(studio.tracer);
  wantAll(studio);
  EXPECT_SAME_BITS(without, render(studio.tracer));
  EXPECT_LT(without.count(Studio::background()), width * height);
}

TEST(Passes, PartsEqualThoseOfTheWhole)
{
  for (const int samples : { 1, 2 })
  {
    BallAndBox scene(Vec(0.0), false), parts(Vec(0.0), false);
    scene.studio.tracer->SetSupersampling(samples);
    scene.studio.tracer->Update();
    parts.studio.tracer->SetSupersampling(samples);
    for (const auto& w :
      { std::array<int, 4>{ 30, 30, 20, 20 }, { 7, 53, 5, 41 }, { 0, 60, 9, 9 } })
    {
      const int extent[6] = { w[0], w[1], w[2], w[3], 0, 0 };
      parts.studio.tracer->Modified();
      parts.studio.tracer->UpdateExtent(extent);
      vtkIdType pixel = 0;
      for (int j = w[2]; j <= w[3]; ++j)
      {
        for (int i = w[0]; i <= w[1]; ++i, ++pixel)
        {
          expectSameArrays(parts.image(), pixel, scene.image(), j * width + i);
        }
      }
      EXPECT_EQ(parts.image()->GetNumberOfPoints(), pixel);
    }
  }
}

TEST(Passes, ShowTheMiddleSample)
{
  for (const int n : { 2, 3, 5 })
  {
    BallAndBox scene(Vec(0.0), false), larger(Vec(0.0), false);
    scene.studio.tracer->SetSupersampling(n);
    scene.studio.tracer->Update();
    larger.studio.tracer->SetImageSize(n * width, n * height);
    larger.studio.tracer->Update();
    for (vtkIdType pixel = 0; pixel < width * height; ++pixel)
    {
      const vtkIdType sample =
        (n * (pixel / width) + n / 2) * n * width + n * (pixel % width) + n / 2;
      for (const char* name : { "Depth", "Normals", "Positions", "CellIds", "InputIds" })
      {
        EXPECT_EQ(tupleBits(passOf(scene.image(), name), pixel),
          tupleBits(passOf(larger.image(), name), sample))
          << name << ", " << n << " samples, pixel " << pixel;
      }
    }
  }
}

TEST(Passes, AreNaNOrMinusOneWithoutSurfaces)
{
  for (const int samples : { 1, 3 })
  {
    Studio studio(41, 5);
    const Messages messages(studio.tracer);
    studio.tracer->SetSupersampling(samples);
    studio.tracer->SetInputData(Mesh::New());
    wantAll(studio);
    studio.tracer->Update();
    for (vtkIdType pixel = 0; pixel < 41 * 5; ++pixel)
    {
      expectNothing(studio.tracer->GetOutput(), pixel);
    }
    EXPECT_TRUE(messages.errors().empty());
    EXPECT_TRUE(messages.warnings().empty());
  }
}

TEST(Passes, AbortLeavesAnEmptyOutput)
{
  BallAndBox scene(Vec(0.0), false);
  const Picture expected(scene.image());
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void* fraction) {
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(*static_cast<double*>(fraction) > 0.5);
    });
  const auto observer = scene.studio.tracer->AddObserver(vtkCommand::ProgressEvent, abort);
  scene.studio.tracer->Modified();
  scene.studio.tracer->Update();
  EXPECT_EQ(scene.image()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scene.image()->GetPointData()->GetNumberOfArrays(), 0);
  scene.studio.tracer->RemoveObserver(observer);
  scene.studio.tracer->SetAbortExecute(0);
  EXPECT_SAME_BITS(expected, render(scene.studio.tracer));
  EXPECT_EQ(scene.image()->GetPointData()->GetNumberOfArrays(), 6);
}
