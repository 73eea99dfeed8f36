// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compares vtkLambentNormals with its definition, a plain serial loop, bit for bit: any number of
// threads, any backend, all kinds of cells and number types.

#include "../Rendering/Backends.h"
#include "TestingNormals.h"
#include "vtkLambentNormals.h"

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <string>

namespace
{
// Selects a backend and a number of threads for a test, and restores the previous ones.
class Threads
{
public:
  Threads(const std::string& backend, int count)
    : Before(vtkSMPTools::GetBackend())
    , IsThere(vtkSMPTools::SetBackend(backend.c_str()))
  {
    vtkSMPTools::Initialize(count);
  }
  ~Threads()
  {
    vtkSMPTools::SetBackend(this->Before.c_str());
    vtkSMPTools::Initialize();
  }
  bool isThere() const { return this->IsThere; }

private:
  std::string Before;
  bool IsThere;
};

std::vector<float> computeNormals(vtkPolyData* mesh, int weighting)
{
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(mesh);
  normals->SetWeighting(weighting);
  normals->Update();
  return valuesOf(normals->GetOutput()->GetPointData()->GetNormals());
}

void compareOnAllThreads(vtkPolyData* mesh)
{
  for (int weighting = vtkLambentNormals::UNIFORM; weighting <= vtkLambentNormals::MAX; ++weighting)
  {
    const std::vector<float> expected = referenceNormals(mesh, weighting);
    for (const std::string& backend : smpBackends())
    {
      for (int count : { 1, 2, 3, 8 })
      {
        const Threads threads(backend, count);
        if (threads.isThere())
        {
          EXPECT_EQ(computeNormals(mesh, weighting), expected)
            << backend << ", " << count << " threads, weighting " << weighting;
        }
      }
    }
  }
}
}

TEST(LambentNormalsReference, RandomMeshesOfAllCellsAndNumbers)
{
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    for (bool floatPoints : { true, false })
    {
      for (bool use64BitCells : { true, false })
      {
        SCOPED_TRACE("seed " + std::to_string(seed) + (floatPoints ? " float" : " double") +
          (use64BitCells ? " 64" : " 32"));
        RandomMeshOptions options;
        options.seed = seed;
        options.floatPoints = floatPoints;
        options.use64BitCells = use64BitCells;
        vtkSmartPointer<vtkPolyData> mesh = makeRandomMesh(options);
        compareOnAllThreads(mesh);
      }
    }
  }
}

TEST(LambentNormalsReference, FewPointsWithVeryManyFaces)
{
  RandomMeshOptions options;
  options.points = 5; // fewer than the ranges
  options.cells = 3000;
  compareOnAllThreads(makeRandomMesh(options));
}

TEST(LambentNormalsReference, SumsRunInTheOrderOfTheCells)
{
  // Twice the areas at point 0: L towards z, 1 towards z, L towards -z, 1 towards x. L + 1 is L, so
  // the sum in this order is (1, 0, 0); in any other order it is not. Other cells in between keep
  // the four in separate blocks.
  const double size = 536870912.0; // 2^29, so that L is 2^58
  std::vector<Vector> points = { { 0, 0, 0 }, { size, 0, 0 }, { 0, size, 0 }, { 1, 0, 0 },
    { 0, 1, 0 }, { 0, 0, 1 } };
  std::vector<Face> faces;
  for (const Face& face : { Face{ 0, 1, 2 }, { 0, 3, 4 }, { 0, 2, 1 }, { 0, 4, 5 } })
  {
    faces.push_back(face);
    faces.insert(faces.end(), 3000, Face{ 3, 4, 5 });
  }
  vtkSmartPointer<vtkPolyData> mesh = makeMesh(points, faces);
  compareOnAllThreads(mesh);
  const std::vector<float> normals = computeNormals(mesh, vtkLambentNormals::AREA);
  EXPECT_EQ(std::vector<float>(normals.begin(), normals.begin() + 3),
    std::vector<float>({ 1.0f, 0.0f, 0.0f }));
}
