// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Points drawn as spheres: the settings, and the picture that geometry predicts.
#include "Meshes.h"
#include "Messages.h"

#include "vtkIntArray.h"

#include <limits>
#include <sstream>

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();

/// Four points, three of which a triangle uses, with the array "Radius".
Mesh makePoints()
{
  Mesh mesh =
    makeMesh({ { -1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.25, -0.5 }, { 0.0, -1.0, 0.0 } },
      { { 0, 1, 2 } });
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  for (const double radius : { 0.25, 0.5, 0.0, 0.75 })
  {
    radii->InsertNextValue(radius);
  }
  mesh->GetPointData()->AddArray(radii);
  return mesh;
}

/// The spheres that a ray through the middle of a pixel should see, by their points; -1 for none.
std::vector<int> expectedIds(Studio& studio, const Mesh& mesh, const std::vector<double>& radii)
{
  int size[2];
  studio.tracer->GetImageSize(size);
  const std::vector<Vec> centers = pointsOf(mesh);
  std::vector<int> ids;
  for (int pixel = 0; pixel < size[0] * size[1]; ++pixel)
  {
    // The camera is parallel and looks along -z.
    const double unit = 2.0 * studio.camera->GetParallelScale() / size[1];
    const double x = (pixel % size[0] + 0.5 - 0.5 * size[0]) * unit;
    const double y = (pixel / size[0] + 0.5 - 0.5 * size[1]) * unit;
    int nearest = -1;
    double height = -infinite;
    for (std::size_t k = 0; k < centers.size(); ++k)
    {
      const double dx = x - centers[k].x, dy = y - centers[k].y;
      const double square = radii[k] * radii[k] - dx * dx - dy * dy;
      if (square > 0.0 && centers[k].z + std::sqrt(square) > height)
      {
        height = centers[k].z + std::sqrt(square);
        nearest = static_cast<int>(k);
      }
    }
    ids.push_back(nearest);
  }
  return ids;
}

/// A parallel view along -z with ids.
struct Sky : Studio
{
  Mesh mesh = makePoints();

  Sky()
    : Studio(79, 61)
  {
    this->camera->ParallelProjectionOn();
    this->camera->SetParallelScale(2.03125);
    this->tracer->GenerateIdsOn();
    this->tracer->SetInputData(this->mesh);
  }

  std::vector<int> ids()
  {
    this->tracer->Update();
    vtkDataArray* const array = this->tracer->GetOutput()->GetPointData()->GetArray("CellIds");
    std::vector<int> result;
    for (vtkIdType k = 0; array && k < array->GetNumberOfTuples(); ++k)
    {
      result.push_back(static_cast<int>(array->GetComponent(k, 0)));
    }
    return result;
  }
};
}

TEST(Spheres, AreOffByDefault)
{
  vtkNew<vtkLambentRayTracer> tracer;
  EXPECT_EQ(tracer->GetInputSphereRadius(0), 0.0);
  EXPECT_EQ(tracer->GetInputSphereRadiusArray(0), nullptr);
  EXPECT_EQ(tracer->GetInputSphereRadius(-1), 0.0);
}

// All points have spheres, also those that no cell uses; the triangle is gone.
TEST(Spheres, OfOneRadius)
{
  Sky sky;
  const Messages messages(sky.tracer);
  sky.tracer->SetInputSphereRadius(0, 0.625);
  EXPECT_EQ(sky.ids(), expectedIds(sky, sky.mesh, { 0.625, 0.625, 0.625, 0.625 }));
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_TRUE(messages.warnings().empty());
}

TEST(Spheres, OfAnArray)
{
  Sky sky;
  sky.tracer->SetInputSphereRadiusArray(0, "Radius");
  EXPECT_EQ(sky.ids(), expectedIds(sky, sky.mesh, { 0.25, 0.5, 0.0, 0.75 }));
}

TEST(Spheres, OfAnArrayTimesARadius)
{
  Sky sky;
  sky.tracer->SetInputSphereRadiusArray(0, "Radius");
  sky.tracer->SetInputSphereRadius(0, 1.5);
  EXPECT_EQ(sky.ids(), expectedIds(sky, sky.mesh, { 0.375, 0.75, 0.0, 1.125 }));
}

TEST(Spheres, OfAnArrayOfAnyType)
{
  Sky sky;
  vtkNew<vtkIntArray> integers;
  vtkNew<vtkFloatArray> floats;
  integers->SetName("Integers");
  floats->SetName("Floats");
  for (const int value : { 1, 2, 0, 3 })
  {
    integers->InsertNextValue(value);
    floats->InsertNextValue(static_cast<float>(value));
  }
  sky.mesh->GetPointData()->AddArray(integers);
  sky.mesh->GetPointData()->AddArray(floats);
  const std::vector<int> expected = expectedIds(sky, sky.mesh, { 0.25, 0.5, 0.0, 0.75 });
  sky.tracer->SetInputSphereRadius(0, 0.25);
  for (const char* name : { "Integers", "Floats" })
  {
    sky.tracer->SetInputSphereRadiusArray(0, name);
    EXPECT_EQ(sky.ids(), expected) << name;
  }
}

TEST(Spheres, CanBeTurnedOffAgain)
{
  Sky sky;
  const std::vector<int> triangle = sky.ids();
  sky.tracer->SetInputSphereRadius(0, 0.5);
  sky.tracer->SetInputSphereRadiusArray(0, "Radius");
  EXPECT_NE(sky.ids(), triangle);
  sky.tracer->SetInputSphereRadius(0, 0.0);
  sky.tracer->SetInputSphereRadiusArray(0, nullptr);
  EXPECT_EQ(sky.ids(), triangle);
}

TEST(Spheres, StayWithTheirConnection)
{
  vtkNew<vtkLambentRayTracer> tracer;
  vtkNew<vtkProperty> property;
  for (int k = 0; k < 3; ++k)
  {
    tracer->AddInputDataObject(makePoints());
    tracer->SetInputSphereRadius(k, 1.0 + k);
  }
  tracer->SetInputProperty(1, property);
  tracer->SetInputSphereRadiusArray(2, "Radius");
  tracer->SetInputProperty(1, nullptr); // the radius stays
  EXPECT_EQ(tracer->GetInputSphereRadius(1), 2.0);
  tracer->RemoveInputConnection(0, 0);
  EXPECT_EQ(tracer->GetInputSphereRadius(0), 2.0);
  EXPECT_EQ(tracer->GetInputSphereRadius(1), 3.0);
  EXPECT_STREQ(tracer->GetInputSphereRadiusArray(1), "Radius");
  EXPECT_EQ(tracer->GetInputSphereRadius(2), 0.0);
  std::ostringstream text;
  tracer->Print(text);
  EXPECT_NE(text.str().find("InputSphereRadius 1: 3"), std::string::npos);
  EXPECT_NE(text.str().find("InputSphereRadiusArray 1: Radius"), std::string::npos);
}

// A sphere is brightest in its middle under a headlight, and shaded by the cosine.
TEST(Spheres, AreShadedWithTheirNormals)
{
  for (const int interpolation : { VTK_FLAT, VTK_PHONG })
  {
    Studio studio(65, 65);
    studio.tracer->SetOutputScalarTypeToFloat();
    studio.camera->ParallelProjectionOn();
    studio.camera->SetParallelScale(1.0);
    vtkNew<vtkProperty> property;
    property->SetInterpolation(interpolation);
    studio.tracer->SetProperty(property);
    studio.tracer->RemoveAllLights(); // a headlight
    studio.tracer->SetInputData(makeMesh({ { 0.0, 0.0, 0.0 } }, {}));
    studio.tracer->SetInputSphereRadius(0, 1.0);
    const Picture picture = render(studio.tracer);
    for (int i = 0; i < 65; ++i)
    {
      const double x = (i - 32) * (2.0 / 65.0);
      const double cosine = std::sqrt(std::max(0.0, 1.0 - x * x));
      expectColor(picture.at(i, 32), { cosine, cosine, cosine }, pixelName(i, 32), 1e-6);
    }
  }
}

TEST(Spheres, AreFramedWithTheirRadii)
{
  vtkNew<vtkLambentRayTracer> tracer;
  tracer->SetInputData(makeMesh({ { 1.0, 2.0, 3.0 } }, {}));
  tracer->SetInputSphereRadius(0, 2.0);
  tracer->ResetCamera();
  double focus[3];
  tracer->GetCamera()->GetFocalPoint(focus);
  EXPECT_EQ(Vec(focus[0], focus[1], focus[2]), Vec(1.0, 2.0, 3.0));
  EXPECT_NEAR(tracer->GetCamera()->GetParallelScale(), 2.0 * std::sqrt(3.0), 1e-12);
}

TEST(Spheres, PassArraysHaveTheValueOfThePoint)
{
  Sky sky;
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("OfCells");
  cells->InsertNextValue(7.0);
  sky.mesh->GetCellData()->AddArray(cells);
  sky.tracer->SetInputSphereRadius(0, 0.625);
  sky.tracer->AddPassArray(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
  sky.tracer->AddPassArray(vtkDataObject::FIELD_ASSOCIATION_CELLS, "OfCells");
  const std::vector<int> ids = sky.ids();
  vtkPointData* const output = sky.tracer->GetOutput()->GetPointData();
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    const double value = output->GetArray("Radius")->GetComponent(static_cast<vtkIdType>(k), 0);
    if (ids[k] < 0)
    {
      EXPECT_TRUE(std::isnan(value));
    }
    else
    {
      EXPECT_EQ(value, sky.mesh->GetPointData()->GetArray("Radius")->GetComponent(ids[k], 0));
    }
    EXPECT_TRUE(
      std::isnan(output->GetArray("OfCells")->GetComponent(static_cast<vtkIdType>(k), 0)));
  }
}

TEST(Spheres, AmongTriangles)
{
  Sky sky;
  sky.tracer->AddInputDataObject(makeSquare(100.0, -3.0));
  sky.tracer->SetInputSphereRadius(0, 0.625);
  const std::vector<int> expected = expectedIds(sky, sky.mesh, { 0.625, 0.625, 0.625, 0.625 });
  const std::vector<int> found = sky.ids();
  vtkDataArray* const inputs = sky.tracer->GetOutput()->GetPointData()->GetArray("InputIds");
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    EXPECT_EQ(found[k], std::max(expected[k], 0)); // the square is cell 0
    EXPECT_EQ(inputs->GetComponent(static_cast<vtkIdType>(k), 0), expected[k] < 0 ? 1 : 0);
  }
}

TEST(Spheres, OfNoPoints)
{
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(Mesh::New());
  studio.tracer->SetInputSphereRadius(0, 1.0);
  studio.tracer->SetInputSphereRadiusArray(0, "Radius");
  const Picture picture = render(studio.tracer);
  EXPECT_EQ(picture.count(Studio::background()), picture.width() * picture.height());
  EXPECT_TRUE(messages.errors().empty());
}

// Broken cells do not matter to spheres.
TEST(Spheres, OfAnInputWithBrokenCells)
{
  Sky sky;
  const Messages messages(sky.tracer);
  sky.mesh->SetPolys(makeCells({ { 0, 1, 99 } }));
  sky.tracer->SetInputSphereRadius(0, 0.625);
  EXPECT_EQ(sky.ids(), expectedIds(sky, sky.mesh, { 0.625, 0.625, 0.625, 0.625 }));
  EXPECT_TRUE(messages.errors().empty());
}

TEST(Spheres, CentersThatAreNotFiniteCauseOneWarning)
{
  Sky sky;
  const Messages messages(sky.tracer);
  sky.mesh->GetPoints()->SetPoint(1, notANumber, 0.0, 0.0);
  sky.mesh->GetPoints()->SetPoint(3, 0.0, infinite, 0.0);
  sky.tracer->SetInputSphereRadius(0, 0.625);
  EXPECT_EQ(sky.ids(), expectedIds(sky, sky.mesh, { 0.625, 0.0, 0.625, 0.0 }));
  expectMessage(
    messages.warnings(), { "2 spheres", "not finite", "point 1 of input 0", "correct" });
}
