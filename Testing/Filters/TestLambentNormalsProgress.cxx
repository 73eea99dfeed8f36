// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The progress that vtkLambentNormals reports, and the result of aborting it.

#include "Chunks.h"
#include "TestingNormals.h"
#include "vtkLambentNormals.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace
{
/// Records the reported progress, and aborts the filter at one of the reports.
struct Watcher
{
  std::vector<double> told;
  bool isOwnThread = true;
  std::size_t abortAt = ~std::size_t(0);
  std::thread::id thread = std::this_thread::get_id();
  vtkNew<vtkCallbackCommand> command;

  explicit Watcher(vtkLambentNormals* normals)
  {
    this->command->SetClientData(this);
    this->command->SetCallback(
      [](vtkObject* caller, unsigned long, void* self, void* fraction)
      {
        auto* watcher = static_cast<Watcher*>(self);
        if (watcher->told.size() == watcher->abortAt)
        {
          vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
        }
        watcher->told.push_back(*static_cast<double*>(fraction));
        watcher->isOwnThread &= std::this_thread::get_id() == watcher->thread;
      });
    normals->AddObserver(vtkCommand::ProgressEvent, this->command);
  }
};

/// Two triangles for each of resolution x resolution squares.
vtkSmartPointer<vtkPolyData> makePlane(int resolution)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(resolution, resolution);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  vtkSmartPointer<vtkPolyData> mesh = triangles->GetOutput();
  mesh->GetPointData()->Initialize();
  return mesh;
}

vtkSmartPointer<vtkPolyData> makeStrips(int resolution)
{
  vtkSmartPointer<vtkPolyData> mesh = makePlane(resolution);
  const vtkIdType row = resolution + 1;
  vtkNew<vtkCellArray> strips;
  for (vtkIdType j = 0; j < resolution; ++j)
  {
    strips->InsertNextCell(static_cast<int>(2 * row));
    for (vtkIdType i = 0; i < row; ++i)
    {
      strips->InsertCellPoint((j + 1) * row + i);
      strips->InsertCellPoint(j * row + i);
    }
  }
  mesh->SetPolys(nullptr);
  mesh->SetStrips(strips);
  return mesh;
}

struct Manner
{
  const char* name;
  bool hasCellNormals, isSplit, isFlipped, isOfStrips;
};
constexpr Manner Manners[] = { { "as by default", false, false, false, false },
  { "with cell normals", true, false, false, false }, { "split", false, true, false, false },
  { "flipped", false, false, true, false }, { "strips", false, false, false, true } };

void setUp(vtkLambentNormals* normals, const Manner& manner, int resolution)
{
  normals->SetComputeCellNormals(manner.hasCellNormals);
  normals->SetSplitting(manner.isSplit);
  normals->SetFlipNormals(manner.isFlipped);
  normals->SetInputData(manner.isOfStrips ? makeStrips(resolution) : makePlane(resolution));
}

std::vector<float> normalsOf(vtkLambentNormals* normals)
{
  std::vector<float> values = valuesOf(normals->GetOutput()->GetPointData()->GetNormals());
  if (vtkDataArray* ofCells = normals->GetOutput()->GetCellData()->GetNormals())
  {
    const std::vector<float> more = valuesOf(ofCells);
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}
}

TEST(LambentNormalsProgress, IncreasesInTheCallingThread)
{
  for (const Manner& manner : Manners)
  {
    SCOPED_TRACE(manner.name);
    vtkNew<vtkLambentNormals> normals;
    setUp(normals, manner, 300);
    Watcher watcher(normals);
    normals->Update();
    EXPECT_TRUE(std::is_sorted(watcher.told.begin(), watcher.told.end()))
      << testing::PrintToString(watcher.told);
    EXPECT_GE(watcher.told.front(), 0.0);
    EXPECT_EQ(watcher.told.back(), 1.0);
    EXPECT_TRUE(watcher.isOwnThread);
  }
}

// Each pass over the faces reports its progress in parts.
TEST(LambentNormalsProgress, IsReportedMoreOftenForALargerMesh)
{
  constexpr int resolution = 900;
  constexpr std::size_t parts = 2u * resolution * resolution / lambent::mostItemsPerPart;
  static_assert(parts > 2);
  const int passes[] = { 1, 2, 5, 5, 2 };
  for (std::size_t k = 0; k < std::size(Manners); ++k)
  {
    SCOPED_TRACE(Manners[k].name);
    std::size_t told[2];
    for (int isLarge : { 0, 1 })
    {
      vtkNew<vtkLambentNormals> normals;
      setUp(normals, Manners[k], isLarge ? resolution : 10);
      Watcher watcher(normals);
      normals->Update();
      told[isLarge] = watcher.told.size();
    }
    EXPECT_GE(told[1], told[0] + passes[k] * parts);
  }
}

// Aborts at some of the reports. The last report is the executive's.
TEST(LambentNormalsProgress, AbortGivesAnEmptyOutputAndTheNextOneIsRight)
{
  for (const Manner& manner : Manners)
  {
    SCOPED_TRACE(manner.name);
    vtkNew<vtkLambentNormals> normals;
    setUp(normals, manner, 200);
    const Messages messages(normals);
    Watcher watcher(normals);
    normals->Update();
    const std::vector<float> expected = normalsOf(normals);
    const std::size_t moments = watcher.told.size();
    int aborted = 0;
    for (std::size_t k = 0; k + 1 < moments; k += 1 + moments / 10)
    {
      watcher.told.clear();
      watcher.abortAt = k;
      normals->Modified();
      normals->Update();
      // The number of reports depends on how long the work takes, so there may be fewer than k.
      if (watcher.told.size() <= k + 1 && watcher.told.back() == 1.0)
      {
        continue;
      }
      ++aborted;
      EXPECT_LE(watcher.told.size(), k + 2) << "works on after an abort";
      EXPECT_EQ(normals->GetOutput()->GetNumberOfPoints(), 0) << k;
      EXPECT_EQ(normals->GetOutput()->GetNumberOfCells(), 0) << k;
      watcher.abortAt = ~std::size_t(0);
      normals->SetAbortExecute(0);
      normals->Update(); // although nothing has changed
      EXPECT_EQ(normalsOf(normals), expected) << k;
    }
    EXPECT_GT(aborted, 0);
    EXPECT_TRUE(messages.errors.empty());
    EXPECT_TRUE(messages.warnings.empty());
  }
}
