// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Messages.h"
#include "ReadPly.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <unistd.h>

using namespace lambent::command;

namespace
{

vtkSmartPointer<vtkPolyData> ReadText(const std::string& content)
{
  const std::string path = "TestReadPly-" + std::to_string(getpid()) + ".ply";
  std::ofstream(path, std::ios::binary) << content;
  try
  {
    const auto mesh = ReadPly(path, [](double) {});
    std::remove(path.c_str());
    return mesh;
  }
  catch (...)
  {
    std::remove(path.c_str());
    throw;
  }
}

const std::string Vertices = "element vertex 4\nproperty float x\nproperty float y\n"
                             "property float z\n";
const std::string Faces = "element face 2\nproperty list uchar int vertex_indices\n";
const std::string Text = "ply\nformat ascii 1.0\n" + Vertices + Faces + "end_header\n" +
  "0 0 0\n1 0 0\n1 1 0.1\n0 1 0\n" + "3 0 1 2\n4 0 1 2 3\n";

} // namespace

TEST(ReadPly, CellsAndPointsKeepTheirOrder)
{
  const auto mesh = ReadText(Text);
  ASSERT_EQ(mesh->GetNumberOfPoints(), 4);
  ASSERT_EQ(mesh->GetNumberOfPolys(), 2);
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(mesh->GetPoint(2)[2], static_cast<double>(0.1f));
  vtkNew<vtkIdList> ids;
  mesh->GetPolys()->GetCellAtId(0, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 3);
  mesh->GetPolys()->GetCellAtId(1, ids);
  ASSERT_EQ(ids->GetNumberOfIds(), 4);
  EXPECT_EQ(ids->GetId(3), 3);
  EXPECT_EQ(mesh->GetPointData()->GetNormals(), nullptr);
}

TEST(ReadPly, LineEndsOfOtherSystems)
{
  std::string text;
  for (const char c : Text)
  {
    text += c == '\n' ? "\r\n" : std::string(1, c);
  }
  EXPECT_EQ(ReadText(text)->GetNumberOfPolys(), 2);
}

TEST(ReadPly, DoubleStaysDouble)
{
  std::string text = Text;
  for (const char* name : { " x", " y", " z" })
  {
    text.replace(text.find(std::string("float") + name), 5, "double");
  }
  const auto mesh = ReadText(text);
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(mesh->GetPoint(2)[2], 0.1);
}

TEST(ReadPly, EveryCutIsNoticed)
{
  const std::size_t lastValue = Text.rfind(' ') + 1; // cut behind it, the text is whole
  for (std::size_t size = 0; size <= lastValue; ++size)
  {
    EXPECT_THROW(ReadText(Text.substr(0, size)), Failure) << size;
  }
  EXPECT_EQ(ReadText(Text.substr(0, Text.size() - 1))->GetNumberOfPolys(), 2);
}

TEST(ReadPly, EveryCutOfABinaryFileIsNoticed)
{
  std::string whole = "ply\nformat binary_big_endian 1.0\nelement vertex 3\n"
                      "property uchar x\nproperty char y\nproperty short z\nelement face 1\n"
                      "property list ushort uint vertex_index\nproperty double area\nend_header\n";
  whole += std::string("\x01\xff\x01\x00"
                       "\xff\x02\xff\xfe"
                       "\x00\x00\x00\x07",
    12);
  whole += std::string("\x00\x03"
                       "\x00\x00\x00\x00"
                       "\x00\x00\x00\x01"
                       "\x00\x00\x00\x02",
    14);
  whole += std::string(8, '\0');
  const auto mesh = ReadText(whole);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 1);
  const double expected[3][3] = { { 1, -1, 256 }, { 255, 2, -2 }, { 0, 0, 7 } };
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(mesh->GetPoint(i)[k], expected[i][k]);
    }
  }
  for (std::size_t size = 0; size < whole.size(); ++size)
  {
    EXPECT_THROW(ReadText(whole.substr(0, size)), Failure) << size;
  }
}
