// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks of lists of cells, part by part. A list is recorded as correct only if all of it was
// checked and is correct. CheckCells() finds each wrong id in any position.

#include "BrokenFiles.h"

#include "CheckCells.h"
#include "ListCheck.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lambent::command;

namespace
{

constexpr vtkIdType Cells = 40000; ///< enough for several parts of ids
constexpr vtkIdType Points = 100;

template <typename Array>
struct List
{
  List()
  {
    this->Offsets->SetNumberOfValues(Cells + 1);
    this->Ids->SetNumberOfValues(3 * Cells);
    for (vtkIdType cell = 0; cell <= Cells; ++cell)
    {
      this->Offsets->SetValue(cell, static_cast<typename Array::ValueType>(3 * cell));
    }
    for (vtkIdType k = 0; k < 3 * Cells; ++k)
    {
      this->Ids->SetValue(k, static_cast<typename Array::ValueType>(k % Points));
    }
  }

  vtkSmartPointer<vtkCellArray> ToCells()
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    vtkDataArray* const offsets = this->Offsets;
    vtkDataArray* const ids = this->Ids;
    cells->SetData(offsets, ids);
    return cells;
  }

  vtkNew<Array> Offsets;
  vtkNew<Array> Ids;
};

/// Checks all ids but the last `unseen` ones, part by part. Returns whether they are recorded as
/// correct.
template <typename Array>
bool IsNoted(List<Array>& list, vtkIdType numberOfPoints, vtkIdType unseen = 0)
{
  ListCheck check(numberOfPoints);
  check.LookAtOffsets(list.Offsets, 1, Cells / 2);
  check.LookAtOffsets(list.Offsets, Cells / 2, Cells + 1);
  for (vtkIdType begin = 0; begin < 3 * Cells - unseen; begin += ListCheck::Part)
  {
    check.LookAtIds(
      list.Ids, begin, std::min<vtkIdType>(begin + ListCheck::Part, 3 * Cells - unseen));
  }
  const auto cells = list.ToCells();
  check.Note(cells);
  return AreIdsKnownBelow(cells, numberOfPoints);
}

std::string Failing(vtkCellArray* cells)
{
  try
  {
    CheckCells(cells, Points, "polygon");
    return "";
  }
  catch (const Failure& failure)
  {
    return failure.what();
  }
}

} // namespace

template <typename Array>
class ListChecks : public testing::Test
{
};
using Arrays = testing::Types<vtkTypeInt32Array, vtkTypeInt64Array>;
TYPED_TEST_SUITE(ListChecks, Arrays, ); // the comma for clang's -Wpedantic

TYPED_TEST(ListChecks, RecordListsThatAreCheckedAndCorrect)
{
  List<TypeParam> list;
  EXPECT_TRUE(IsNoted(list, Points));
  EXPECT_TRUE(IsNoted(list, Points + 1));
  EXPECT_FALSE(IsNoted(list, Points - 1));
  EXPECT_FALSE(IsNoted(list, 0));
  EXPECT_FALSE(IsNoted(list, Points, 1));

  ListCheck trusting(Points);
  trusting.LookAtIds(list.Ids, 0, 3 * Cells);
  const auto trusted = list.ToCells();
  trusting.Note(trusted);
  EXPECT_FALSE(AreIdsKnownBelow(trusted, Points));
  trusting.TrustOffsets();
  trusting.Note(trusted);
  EXPECT_TRUE(AreIdsKnownBelow(trusted, Points));

  const auto cells = list.ToCells();
  NoteIdsBelow(cells, Points);
  EXPECT_TRUE(AreIdsKnownBelow(cells, Points));
  EXPECT_TRUE(AreIdsKnownBelow(cells, Points + 1));
  EXPECT_FALSE(AreIdsKnownBelow(cells, Points - 1));
}

TYPED_TEST(ListChecks, FindEachWrongId)
{
  using Value = typename TypeParam::ValueType;
  for (const vtkIdType at :
    { vtkIdType{ 0 }, vtkIdType{ 4 }, ListCheck::Part - 1, ListCheck::Part, 3 * Cells - 1 })
  {
    for (const Value wrong : { Value{ -1 }, static_cast<Value>(Points),
           std::numeric_limits<Value>::max(), std::numeric_limits<Value>::min() })
    {
      List<TypeParam> list;
      list.Ids->SetValue(at, wrong);
      EXPECT_FALSE(IsNoted(list, Points)) << at << " " << wrong;
      EXPECT_EQ(Failing(list.ToCells())
                  .rfind("its polygon " + std::to_string(at / 3) + " uses point " +
                      std::to_string(wrong) + ", which does not exist",
                    0),
        0u)
        << at << " " << wrong;
    }
  }
}

TYPED_TEST(ListChecks, FindEachWrongOffset)
{
  using Value = typename TypeParam::ValueType;
  for (const vtkIdType at :
    { vtkIdType{ 0 }, vtkIdType{ 1 }, Cells / 2 - 1, Cells / 2, Cells - 1, Cells })
  {
    for (const Value wrong : { Value{ -1 }, static_cast<Value>(3 * Cells + 1),
           std::numeric_limits<Value>::max(), std::numeric_limits<Value>::min() })
    {
      List<TypeParam> list;
      list.Offsets->SetValue(at, wrong);
      EXPECT_FALSE(IsNoted(list, Points)) << at << " " << wrong;
      EXPECT_NE(Failing(list.ToCells()).find("inconsistent"), std::string::npos)
        << at << " " << wrong;
    }
  }
}

TYPED_TEST(ListChecks, AcceptCorrectLists)
{
  List<TypeParam> list;
  EXPECT_EQ(Failing(list.ToCells()), "");
}

namespace
{

/// Writes the mesh with a writer and reads the file.
template <typename Writer>
std::string FailingFile(Writer* writer, vtkPolyData* mesh, const std::string& extension)
{
  const Scratch scratch(extension);
  writer->SetInputData(mesh);
  writer->SetFileName(scratch.path.c_str());
  writer->Write();
  return Read(scratch, scratch.read()).failure;
}

} // namespace

// A wrong id is found whichever way the list is read.
TEST(ListChecksOfFiles, FindAWrongId)
{
  for (const vtkIdType wrong : { 4, -1 })
  {
    vtkNew<vtkPolyData> mesh;
    vtkNew<vtkPoints> points;
    for (int k = 0; k < 4; ++k)
    {
      points->InsertNextPoint(k % 2, k / 2, 0.0);
    }
    mesh->SetPoints(points);
    vtkNew<vtkCellArray> polygons;
    polygons->InsertNextCell({ 0, 1, 2 });
    polygons->InsertNextCell({ 0, 2, wrong });
    mesh->SetPolys(polygons);
    const std::string expected = "its polygon 1 uses point " + std::to_string(wrong) + ", which";
    using Xml = vtkXMLPolyDataWriter;
    for (const int mode : { Xml::Ascii, Xml::Binary, Xml::Appended })
    {
      vtkNew<Xml> writer;
      writer->SetDataMode(mode);
      writer->SetCompressorTypeToNone();
      writer->EncodeAppendedDataOff();
      const std::string failure = FailingFile(writer.Get(), mesh, ".vtp");
      EXPECT_NE(failure.find(expected), std::string::npos) << mode << " " << failure;
    }
    using Legacy = vtkPolyDataWriter;
    for (const int version : { 42, 51 })
    {
      for (const int type : { VTK_ASCII, VTK_BINARY })
      {
        vtkNew<Legacy> writer;
        writer->SetFileVersion(version);
        writer->SetFileType(type);
        const std::string failure = FailingFile(writer.Get(), mesh, ".vtk");
        EXPECT_NE(failure.find(expected), std::string::npos) << version << " " << failure;
      }
    }
  }
}
