// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkLambentNormals: either an error and an empty output, or the normals of the plain code, bit for
// bit. The input is not modified.
#include "FuzzMesh.h"

#include "CornerNormals.h"
#include "FacesFromVTK.h"
#include "VectorTarget.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkLambentNormals.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <exception>
#include <vector>

namespace
{
void set(FuzzInput& input, vtkLambentNormals* filter)
{
  filter->SetWeighting(input.choice(6) - 1);
  filter->SetComputePointNormals(!input.seldom(32));
  filter->SetComputeCellNormals(input.flag());
  filter->SetSplitting(input.flag());
  filter->SetFeatureAngle(input.number() * 30.0);
  filter->SetFlipNormals(input.flag());
}

/// Computes the ray tracer's normals: the bits must be the same with and without vectors.
void checkCornerNormals(const lambent::Faces& faces, double featureAngle)
{
  const auto compute = [&]()
  { return computeCornerNormals(faces, featureAngle, lambent::Parallel()); };
  const lambent::CornerNormals plain = compute();
  lambent::useVectorTarget(lambent::vectorTargets().back());
  const lambent::CornerNormals fast = compute();
  lambent::useVectorTarget("plain");
  const auto corners = faces.cells.offsets[lambent::cellCount(faces.cells)];
  require(plain.count == fast.count && !plain.numbers == !fast.numbers, "corners split alike");
  require(
    std::equal(plain.normals.get(), plain.normals.get() + 3 * plain.count, fast.normals.get()),
    "corners have the normals of the plain code");
  require(!plain.numbers ||
      std::equal(plain.numbers.get(), plain.numbers.get() + corners, fast.numbers.get()),
    "corners have the numbers of the plain code");
}

/// Computes the normals with the plain code, without splitting. Returns false if the mesh cannot be
/// read.
bool computePlainly(vtkLambentNormals* filter, vtkPolyData* mesh, std::vector<float>& points,
  std::vector<float>& cells)
{
  try
  {
    const lambent::Parallel one;
    lambent::adapters::FacesFromVTK faces(mesh, one);
    const float sign = filter->GetFlipNormals() ? -1.0f : 1.0f;
    points.resize(3 * mesh->GetNumberOfPoints());
    cells.resize(3 * lambent::cellCount(faces.faces().cells));
    computePointNormals(faces.faces(), static_cast<lambent::Weighting>(filter->GetWeighting()),
      sign, one, points.data());
    computeFaceNormals(faces.faces(), sign, one, cells.data());
    if (!cells.empty())
    {
      checkCornerNormals(faces.faces(), filter->GetFeatureAngle());
    }
    return true;
  }
  catch (const std::exception&)
  {
    return false;
  }
}

void requireSameBits(const std::vector<float>& expected, vtkDataArray* array, vtkIdType first)
{
  auto* normals = vtkFloatArray::SafeDownCast(array);
  require(normals && normals->GetNumberOfComponents() == 3, "normals are tuples of three floats");
  require(normals->GetNumberOfValues() == 3 * first + static_cast<vtkIdType>(expected.size()),
    "there is a normal for each point or cell");
  require(expected.empty() ||
      std::memcmp(
        expected.data(), normals->GetPointer(3 * first), expected.size() * sizeof(float)) == 0,
    "normals are those of the plain code");
}

bool hasWrongLength(vtkDataSetAttributes* data, vtkIdType expected)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (data->GetAbstractArray(i)->GetNumberOfTuples() != expected)
    {
      return true;
    }
  }
  return false;
}

void check(vtkLambentNormals* filter, vtkPolyData* mesh, int errors)
{
  vtkPolyData* output = filter->GetOutput();
  std::vector<float> points, cells;
  const bool isReadable = computePlainly(filter, mesh, points, cells);
  if (errors > 0)
  {
    require(!isReadable || hasWrongLength(mesh->GetPointData(), mesh->GetNumberOfPoints()) ||
        hasWrongLength(mesh->GetCellData(), mesh->GetNumberOfCells()),
      "what can be read is no error");
    require(output->GetNumberOfPoints() == 0 && output->GetNumberOfCells() == 0,
      "after an error the output is empty");
    return;
  }
  require(isReadable, "a mesh that cannot be read is an error");
  const vtkIdType others = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  if (filter->GetComputePointNormals() && !filter->GetSplitting())
  {
    requireSameBits(points, output->GetPointData()->GetNormals(), 0);
  }
  if (filter->GetComputeCellNormals())
  {
    requireSameBits(cells, output->GetCellData()->GetNormals(), others);
  }
  require(filter->GetSplitting() || output->GetNumberOfPoints() == mesh->GetNumberOfPoints(),
    "points are kept");
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  // The library has its own core, which uses vectors. The core that is linked here must be plain.
  lambent::useVectorTarget("plain");
  FuzzInput input(data, size);
  const int threads = input.seldom(32) ? 2 + input.choice(2) : 1;
  vtkNew<vtkLambentNormals> filter;
  ErrorCount count(filter);
  set(input, filter);
  while (!input.empty())
  {
    const auto mesh = makeFuzzMesh(input);
    filter->SetInputData(mesh);
    count.errors = 0;
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ threads, threads > 1 ? vtkSMPTools::GetBackend() : "Sequential", false },
      [&]() { filter->Update(); });
    check(filter, mesh, count.errors);
    if (input.flag())
    {
      set(input, filter);
    }
  }
  return 0;
}
