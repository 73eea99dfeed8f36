// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Reading in a child process: the mesh arrives complete, and each failure gives one line.

#include "Isolated.h"
#include "Messages.h"
#include "Progress.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <functional>
#include <new>
#include <string>
#include <unistd.h>
#include <vector>

using namespace lambent::command;

namespace
{

vtkSmartPointer<vtkCellArray> Cells(std::initializer_list<std::initializer_list<vtkIdType>> lists)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& list : lists)
  {
    cells->InsertNextCell(list);
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> MakeMesh()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < 6; ++k)
  {
    points->InsertNextPoint(k, 0.1 * k, k * k);
  }
  mesh->SetPoints(points);
  mesh->SetVerts(Cells({ { 0 } }));
  mesh->SetLines(Cells({ { 0, 1 }, { 1, 2, 3 } }));
  mesh->SetPolys(Cells({ { 0, 1, 2 }, { 2, 3, 4, 5 } }));
  mesh->SetStrips(Cells({ { 0, 1, 2, 3 } }));
  vtkNew<vtkFloatArray> normals;
  normals->SetName("n");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(6);
  normals->Fill(0.5);
  mesh->GetPointData()->SetNormals(normals);
  vtkNew<vtkStringArray> words; // strings are not sent
  words->SetName("words");
  words->SetNumberOfValues(6);
  mesh->GetPointData()->AddArray(words);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfTuples(6); // without a name
  colors->Fill(7);
  mesh->GetCellData()->SetScalars(colors);
  return mesh;
}

/// The message of the failure that this read function causes in a child process.
std::string FailureOf(
  const std::function<vtkSmartPointer<vtkPolyData>()>& read, ChildLimits limits = {})
{
  VtkMessages messages(true);
  Progress progress(false);
  try
  {
    ReadIsolated(read, limits, messages, progress);
  }
  catch (const Failure& failure)
  {
    return failure.what();
  }
  return "";
}

} // namespace

TEST(Isolated, MeshArrivesComplete)
{
  VtkMessages messages(true);
  Progress progress(false);
  const auto mesh = MakeMesh();
  const auto got = ReadIsolated([] { return MakeMesh(); }, {}, messages, progress);
  ASSERT_EQ(got->GetNumberOfPoints(), 6);
  EXPECT_EQ(got->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType k = 0; k < 6; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(got->GetPoint(k)[axis], mesh->GetPoint(k)[axis]);
    }
  }
  EXPECT_EQ(got->GetNumberOfVerts(), 1);
  EXPECT_EQ(got->GetNumberOfLines(), 2);
  EXPECT_EQ(got->GetNumberOfStrips(), 1);
  ASSERT_EQ(got->GetNumberOfPolys(), 2);
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  got->GetPolys()->GetCellAtId(1, count, ids);
  EXPECT_EQ(std::vector<vtkIdType>(ids, ids + count), (std::vector<vtkIdType>{ 2, 3, 4, 5 }));
  vtkDataArray* const normals = got->GetPointData()->GetNormals();
  ASSERT_TRUE(normals);
  EXPECT_STREQ(normals->GetName(), "n");
  EXPECT_EQ(normals->GetNumberOfTuples(), 6);
  EXPECT_EQ(normals->GetComponent(5, 2), 0.5);
  EXPECT_EQ(got->GetPointData()->GetNumberOfArrays(), 1);
  ASSERT_TRUE(got->GetCellData()->GetScalars());
  EXPECT_EQ(got->GetCellData()->GetScalars()->GetDataType(), VTK_UNSIGNED_CHAR);
  EXPECT_EQ(got->GetCellData()->GetScalars()->GetComponent(5, 0), 7);
}

TEST(Isolated, EmptyMeshArrives)
{
  VtkMessages messages(true);
  Progress progress(false);
  const auto got =
    ReadIsolated([] { return vtkSmartPointer<vtkPolyData>::New(); }, {}, messages, progress);
  EXPECT_EQ(got->GetNumberOfPoints(), 0);
  EXPECT_EQ(got->GetNumberOfCells(), 0);
}

TEST(Isolated, WarningsAndFailuresArrive)
{
  VtkMessages messages(true);
  Progress progress(false);
  ReadIsolated(
    []
    {
      vtkGenericWarningMacro("one thing");
      vtkGenericWarningMacro("another");
      return MakeMesh();
    },
    {}, messages, progress);
  EXPECT_EQ(messages.TakeWarnings(), (std::vector<std::string>{ "one thing", "another" }));
  EXPECT_EQ(FailureOf([]() -> vtkSmartPointer<vtkPolyData> { throw Failure("no way"); }), "no way");
  EXPECT_NE(
    FailureOf([]() -> vtkSmartPointer<vtkPolyData> { throw std::bad_alloc(); }).find("more memory"),
    std::string::npos);
}

TEST(Isolated, CrashesGiveOneLine)
{
  for (const int signal : { SIGSEGV, SIGABRT, SIGFPE, SIGBUS })
  {
    const std::string failure = FailureOf(
      [signal]
      {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
        return MakeMesh();
      });
    EXPECT_EQ(failure.rfind("its reader crashed", 0), 0u) << failure;
    EXPECT_NE(failure.find(strsignal(signal)), std::string::npos) << failure;
  }
  const std::string left = FailureOf(
    []
    {
      _exit(0); // as some libraries do on an error
      return MakeMesh();
    });
  EXPECT_EQ(left.rfind("its reader crashed", 0), 0u) << left;
}

TEST(Isolated, EndlessReadersAreStopped)
{
  ChildLimits limits;
  limits.seconds = 1;
  const std::string failure = FailureOf(
    []
    {
      for (volatile unsigned int k = 0;; k = k + 1)
      {
      }
      return MakeMesh();
    },
    limits);
  EXPECT_EQ(failure.rfind("its reader did not finish in 1 seconds", 0), 0u) << failure;
}

TEST(Isolated, CellsWithMissingPointsAreRejected)
{
  const std::string failure = FailureOf(
    []
    {
      auto mesh = MakeMesh();
      mesh->SetPolys(Cells({ { 0, 1, 6 } }));
      return mesh;
    });
  EXPECT_NE(failure.find("does not exist"), std::string::npos) << failure;
}

TEST(Isolated, LimitsGrowWithTheFile)
{
  const ChildLimits small = LimitsFor(FORMATS_FOLDER "/box.vti", false);
  EXPECT_EQ(small.seconds, 10u);
  EXPECT_GE(small.memory, std::uintmax_t{ 1 } << 28); // the machine may have little
  EXPECT_EQ(LimitsFor(FORMATS_FOLDER "/box.pvti", true).seconds, 10u);
}
