// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// How the corners of an OBJ file become points if they use normals, smoothing groups or texture
// coordinates.

#include "OppositeFaces.h"
#include "ReadFrom.h"
#include "ReadObj.h"
#include "SplitPoints.h"

#include <cmath>

using namespace lambent::command;

namespace
{

/// A roof: two quads that meet at a right angle along the edge from point 1 to point 2 (0 to 1).
const std::string Roof = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 -1\nv 1 0 -1\n";
const std::string Top = "f 1 2 4 3\n";   // faces +z
const std::string Front = "f 2 1 5 6\n"; // faces -y
const Rows RoofPoints = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 0, -1 },
  { 1, 0, -1 } };
const std::vector<double> Z = { 0, 0, 1 };
const std::vector<double> MinusY = { 0, -1, 0 };
const double Half = static_cast<double>(static_cast<float>(std::sqrt(0.5)));
const std::vector<double> Between = { 0, -Half, Half };

Outcome Read(const std::string& text)
{
  const Outcome outcome = ReadFrom(ReadObj, text);
  EXPECT_EQ(outcome.failure, "");
  EXPECT_EQ(outcome.warnings, "");
  return outcome;
}

Rows TextureOf(const Outcome& outcome)
{
  return RowsOf(outcome.mesh->GetPointData()->GetTCoords());
}

/// Expects the points of the file with their ids, followed by copies of the listed ones.
void ExpectPoints(const Outcome& outcome, const std::vector<std::size_t>& copies)
{
  Rows points = RoofPoints;
  for (const std::size_t copy : copies)
  {
    points.push_back(RoofPoints[copy]);
  }
  EXPECT_EQ(PointsOf(outcome), points);
}

} // namespace

TEST(ObjNormals, NoneWithoutNormalsAndGroups)
{
  const Outcome outcome = Read("vn 0 0 1\n" + Roof + Top + Front);
  ExpectPoints(outcome, {});
  EXPECT_EQ(NormalsOf(outcome), Rows());
  EXPECT_EQ(outcome.mesh->GetPointData()->GetNumberOfArrays(), 0);
}

TEST(ObjNormals, NoneIfAllHaveZeroLength)
{
  const Outcome outcome = Read(Roof + "vn 0 0 0\nvn 0 -0 0\nf 1//1 2//2 4//1 3//1\n" + Front);
  ExpectPoints(outcome, {});
  EXPECT_EQ(NormalsOf(outcome), Rows());
}

TEST(ObjNormals, EqualIndicesShareAPoint)
{
  const Outcome outcome =
    Read(Roof + "vn 0 0 2\nvn 0 -1 0\nf 1//1 2//1 4//1 3//1\nf 2//1 1//1 5//2 6//2\n");
  ExpectPoints(outcome, {});
  const std::vector<double> z2 = { 0, 0, 2 }; // as in the file
  EXPECT_EQ(NormalsOf(outcome), (Rows{ z2, z2, z2, z2, MinusY, MinusY }));
  EXPECT_EQ(PolygonsOf(outcome), (Cells{ { 0, 1, 3, 2 }, { 1, 0, 4, 5 } }));
}

TEST(ObjNormals, DifferentIndicesGetSeparatePoints)
{
  const Outcome outcome =
    Read(Roof + "vn 0 0 1\nvn 0 -1 0\nf 1//1 2//1 4//1 3//1\nf 2//2 1//2 5//2 6//-1\n");
  ExpectPoints(outcome, { 1, 0 });
  EXPECT_EQ(NormalsOf(outcome), (Rows{ Z, Z, Z, Z, MinusY, MinusY, MinusY, MinusY }));
  EXPECT_EQ(PolygonsOf(outcome), (Cells{ { 0, 1, 3, 2 }, { 6, 7, 4, 5 } }));
}

TEST(ObjNormals, ACornerWithoutANormalUsesTheFaceNormal)
{
  // A whole face without normals, one corner without, and a normal of zero length.
  const Rows normals = { Z, Z, Z, Z, MinusY, MinusY, MinusY, MinusY };
  const Cells cells = { { 0, 1, 3, 2 }, { 6, 7, 4, 5 } };
  for (const std::string front : { "f 2 1 5 6\n", "f 2 1//2 5//2 6/\n", "f 2//3 1//3 5//2 6//2\n" })
  {
    const Outcome outcome =
      Read(Roof + "vn 0 0 1\nvn 0 -1 0\nvn 0 0 0\nf 1//1 2//1 4//1 3//1\n" + front);
    ExpectPoints(outcome, { 1, 0 });
    EXPECT_EQ(NormalsOf(outcome), normals) << front;
    EXPECT_EQ(PolygonsOf(outcome), cells) << front;
  }
}

TEST(ObjNormals, ACornerWithoutANormalUsesItsSmoothingGroup)
{
  const Outcome outcome =
    Read(Roof + "v 2 0 0\nv 2 1 0\nvn 1 0 0\ns 1\n" + Top + Front + "f 2//1 7//1 8//1 4//1\n");
  ASSERT_EQ(outcome.mesh->GetNumberOfPoints(), 10);
  EXPECT_EQ(PolygonsOf(outcome), (Cells{ { 0, 1, 3, 2 }, { 1, 0, 4, 5 }, { 8, 6, 7, 9 } }));
  const std::vector<double> x = { 1, 0, 0 };
  EXPECT_EQ(NormalsOf(outcome), (Rows{ Between, Between, Z, Z, MinusY, MinusY, x, x, x, x }));
}

TEST(ObjNormals, OneGroupIsSmooth)
{
  for (const std::string group : { "s 1\n", "s 17\n", "s on\n", "g a\ns 1\no b\n" })
  {
    const Outcome outcome = Read(Roof + group + Top + Front);
    ExpectPoints(outcome, {});
    EXPECT_EQ(NormalsOf(outcome), (Rows{ Between, Between, Z, Z, MinusY, MinusY }));
  }
}

TEST(ObjNormals, DifferentGroupsAreSharp)
{
  const Rows normals = { Z, Z, Z, Z, MinusY, MinusY, MinusY, MinusY };
  for (const std::string& text : { "s 1\n" + Top + "s 2\n" + Front,
         "s 1\n" + Top + "s off\n" + Front, "s 2\n" + Top + "s 0\n" + Front,
         "s off\n" + Top + Front, "s\n" + Top + Front, Top + "s 1\n" + Front })
  {
    const Outcome outcome = Read(Roof + text);
    ExpectPoints(outcome, { 1, 0 });
    EXPECT_EQ(NormalsOf(outcome), normals) << text;
    EXPECT_EQ(PolygonsOf(outcome), (Cells{ { 0, 1, 3, 2 }, { 6, 7, 4, 5 } })) << text;
  }
}

// A sheet contains each face twice, once in each orientation: the normals of its sides must not
// cancel.
TEST(ObjNormals, SidesOfASheetAreSeparate)
{
  const std::vector<double> back = { 0, Half, -Half };
  const std::vector<double> minusZ = { 0, 0, -1 };
  const std::vector<double> y = { 0, 1, 0 };
  const Outcome sheetBySheet = Read(Roof + "s 1\n" + Top + Front + "f 2 1 3 4\nf 5 1 2 6\n");
  ExpectPoints(sheetBySheet, { 1, 0, 2, 3, 4, 5 });
  EXPECT_EQ(NormalsOf(sheetBySheet),
    (Rows{ Between, Between, Z, Z, MinusY, MinusY, back, back, minusZ, minusZ, y, y }));

  const Outcome faceByFace =
    Read(Roof + "s 1\n" + Top + "f 3 4 2 1\n" + Front + "f 6 5 1 2\n" + Top);
  ExpectPoints(faceByFace, { 2, 3, 1, 0, 5, 4 });
  EXPECT_EQ(PolygonsOf(faceByFace),
    (Cells{ { 0, 1, 3, 2 }, { 6, 7, 8, 9 }, { 1, 0, 4, 5 }, { 10, 11, 9, 8 }, { 0, 1, 3, 2 } }));
  const Rows normals = NormalsOf(faceByFace);
  EXPECT_EQ(Rows(normals.begin() + 2, normals.end()),
    (Rows{ Z, Z, MinusY, MinusY, minusZ, minusZ, back, back, y, y }));
}

TEST(OppositeFaces, RingsOfAllKinds)
{
  CellLists faces;
  for (const std::vector<std::int32_t>& face : { std::vector<std::int32_t>{ 0, 1, 2 }, { 1, 2, 0 },
         { 2, 1, 0 }, { 0, 2, 1 }, { 5, 3, 4, 9 }, { 9, 4, 3, 5 }, { 3, 4, 9, 5 }, { 3, 9, 4, 5 },
         { 5, 4, 9, 3 }, { 7, 7, 7 }, { 7, 7, 7 }, { 0, 1, 2, 3 } })
  {
    faces.points.insert(faces.points.end(), face.begin(), face.end());
    faces.EndCell();
  }
  EXPECT_EQ(FindOppositeFaces(faces),
    (std::vector<bool>{
      false, false, true, true, false, true, false, false, true, false, false, false }));
}

TEST(ObjNormals, AGroupMayOccurTwice)
{
  const Outcome outcome =
    Read(Roof + "v 2 0 0\nv 2 1 0\ns 1\n" + Top + "s 2\nf 2 7 8 4\ns 1\n" + Front);
  EXPECT_EQ(NormalsOf(outcome), (Rows{ Between, Between, Z, Z, MinusY, MinusY, Z, Z, Z, Z }));
}

TEST(ObjNormals, FacesBeforeTheFirstGroupAreFlat)
{
  // Both sides of the roof, after a face that is folded away from the top.
  const Outcome outcome = Read(Roof + "v 0 1 -1\nv 1 1 -1\nf 3 4 8 7\ns 1\n" + Top + Front);
  EXPECT_EQ(PolygonsOf(outcome), (Cells{ { 2, 3, 7, 6 }, { 0, 1, 8, 9 }, { 1, 0, 4, 5 } }));
  const std::vector<double> y = { 0, 1, 0 };
  EXPECT_EQ(NormalsOf(outcome), (Rows{ Between, Between, y, y, MinusY, MinusY, y, y, Z, Z }));
}

TEST(ObjNormals, GroupsAfterAllFacesHaveNoEffect)
{
  EXPECT_EQ(NormalsOf(Read(Roof + Top + Front + "s 1\n")), Rows());
}

TEST(ObjNormals, UnusedPointsHaveNone)
{
  const Outcome outcome = Read("v 9 9 9\n" + Roof + "s 1\nf 2 3 5 4\n");
  const std::vector<double> none = { 0, 0, 0 };
  EXPECT_EQ(NormalsOf(outcome), (Rows{ none, Z, Z, Z, Z, none, none }));
}

TEST(ObjTexture, OneForEachPoint)
{
  const Outcome outcome = Read(Roof + "vt 0 0\nvt 1 0 7\nvt .5\nf 1/1 2/2 4/3 3/1\n" + Front);
  ExpectPoints(outcome, {});
  EXPECT_EQ(
    TextureOf(outcome), (Rows{ { 0, 0 }, { 1, 0 }, { 0, 0 }, { .5, 0 }, { 0, 0 }, { 0, 0 } }));
  EXPECT_STREQ(outcome.mesh->GetPointData()->GetTCoords()->GetName(), "TCoords");
  EXPECT_EQ(NormalsOf(outcome), Rows());
}

TEST(ObjTexture, ASeamDoesNotBreakComputedNormals)
{
  const Outcome outcome = Read(Roof + "vt 0 0\nvt 1 0\nf 1/1 2/1 4/1 3/1\nf 2/2 1/2 5/2 6/2\n");
  ExpectPoints(outcome, {});
  EXPECT_EQ(outcome.mesh->GetPointData()->GetTCoords(), nullptr);
}

TEST(ObjTexture, ASeamCopiesPointsWithTheirNormals)
{
  const Rows texture = { { 0, 0 }, { 0, 0 }, { 0, 0 }, { 0, 0 }, { 1, 0 }, { 1, 0 }, { 1, 0 },
    { 1, 0 } };
  const Cells cells = { { 0, 1, 3, 2 }, { 6, 7, 4, 5 } };
  const std::string faces = "f 1/1 2/1 4/1 3/1\nf 2/2 1/2 5/2 6/2\n";
  const Outcome smooth = Read(Roof + "vt 0 0\nvt 1 0\ns 1\n" + faces);
  ExpectPoints(smooth, { 1, 0 });
  EXPECT_EQ(TextureOf(smooth), texture);
  EXPECT_EQ(PolygonsOf(smooth), cells);
  EXPECT_EQ(NormalsOf(smooth), (Rows{ Between, Between, Z, Z, MinusY, MinusY, Between, Between }));

  const Outcome flat = Read(Roof + "vt 0 0\nvt 1 0\ns off\n" + faces);
  ExpectPoints(flat, { 1, 0 }); // copied once, for both reasons
  EXPECT_EQ(TextureOf(flat), texture);
  EXPECT_EQ(NormalsOf(flat), (Rows{ Z, Z, Z, Z, MinusY, MinusY, MinusY, MinusY }));
}

TEST(ObjTexture, ColoursFollowThePoints)
{
  std::string colored = Roof;
  for (std::size_t at = 0, k = 0; (at = colored.find('\n', at)) != std::string::npos; ++k)
  {
    const std::string color = " " + std::to_string(10 * k) + " 0 255";
    colored.insert(at, color);
    at += color.size() + 1;
  }
  const Outcome outcome = Read(colored + "s off\n" + Top + Front);
  const Rows colors = RowsOf(outcome.mesh->GetPointData()->GetArray("RGB"));
  ASSERT_EQ(colors.size(), 8u);
  EXPECT_EQ(colors[5], (std::vector<double>{ 50, 0, 255 }));
  EXPECT_EQ(colors[6], (std::vector<double>{ 10, 0, 255 }));
  EXPECT_EQ(colors[7], (std::vector<double>{ 0, 0, 255 }));
}

// So many keys that different points have the same hash.
TEST(SplitPoints, KeysOfManyPoints)
{
  constexpr std::int32_t count = 300000;
  std::vector<std::int32_t> corners;
  std::vector<std::int32_t> keys;
  for (const std::int32_t key : { 0, 1, 1, 0, NoKey })
  {
    for (std::int32_t point = 0; point < count; ++point)
    {
      corners.push_back(point);
      keys.push_back(key);
    }
  }
  const SplitPoints split(corners, keys, count);
  ASSERT_EQ(split.copies.size(), static_cast<std::size_t>(count));
  ASSERT_EQ(split.keyOfPoint.size(), static_cast<std::size_t>(2 * count));
  for (std::int32_t point = 0; point < count; ++point)
  {
    const std::size_t at = static_cast<std::size_t>(point);
    ASSERT_EQ(split.copies[at], point);
    ASSERT_EQ(split.keyOfPoint[at], 0);
    ASSERT_EQ(split.keyOfPoint[at + count], 1);
    const std::int32_t expected[] = { point, count + point, count + point, point, point };
    for (std::size_t k = 0; k < 5; ++k)
    {
      ASSERT_EQ(corners[at + k * count], expected[k]) << k;
    }
  }
}

// Each corner at one point has its own normal; telling all of them apart must take little time.
TEST(ObjNormals, VeryManyAtOnePoint)
{
  constexpr int count = 100000;
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\ns off\n";
  for (int k = 0; k < count; ++k)
  {
    text += "f 1 2 3\n";
  }
  const Outcome outcome = Read(text);
  EXPECT_EQ(outcome.mesh->GetNumberOfPoints(), 3 * count);
  EXPECT_EQ(NormalsOf(outcome), Rows(3 * count, Z));
}
