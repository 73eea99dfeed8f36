// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// If a downstream filter requests a part of the image, only that part is computed, and it equals
// that part of the whole image bit for bit.
#include "Meshes.h"

#include "vtkExtractVOI.h"
#include "vtkImageDataStreamer.h"

#include <set>
#include <utility>

namespace
{
void setUp(Studio& studio)
{
  studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
  studio.camera->SetWindowCenter(0.1, -0.2);
  studio.tracer->AddInputDataObject(makeSphere(12));
  studio.tracer->AddInputDataObject(makeBox(0.8, 0.9, 0.7));
  studio.tracer->SetBackground2(0.5, 0.6, 0.7);
  studio.tracer->GradientBackgroundOn();
}

const int windows[][4] = { { 0, 0, 0, 0 }, { 100, 100, 66, 66 }, { 0, 100, 33, 33 },
  { 50, 50, 0, 66 }, { 31, 64, 32, 33 }, { 7, 93, 5, 61 }, { 33, 47, 0, 66 } };
}

TEST(Extents, PartsEqualTheWhole)
{
  Studio studio(101, 67);
  setUp(studio);
  const Picture whole = render(studio.tracer);
  for (const auto& w : windows)
  {
    Studio part(101, 67);
    setUp(part);
    const int extent[6] = { w[0], w[1], w[2], w[3], 0, 0 };
    part.tracer->UpdateExtent(extent);
    const Picture picture(part.tracer->GetOutput());
    ASSERT_EQ(picture.width(), w[1] - w[0] + 1); // no more than was requested
    ASSERT_EQ(picture.height(), w[3] - w[2] + 1);
    for (int j = w[2]; j <= w[3]; ++j)
    {
      EXPECT_EQ(picture.bits(w[0], w[1] + 1, j), whole.bits(w[0], w[1] + 1, j))
        << "row " << j << " of columns " << w[0] << " to " << w[1];
    }
  }
}

TEST(Extents, ExtractVOIRequestsItsPart)
{
  Studio studio(101, 67);
  setUp(studio);
  const Picture whole = render(studio.tracer);
  for (const auto& w : windows)
  {
    Studio part(101, 67);
    setUp(part);
    vtkNew<vtkExtractVOI> voi;
    voi->SetInputConnection(part.tracer->GetOutputPort());
    voi->SetVOI(w[0], w[1], w[2], w[3], 0, 0);
    voi->Update();
    EXPECT_EQ(part.tracer->GetOutput()->GetNumberOfPoints(),
      static_cast<vtkIdType>(w[1] - w[0] + 1) * (w[3] - w[2] + 1));
    const Picture picture(voi->GetOutput());
    std::string expected;
    for (int j = w[2]; j <= w[3]; ++j)
    {
      expected += whole.bits(w[0], w[1] + 1, j);
    }
    EXPECT_EQ(picture.bits(), expected);
  }
}

TEST(Extents, StreamedInDivisions)
{
  for (int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT })
  {
    Studio studio(101, 67), parts(101, 67);
    setUp(studio);
    setUp(parts);
    studio.tracer->SetOutputScalarType(type);
    parts.tracer->SetOutputScalarType(type);
    const Picture whole = render(studio.tracer);
    vtkNew<vtkImageDataStreamer> streamer;
    streamer->SetInputConnection(parts.tracer->GetOutputPort());
    streamer->SetNumberOfStreamDivisions(7);
    streamer->Update();
    const Picture streamed(streamer->GetOutput());
    EXPECT_SAME_BITS(whole, streamed);
    EXPECT_LT(parts.tracer->GetOutput()->GetNumberOfPoints(), 101 * 67);
  }
}

// Pieces share the pixels on their borders.
TEST(Extents, SurplusPiecesAreEmpty)
{
  constexpr int pieces = 100; // more than the image has pixels
  for (int samples : { 1, 2 })
  {
    Studio studio(10, 7);
    setUp(studio);
    studio.tracer->SetSupersampling(samples);
    studio.tracer->GenerateIdsOn();
    const Picture whole = render(studio.tracer);
    std::set<std::pair<int, int>> pixels;
    int emptyPieces = 0;
    for (int piece = 0; piece < pieces; ++piece)
    {
      EXPECT_TRUE(studio.tracer->UpdatePiece(piece, pieces, 0));
      int part[6];
      studio.tracer->GetOutput()->GetExtent(part);
      const Picture picture(studio.tracer->GetOutput());
      emptyPieces += picture.empty();
      for (int j = part[2]; j <= part[3]; ++j)
      {
        EXPECT_EQ(picture.bits(part[0], part[1] + 1, j), whole.bits(part[0], part[1] + 1, j))
          << "piece " << piece << ", row " << j;
        for (int i = part[0]; i <= part[1]; ++i)
        {
          pixels.emplace(i, j);
        }
      }
    }
    EXPECT_GT(emptyPieces, 0);
    EXPECT_EQ(pixels.size(), 10u * 7u);
  }
}

TEST(Extents, EmptyOnesGiveAnEmptyImage)
{
  const int extents[][6] = { { 5, 4, 0, 29, 0, 0 }, { 7, 3, 0, 29, 0, 0 }, { 0, 39, 10, 9, 0, 0 },
    { 0, 39, 12, 3, 0, 0 }, { 0, -1, 0, -1, 0, -1 }, { 0, 39, 0, 29, 0, -1 },
    { 30, 4, 20, 3, 0, 0 } };
  for (int samples : { 1, 2 })
  {
    for (const auto& extent : extents)
    {
      Studio studio(40, 30);
      setUp(studio);
      studio.tracer->SetSupersampling(samples);
      studio.tracer->GenerateIdsOn();
      EXPECT_TRUE(studio.tracer->UpdateExtent(extent));
      EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0);
      EXPECT_TRUE(Picture(studio.tracer->GetOutput()).empty());
      studio.tracer->UpdateWholeExtent();
      EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 40 * 30);
    }
  }
}

TEST(Extents, FollowTheImageSize)
{
  Studio studio(40, 30);
  setUp(studio);
  const int sizes[][2] = { { 40, 30 }, { 20, 50 }, { 60, 10 }, { 1, 1 }, { 40, 30 } };
  for (const auto& size : sizes)
  {
    studio.tracer->SetImageSize(size[0], size[1]);
    const Picture picture = render(studio.tracer);
    EXPECT_EQ(picture.width(), size[0]);
    EXPECT_EQ(picture.height(), size[1]);
    Studio fresh(size[0], size[1]);
    setUp(fresh);
    EXPECT_SAME_BITS(render(fresh.tracer), picture);
  }
}
