// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Reading the lines of an OBJ file in all their forms. TestObjNormals.cxx tests normals, smoothing
// groups and texture coordinates.

#include "ReadFrom.h"
#include "ReadObj.h"

using namespace lambent::command;

namespace
{

const std::string Square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const Rows SquarePoints = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
const Cells SquareCells = { { 0, 1, 2 }, { 0, 2, 3 } };

Outcome Read(const std::string& text)
{
  return ReadFrom(ReadObj, text);
}

/// Expects that the text is the square of two triangles, without any message.
void ExpectSquare(const std::string& text)
{
  const Outcome outcome = Read(text);
  EXPECT_EQ(outcome.failure, "") << text;
  EXPECT_EQ(outcome.warnings, "") << text;
  EXPECT_EQ(PointsOf(outcome), SquarePoints) << text;
  EXPECT_EQ(PolygonsOf(outcome), SquareCells) << text;
}

void ExpectFailure(const std::string& text, const std::string& failure)
{
  const Outcome outcome = Read(text);
  EXPECT_EQ(outcome.failure, failure) << text;
  EXPECT_EQ(outcome.mesh, nullptr) << text;
}

} // namespace

TEST(ReadObj, LineEndsOfAllSystems)
{
  const std::string text = Square + "# two triangles\n\nf 1 2 3\nf 1 3 4\n";
  for (const std::string end : { "\n", "\r\n", "\r", " \n", "\n\n", "\t\r\n  " })
  {
    std::string other;
    for (const char c : text)
    {
      other += c == '\n' ? end : std::string(1, c);
    }
    ExpectSquare(other);
  }
}

TEST(ReadObj, LastLineWithoutALineEnd)
{
  ExpectSquare(Square + "f 1 2 3\nf 1 3 4");
  ExpectSquare("f 1 2 3\nf 1 3 4\n" + Square.substr(0, Square.size() - 1));
  ExpectSquare(Square + "f 1 2 3\nf 1 3 4\n# bye");
  ExpectSquare(Square + "f 1 2 3\nf 1 3 4 \\\n");
}

TEST(ReadObj, ByteOrderMark)
{
  ExpectSquare("\xef\xbb\xbf" + Square + "f 1 2 3\nf 1 3 4\n");
}

TEST(ReadObj, Comments)
{
  ExpectSquare("# v 9 9 9\n" + Square + "f 1 2 3 # the first\nf 1 3 4#the second\n  # done\n");
  // A path in a comment or a name may end with a backslash; the next line is separate.
  ExpectSquare("# C:\\models\\\n" + Square + "g C:\\\nf 1 2 3\nf 1 3 4\n");
}

TEST(ReadObj, ContinuedLines)
{
  ExpectSquare(Square + "f 1 \\\n2 \\\r\n3\nf\\\n 1 3\\ \n 4\n");
  ExpectSquare("v 0 \\\n 0 0\n" + Square.substr(8) + "f 1 2 3\nf 1 3 4\n");
  ExpectFailure("v 0 0 \\\n\\\n x\n", "line 3: found 'x' where a number is expected");
}

TEST(ReadObj, UnknownLines)
{
  ExpectSquare("mtllib a b.mtl\no\n" + Square +
    "g\ng a b\nusemtl \nusemtl\nf 1 2 3\nusemap off\nvp 1 2\nxyz 1 2 3\nf 1 3 4\nend\n");
}

TEST(ReadObj, AllFormsOfCorners)
{
  const std::string rest = Square + "vt 0 0\nvn 0 0 1\n";
  for (const std::string corner : { "", "/", "//", "/1", "/1/", "//1", "/1/1" })
  {
    const std::string other = "f 1" + corner + " 2" + corner + " 3" + corner + "\n";
    ExpectSquare(rest + other + "f 1" + corner + " 3" + corner + " 4" + corner);
  }
}

TEST(ReadObj, NegativeIndicesCountBackFromTheirLine)
{
  ExpectSquare(Square + "f -4 -3 -2\nf -4 -2 -1\n");
  ExpectSquare(Square.substr(0, 24) + "f -3 -2 -1\n" + Square.substr(24) + "f 1 -2 4\n");
}

TEST(ReadObj, FacesBeforeTheirPoints)
{
  ExpectSquare("f 1 2 3\nf 1 3 4\n" + Square);
}

TEST(ReadObj, PolygonsOfAnyNumberOfPoints)
{
  const Outcome outcome = Read(Square + "v 0 .5 0\nf 1 2 3 4 5\nfo 1 2 3 4\n");
  EXPECT_EQ(PolygonsOf(outcome), (Cells{ { 0, 1, 2, 3, 4 }, { 0, 1, 2, 3 } }));
}

TEST(ReadObj, FacesOfTooFewPointsAreCounted)
{
  const Outcome outcome = Read(Square + "f 1 2\nf 1 2 3\nf 1\nf\nl 3\nf 1 3 4\n");
  EXPECT_EQ(PolygonsOf(outcome), SquareCells);
  EXPECT_EQ(outcome.warnings,
    "lambent: warning: faces (f) of fewer than 3 points and lines (l) of fewer than 2 are skipped; "
    "it has 4 of them\n");
}

TEST(ReadObj, LinesAndPointsAreKept)
{
  const Outcome outcome = Read(Square + "vt 0 0\nl 1/1 2/1 3/1\np 4 -4\nl 3 4\n");
  EXPECT_EQ(outcome.warnings, "");
  EXPECT_EQ(CellsOf(outcome.mesh->GetLines()), (Cells{ { 0, 1, 2 }, { 2, 3 } }));
  EXPECT_EQ(CellsOf(outcome.mesh->GetVerts()), (Cells{ { 3, 0 } }));
  EXPECT_EQ(PolygonsOf(outcome), Cells());
}

TEST(ReadObj, FreeFormSurfacesAreCounted)
{
  const Outcome outcome = Read(Square + "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 4 \\\n 3\nend\n");
  EXPECT_EQ(outcome.warnings,
    "lambent: warning: free-form surfaces (surf) are skipped; it has 1 of them\n");
}

TEST(ReadObj, CoordinatesAreDouble)
{
  const Outcome outcome = Read("v 10000000.001 .1 -1.25e-3\nv +1 2. 0 \nv 1 1 1 0.5\n");
  EXPECT_EQ(outcome.mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(PointsOf(outcome), (Rows{ { 10000000.001, .1, -.00125 }, { 1, 2, 0 }, { 1, 1, 1 } }));
}

TEST(ReadObj, ColoursOfPoints)
{
  const auto colors = [](const std::string& text)
  { return RowsOf(Read(text).mesh->GetPointData()->GetArray("RGB")); };
  EXPECT_EQ(colors("v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0\nv 0 0 1 0 0 0.2 1\n"),
    (Rows{ { 255, 255, 255 }, { 255, 128, 0 }, { 255, 255, 255 }, { 0, 0, 51 } }));
  EXPECT_EQ(
    colors("v 0 0 0 255 128 0\nv 1 0 0 1 300 -5\n"), (Rows{ { 255, 128, 0 }, { 1, 255, 0 } }));
  EXPECT_EQ(
    colors("v 0 0 0 1 0.5 1.5\nv 1 0 0 0 0 3\n"), (Rows{ { 255, 128, 255 }, { 0, 0, 255 } }));
  EXPECT_EQ(colors("v 0 0 0 1 0 1\n"), (Rows{ { 255, 0, 255 } }));
  EXPECT_EQ(colors("v 0 0 0 1\nv 1 0 0\n"), Rows());
  const Outcome outcome = Read("v 0 0 0 1 1 1\n");
  EXPECT_EQ(outcome.mesh->GetPointData()->GetScalars()->GetDataType(), VTK_UNSIGNED_CHAR);
}

TEST(ReadObj, InvalidIndices)
{
  const std::string mend = "; correct the line, or use a complete copy";
  ExpectFailure(Square + "f 1 2 5\n", "line 5 uses point 5, but the file has 4 points (v)" + mend);
  ExpectFailure(Square + "f 1 2 9\nf 1 2 7\nf 1 2 20\nv 0 0 0\n",
    "line 5 uses point 9, but the file has 5 points (v)" + mend);
  ExpectFailure(Square + "f 1 2 5\nf 1 2 6\nf 1 2 7\nv 0 0 0\nv 0 0 0\n",
    "line 7 uses point 7, but the file has 6 points (v)" + mend);
  ExpectFailure(Square + "f 0 1 2\n",
    "line 5 uses point 0, but indices start at 1; so far the file has 4 points (v)" + mend);
  ExpectFailure("v 0 0 0\nf 1 1 -2\nv 0 0 0\n",
    "line 2 uses point -2, but before that line it has 1 point (v)" + mend);
  ExpectFailure(Square + "f 1 2 99999999999999999999\n",
    "line 5 uses point 9223372036854775807, but the file has 4 points (v)" + mend);
  ExpectFailure(Square + "f 1 2 4294967297\n",
    "line 5 uses point 4294967297, but the file has 4 points (v)" + mend);
  ExpectFailure(
    Square + "f 1//1 2//1 3//1\n", "line 5 uses normal 1, but the file has no normals (vn)" + mend);
  ExpectFailure(Square + "vt 0 0\nf 1/1 2/2 3/1\n",
    "line 6 uses texture coordinate 2, but the file has 1 texture coordinate (vt)" + mend);
  ExpectFailure(Square + "vn 0 0 1\nf 1/1 2/2 3/1\n",
    "line 6 uses texture coordinate 1, but the file has no texture coordinates (vt)" + mend);
  ExpectFailure(Square + "vn 0 0 1\nf 1//0 2//1 3//1\n",
    "line 6 uses normal 0, but indices start at 1; so far the file has 1 normal (vn)" + mend);
  ExpectFailure(Square + "l 1 5\n", "line 5 uses point 5, but the file has 4 points (v)" + mend);
  ExpectFailure(Square + "f 1 5\n", "line 5 uses point 5, but the file has 4 points (v)" + mend);
}

TEST(ReadObj, InvalidNumbers)
{
  ExpectFailure("v 0 0 0\r\nv 0 x 0\r\n", "line 2: found 'x' where a number is expected");
  ExpectFailure("v 0 0\nv 0 0 0\n", "line 1: a point (v) has 2 numbers and needs 3");
  ExpectFailure("v 1,2,3\n", "line 1: found '1,2,3' where a number is expected");
  ExpectFailure("v 0 0 nan\n", "line 1: 'nan' is not a finite number");
  ExpectFailure("v 0 0 1e999\n", "line 1: '1e999' is not a finite number");
  ExpectFailure("v 0 0 1.#IND\n", "line 1: found '1.#IND' where a number is expected");
  ExpectFailure("v 0 0 0 \x01\x80\n", "line 1: found '\x3f\x3f' where a number is expected");
  ExpectFailure("v 0 0 0\rvn 0 1\r", "line 2: a normal (vn) has 2 numbers and needs 3");
  ExpectFailure("vt\n", "line 1: a texture coordinate (vt) has 0 numbers and needs 1");
  ExpectFailure("vn 0 0 1e39\n", "line 1: it has a number beyond the range of a float");
  ExpectFailure(Square + "f 1 2 x\n",
    "line 5: found 'x' where a corner like 1, 1/1, 1//1 or 1/1/1 is expected");
  for (const std::string corner : { "1/1/1/1", "/1", "1.5", "1-", "1 /1", "1///1", "--1" })
  {
    const Outcome outcome = Read(Square + "vt 0 0\nvn 0 0 1\nf 2 3 " + corner + "\n");
    EXPECT_EQ(outcome.failure.rfind("line 7: found '", 0), 0u) << corner << ": " << outcome.failure;
  }
  const std::string zero("v 0 0 0\0\n", 9);
  ExpectFailure(zero, "line 1: found '0?' where a number is expected");
}

TEST(ReadObj, EmptyFiles)
{
  const Outcome outcome = Read("Dear reader,\nthis is a letter.\n");
  EXPECT_EQ(outcome.failure, "");
  EXPECT_EQ(outcome.mesh->GetNumberOfPoints(), 0);
}
