// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadFrom.h"
#include "ReadPly.h"

#include "vtkUnsignedCharArray.h"

using namespace lambent::command;

namespace
{

vtkSmartPointer<vtkPolyData> ReadText(const std::string& content)
{
  const Outcome outcome = ReadFrom(ReadPly, content);
  if (!outcome.mesh)
  {
    throw Failure(outcome.failure);
  }
  return outcome.mesh;
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
  for (const std::string end : { "\r\n", "\r" })
  {
    std::string text;
    for (const char c : Text)
    {
      text += c == '\n' ? end : std::string(1, c);
    }
    const Outcome outcome = ReadFrom(ReadPly, text);
    EXPECT_EQ(outcome.warnings, "");
    EXPECT_EQ(PolygonsOf(outcome), (Cells{ { 0, 1, 2 }, { 0, 1, 2, 3 } }));
  }
}

// After the line end of a header, LF or CR, any byte is data, even the other line end.
TEST(ReadPly, LineEndsBeforeBinaryData)
{
  for (const std::string end : { "\n", "\r\n", "\r" })
  {
    std::string bytes = "ply@format binary_little_endian 1.0@element vertex 1@property char x@"
                        "property char y@property char z@end_header@";
    for (std::size_t at; (at = bytes.find('@')) != std::string::npos;)
    {
      bytes.replace(at, 1, end);
    }
    for (const int first : { 10, 13, 5 })
    {
      const Outcome outcome =
        ReadFrom(ReadPly, bytes + std::string{ static_cast<char>(first), 2, 3 });
      EXPECT_EQ(PointsOf(outcome), (Rows{ { static_cast<double>(first), 2, 3 } }));
    }
  }
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

TEST(ReadPly, EveryCutIsDetected)
{
  const std::size_t lastValue = Text.rfind(' ') + 1; // a cut after this looks complete
  for (std::size_t size = 0; size <= lastValue; ++size)
  {
    EXPECT_THROW(ReadText(Text.substr(0, size)), Failure) << size;
  }
  EXPECT_EQ(ReadText(Text.substr(0, Text.size() - 1))->GetNumberOfPolys(), 2);
}

TEST(ReadPly, EveryCutOfABinaryFileIsDetected)
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

namespace
{

std::string WithStrips(const std::string& list, const std::string& values)
{
  return "ply\nformat ascii 1.0\n" + Vertices + "element tristrips 1\nproperty list " + list +
    " vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + values + "\n";
}

} // namespace

TEST(ReadPly, TriangleStrips)
{
  const Outcome one = ReadFrom(ReadPly, WithStrips("int int", "4 0 1 3 2"));
  EXPECT_EQ(one.warnings, "");
  EXPECT_EQ(CellsOf(one.mesh->GetStrips()), (Cells{ { 0, 1, 3, 2 } }));
  EXPECT_EQ(one.mesh->GetNumberOfPolys(), 0);
  for (const char* const values :
    { "9 0 1 3 2 -1 3 1 2 -1", "8 0 1 3 2 -1 3 1 2", "11 -1 0 1 3 2 -1 -1 3 1 2 -1" })
  {
    const Outcome several = ReadFrom(ReadPly, WithStrips("int int", values));
    EXPECT_EQ(several.warnings, "");
    EXPECT_EQ(CellsOf(several.mesh->GetStrips()), (Cells{ { 0, 1, 3, 2 }, { 3, 1, 2 } })) << values;
  }
  const Outcome isUnsigned = ReadFrom(ReadPly, WithStrips("uint uint", "7 0 1 2 4294967295 3 1 2"));
  EXPECT_EQ(CellsOf(isUnsigned.mesh->GetStrips()), (Cells{ { 0, 1, 2 }, { 3, 1, 2 } }));
}

TEST(ReadPly, InvalidTriangleStrips)
{
  const Outcome outcome = ReadFrom(ReadPly, WithStrips("int int", "7 0 -1 0 1 2 -1 3"));
  EXPECT_EQ(outcome.warnings,
    "lambent: warning: triangle strips of fewer than 3 points are skipped; it has 2 of them\n");
  EXPECT_EQ(CellsOf(outcome.mesh->GetStrips()), (Cells{ { 0, 1, 2 } }));
  EXPECT_EQ(ReadFrom(ReadPly, WithStrips("int int", "4 0 1 2 -2")).failure,
    "triangle strip 0 uses a vertex that does not exist");
  std::string text = WithStrips("int int", "3 0 1 2");
  text.replace(text.find("vertex_indices"), 14, "points");
  EXPECT_EQ(ReadFrom(ReadPly, text).failure, "its triangle strips have no list 'vertex_indices'");
}

TEST(ReadPly, ExtraNumbersOnALine)
{
  std::string text = Text;
  text.replace(text.find("1 0 0\n"), 6, "1 0 0 255 7\n");
  text.replace(text.find("3 0 1 2\n"), 8, "3 0 1 2 9\n");
  const Outcome outcome = ReadFrom(ReadPly, text);
  EXPECT_EQ(outcome.warnings,
    "lambent: warning: numbers left over on a line are ignored, since each element has its own "
    "line; it has 3 of them, the first in line 11\n");
  EXPECT_EQ(PolygonsOf(outcome), (Cells{ { 0, 1, 2 }, { 0, 1, 2, 3 } }));
  EXPECT_EQ(PointsOf(outcome), PointsOf(ReadFrom(ReadPly, Text)));
}

TEST(ReadPly, AnElementMayContinueOnTheNextLine)
{
  std::string text = Text;
  text.replace(text.find("1 0 0\n"), 6, "1\n 0\n\n0\n");
  text.replace(text.find("4 0 1 2 3\n"), 10, "4 0 1\n2 3\n");
  const Outcome outcome = ReadFrom(ReadPly, text);
  EXPECT_EQ(outcome.warnings, "");
  EXPECT_EQ(PolygonsOf(outcome), (Cells{ { 0, 1, 2 }, { 0, 1, 2, 3 } }));
}

TEST(ReadPly, ExtraDataAtTheEnd)
{
  const Outcome text = ReadFrom(ReadPly, Text + "\n3 0 1\n");
  EXPECT_EQ(text.warnings,
    "lambent: warning: ignored 6 bytes after the last element that its header declares\n");
  EXPECT_EQ(text.mesh->GetNumberOfPolys(), 2);
  EXPECT_EQ(ReadFrom(ReadPly, Text + "\n \r\n\t").warnings, "");
  const std::string binary =
    "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\n"
    "property char y\nproperty char z\nend_header\nabc";
  EXPECT_EQ(ReadFrom(ReadPly, binary + "\n").warnings, "");
  EXPECT_EQ(ReadFrom(ReadPly, binary + "d").warnings,
    "lambent: warning: ignored 1 byte after the last element that its header declares\n");
  EXPECT_EQ(ReadFrom(ReadPly, binary + "de").warnings,
    "lambent: warning: ignored 2 bytes after the last element that its header declares\n");
}

TEST(ReadPly, EmptyFacesKeepTheirIds)
{
  std::string text = Text;
  text.replace(text.find("3 0 1 2\n"), 8, "0\n");
  EXPECT_EQ(PolygonsOf(ReadFrom(ReadPly, text)), (Cells{ {}, { 0, 1, 2, 3 } }));
}

TEST(ReadPly, InvalidNumbersAreNamedWithTheirLine)
{
  std::string text = Text;
  text.replace(text.find("1 1 0.1"), 7, "1 one 0");
  EXPECT_EQ(ReadFrom(ReadPly, text).failure, "line 12: found 'one' where a number is expected");
}

TEST(ReadPly, NormalsBelongToTheVerticesInUse)
{
  const std::string vertex = "property float x\nproperty float y\nproperty float z\n";
  const Outcome outcome = ReadFrom(ReadPly,
    "ply\nformat ascii 1.0\nelement vertex 1\n" + vertex +
      "property float nx\nproperty float ny\nproperty float nz\nelement vertex 2\n" + vertex +
      "end_header\n0 0 0 1 0 0\n1 1 1\n2 2 2\n");
  EXPECT_EQ(outcome.mesh->GetNumberOfPoints(), 2);
  EXPECT_EQ(NormalsOf(outcome), Rows());
}

namespace
{

/// The colours of two vertices, whose properties and values follow x, y and z.
vtkSmartPointer<vtkUnsignedCharArray> ColorsOf(
  const std::string& properties, const std::string& first, const std::string& second)
{
  const auto mesh = ReadText("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                             "property float y\nproperty float z\n" +
    properties + "end_header\n0 0 0 " + first + "\n1 1 1 " + second + "\n");
  return vtkUnsignedCharArray::SafeDownCast(mesh->GetPointData()->GetScalars());
}

std::string Properties(const std::string& type, const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += "property " + type + " " + name + "\n";
  }
  return text;
}

} // namespace

TEST(ReadPly, ColorsAreActiveScalars)
{
  const auto rgb = ColorsOf(Properties("uchar", { "red", "green", "blue" }), "255 128 0", "1 2 3");
  ASSERT_TRUE(rgb);
  EXPECT_STREQ(rgb->GetName(), "RGB");
  EXPECT_EQ(RowsOf(rgb), (Rows{ { 255, 128, 0 }, { 1, 2, 3 } }));
  // In any order, between other properties.
  const auto rgba = ColorsOf(Properties("uint8", { "alpha", "blue", "confidence", "red", "green" }),
    "4 3 9 1 2", "40 30 90 10 20");
  ASSERT_TRUE(rgba);
  EXPECT_STREQ(rgba->GetName(), "RGBA");
  EXPECT_EQ(RowsOf(rgba), (Rows{ { 1, 2, 3, 4 }, { 10, 20, 30, 40 } }));
}

TEST(ReadPly, ColorsAsFloatsGoToOne)
{
  for (const char* const type : { "float", "double" })
  {
    const auto rgb =
      ColorsOf(Properties(type, { "red", "green", "blue" }), "0 0.5 1", "-1 1e9 nan");
    EXPECT_EQ(RowsOf(rgb), (Rows{ { 0, 128, 255 }, { 0, 255, 0 } })) << type;
  }
}

TEST(ReadPly, OtherPropertiesAreNotColors)
{
  EXPECT_FALSE(ColorsOf(Properties("uchar", { "red", "green" }), "1 2", "3 4"));
  EXPECT_FALSE(ColorsOf(Properties("int", { "red", "green", "blue" }), "1 2 3", "4 5 6"));
  EXPECT_FALSE(ColorsOf(
    Properties("uchar", { "red", "green" }) + Properties("float", { "blue" }), "1 2 3", "4 5 6"));
  EXPECT_FALSE(
    ColorsOf("property list uchar uchar red\n" + Properties("uchar", { "green", "blue" }),
      "1 7 2 3", "0 5 6"));
  // Alpha of another type is left out.
  EXPECT_EQ(
    ColorsOf(Properties("uchar", { "red", "green", "blue" }) + Properties("float", { "alpha" }),
      "1 2 3 1", "4 5 6 1")
      ->GetNumberOfComponents(),
    3);
}
