// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadFrom.h"
#include "ReadStl.h"

#include <cctype>
#include <cstdint>
#include <cstring>
#include <limits>

using namespace lambent::command;

namespace
{

const Rows SquarePoints = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0.5 } };
const Cells SquareCells = { { 0, 1, 2 }, { 0, 2, 3 } };

const std::string Square = "solid square\n"
                           "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n"
                           "      vertex 1 0 0\n      vertex 1 1 0\n    endloop\n  endfacet\n"
                           "  facet normal 0 0 1\n    outer loop\n      vertex 0 -0 0\n"
                           "      vertex 1 1.0 0\n      vertex 0 1 0.5\n    endloop\n  endfacet\n"
                           "endsolid square\n";

Outcome Read(const std::string& bytes)
{
  return ReadFrom(ReadStl, bytes);
}

void ExpectSquare(const std::string& bytes, const std::string& warnings = "")
{
  const Outcome outcome = Read(bytes);
  EXPECT_EQ(outcome.failure, "") << bytes;
  EXPECT_EQ(outcome.warnings, warnings) << bytes;
  EXPECT_EQ(PointsOf(outcome), SquarePoints) << bytes;
  EXPECT_EQ(PolygonsOf(outcome), SquareCells) << bytes;
}

void ExpectFailure(const std::string& bytes, const std::string& failure)
{
  EXPECT_EQ(Read(bytes).failure, failure) << bytes;
}

std::string Replaced(std::string text, const std::string& old, const std::string& by)
{
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
  {
    text.replace(at, old.size(), by);
  }
  return text;
}

void AppendWord(std::string& bytes, std::uint32_t word)
{
  for (int shift = 0; shift < 32; shift += 8)
  {
    bytes += static_cast<char>(word >> shift & 0xff);
  }
}

void AppendFloat(std::string& bytes, float value)
{
  std::uint32_t word;
  std::memcpy(&word, &value, sizeof(word));
  AppendWord(bytes, word);
}

/// The square, with another header or count.
std::string Binary(const std::string& header = "made by a test", std::uint32_t count = 2)
{
  std::string bytes = header;
  bytes.resize(80, ' ');
  AppendWord(bytes, count);
  for (const auto& cell : SquareCells)
  {
    bytes.append(12, '\xff'); // a NaN as the normal
    for (const vtkIdType id : cell)
    {
      for (const double coordinate : SquarePoints[static_cast<std::size_t>(id)])
      {
        // The first point of the second triangle has negative zeros.
        const bool isSecond = bytes.size() > 84 + 50;
        AppendFloat(bytes, static_cast<float>(coordinate == 0 && isSecond ? -0.0 : coordinate));
      }
    }
    bytes.append(2, '\x7f');
  }
  return bytes;
}

} // namespace

TEST(ReadStl, Text)
{
  ExpectSquare(Square);
  EXPECT_EQ(Read(Square).mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  ExpectSquare(Square.substr(0, Square.size() - 1)); // the last line does not end
  ExpectSquare(Replaced(Square, "\n", "\r\n"));
  ExpectSquare(Replaced(Square, "\n", "\r"));
  ExpectSquare("\xef\xbb\xbf\n \n" + Square);
  ExpectSquare(Replaced(Square, " square", ""));
}

TEST(ReadStl, TextInCapitals)
{
  std::string capitals = Square;
  for (char& c : capitals)
  {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  ExpectSquare(capitals);
  ExpectSquare(Replaced(Square, "facet", "Facet"));
}

TEST(ReadStl, TextWithANameInAnyCharacters)
{
  ExpectSquare(Replaced(Square, "square", "W\xc3\xbcrfel"));
  ExpectSquare(Replaced(Square, "square", "W\xfcrfel")); // Latin-1
  ExpectSquare(Replaced(Square, "square", "facet of vertex 1 2 3"));
  ExpectSquare(Replaced(Square, "square", std::string(300, '\xe9')));
}

TEST(ReadStl, TextWithBadNormals)
{
  ExpectSquare(Replaced(Square, "normal 0 0 1", "normal -nan(ind) 1.#QNAN nan"));
  ExpectSquare(Replaced(Square, "normal 0 0 1", "normal 0 0"));
  ExpectSquare(Replaced(Square, "normal 0 0 1", ""));
}

TEST(ReadStl, TextOfSeveralSolids)
{
  ExpectSquare(
    Replaced(Square, "  endfacet\n  facet", "  endfacet\nendsolid a\n\nsolid b\n  facet"));
  ExpectSquare(Square.substr(Square.find("  facet"))); // without "solid"
}

TEST(ReadStl, TextWithMoreCorners)
{
  const std::string text = Replaced(Square, "    endloop", "      vertex 5 5 5\n    endloop");
  EXPECT_EQ(PolygonsOf(Read(text)), (Cells{ { 0, 1, 2, 3 }, { 0, 2, 4, 3 } }));
}

TEST(ReadStl, TextAfterTheSolid)
{
  ExpectSquare(Square + "\nThat is all.\n",
    "lambent: warning: line 18 and everything after it are ignored, outside of any solid\n");
}

TEST(ReadStl, IncompleteText)
{
  ExpectFailure(Square.substr(0, Square.find("endsolid")),
    "line 16: it is incomplete: it ends where 'facet' or 'endsolid' is expected");
  ExpectFailure(Square.substr(0, Square.find("vertex 1 1")),
    "line 6: it is incomplete: it ends where 'vertex' is expected");
  ExpectFailure(
    Square.substr(0, Square.find("vertex 1 1") + 10), "line 6: it ends where a number is expected");
  ExpectFailure(
    Replaced(Square, "vertex 1 0 0", "vertex 1 0"), "line 5: it ends where a number is expected");
  ExpectFailure(Replaced(Square, "vertex 1 0 0", "vertex 1 o 0"),
    "line 5: found 'o' where a number is expected");
  ExpectFailure(Replaced(Square, "vertex 1 0 0", "vertex 1 0 0 0"),
    "line 5: found '0' where 'vertex' is expected");
  ExpectFailure(Replaced(Square, "      vertex 1 0 0\n", ""),
    "line 6: found 'endloop' where 'vertex' is expected");
  ExpectFailure(
    Replaced(Square, "  endfacet\n", ""), "line 8: found 'facet' where 'endfacet' is expected");
  ExpectFailure(
    Replaced(Square, "outer loop", "loop"), "line 3: found 'loop' where 'outer loop' is expected");
  ExpectFailure(Replaced(Square, "  facet", "  facett"),
    "line 2: found 'facett' where 'facet' or 'endsolid' is expected");
}

TEST(ReadStl, Binary)
{
  ExpectSquare(Binary());
  EXPECT_EQ(Read(Binary()).mesh->GetPoints()->GetDataType(), VTK_FLOAT);
  ExpectSquare(Binary("solid made by a test"));
  ExpectSquare(Binary("SOLID\nfacet normal"));
  ExpectSquare(Binary(std::string(80, '\0')));
}

TEST(ReadStl, BinaryCutAfterEachByte)
{
  for (const std::string header : { "made by a test", "solid made by a test" })
  {
    const std::string whole = Binary(header);
    for (std::size_t size = 1; size < whole.size(); ++size)
    {
      EXPECT_NE(Read(whole.substr(0, size)).failure, "") << size;
    }
  }
  ExpectFailure(Binary().substr(0, 84 + 99),
    "it is incomplete or not an STL file: it is too short for the 2 triangles that it declares; "
    "use "
    "a complete copy");
  ExpectFailure("no mesh",
    "it is incomplete or not an STL file: it is too short for a header; use a complete copy");
}

TEST(ReadStl, BinaryWithAWrongCount)
{
  ExpectSquare(Binary("", 0),
    "lambent: warning: the number of triangles in its header is 0, but there are 2; all of them "
    "are read\n");
  ExpectSquare(Binary("solid", 1),
    "lambent: warning: the number of triangles in its header is 1, but there are 2; all of them "
    "are read\n");
  EXPECT_NE(Read(Binary("", 0xffffffff)).failure.find("4294967295 triangles"), std::string::npos);
  ExpectSquare(Binary() + "bye", "lambent: warning: ignored 3 bytes after its last triangle\n");
}

TEST(ReadStl, AnyNumberOfEqualPointsIsMerged)
{
  // A strip of squares; several triangles name each of its points.
  constexpr int count = 5000;
  std::string text = "solid\n";
  const auto vertex = [](int x, int y)
  { return "vertex " + std::to_string(x) + " " + std::to_string(y) + " 0\n"; };
  for (int k = 0; k < count; ++k)
  {
    text += "facet normal 0 0 1\nouter loop\n" + vertex(k, 0) + vertex(k + 1, 0) + vertex(k, 1) +
      "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\n" + vertex(k, 1) + vertex(k + 1, 0) +
      vertex(k + 1, 1) + "endloop\nendfacet\n";
  }
  const Outcome outcome = Read(text + "endsolid\n");
  EXPECT_EQ(outcome.mesh->GetNumberOfPoints(), 2 * (count + 1));
  EXPECT_EQ(outcome.mesh->GetNumberOfPolys(), 2 * count);
  EXPECT_EQ(PolygonsOf(outcome)[1], (std::vector<vtkIdType>{ 2, 1, 3 }));
}
