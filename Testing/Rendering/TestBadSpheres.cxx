// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Unusable radii of spheres cause an error that names the connection, the array and the remedy.
#include "ExpectedErrors.h"

#include <limits>
#include <sstream>

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();
}

TEST(BadSpheres, NegativeConnections)
{
  vtkNew<vtkLambentRayTracer> tracer;
  Messages messages(tracer);
  tracer->SetInputSphereRadius(-1, 1.0);
  expectMessage(messages.errors(), { "SetInputSphereRadius()", "connection -1", "from 0" });
  messages.clear();
  tracer->SetInputSphereRadiusArray(-2, "Radius");
  expectMessage(messages.errors(), { "SetInputSphereRadiusArray()", "connection -2", "from 0" });
}

TEST(BadSpheres, Radius)
{
  for (const double radius : { -1.0, notANumber, infinite })
  {
    std::ostringstream number;
    number << radius;
    expectError([&](Studio& s) { s.tracer->SetInputSphereRadius(0, radius); },
      { "Input 0", "sphere radius is " + number.str(), "finite number of 0 or more",
        "SetInputSphereRadius()" },
      [](Studio& s) { s.tracer->SetInputSphereRadius(0, 0.0); });
  }
}

TEST(BadSpheres, Arrays)
{
  const auto withArray = [](vtkIdType tuples, int components, double value)
  {
    return [=](Studio& s)
    {
      vtkNew<vtkFloatArray> array;
      array->SetName("R");
      array->SetNumberOfComponents(components);
      array->SetNumberOfTuples(tuples);
      array->Fill(1.0);
      array->SetComponent(tuples - 1, 0, value);
      vtkPolyData::SafeDownCast(s.tracer->GetInputDataObject(0, 0))
        ->GetPointData()
        ->AddArray(array);
      s.tracer->SetInputSphereRadiusArray(0, "R");
    };
  };
  const Change mend = [](Studio& s)
  {
    vtkPolyData::SafeDownCast(s.tracer->GetInputDataObject(0, 0))->GetPointData()->RemoveArray("R");
    s.tracer->SetInputSphereRadiusArray(0, nullptr);
  };
  const vtkIdType points = makeSphere(6)->GetNumberOfPoints();
  const std::string last = "point " + std::to_string(points - 1);
  expectError([](Studio& s) { s.tracer->SetInputSphereRadiusArray(0, "R"); },
    { "Input 0", "no point array \"R\"", "Choose one of \"PointNormals\"",
      "SetInputSphereRadiusArray()", "nullptr" },
    mend);
  expectError(withArray(points - 1, 1, 1.0),
    { "Input 0", "point array \"R\"", std::to_string(points - 1) + " tuples of 1", "Correct",
      "SetInputSphereRadiusArray()" },
    mend);
  expectError(withArray(points, 3, 1.0),
    { "Input 0", "point array \"R\"", "tuples of 3", "SetInputSphereRadiusArray()" }, mend);
  expectError(withArray(points, 1, -0.5),
    { "Input 0", "point array \"R\"", "value -0.5 at " + last, "SetInputSphereRadiusArray()" },
    mend);
  expectError(withArray(points, 1, notANumber),
    { "Input 0", "point array \"R\"", "nan at " + last, "SetInputSphereRadiusArray()" }, mend);
}
