// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EncodeTiff.h"
#include "Messages.h"
#include "TemporaryFile.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTIFFReader.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

using namespace lambent::command;

namespace
{

/// An image of different values. Some differ only in their bits.
vtkSmartPointer<vtkImageData> MakeImage(int width, int height, int type, int channels)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, channels);
  vtkDataArray* const pixels = image->GetPointData()->GetScalars();
  for (vtkIdType k = 0; k < pixels->GetNumberOfValues(); ++k)
  {
    pixels->SetVariantValue(k, static_cast<int>(7 * k % 251));
  }
  if (type == VTK_FLOAT)
  {
    auto* const floats = static_cast<float*>(image->GetScalarPointer());
    floats[0] = std::numeric_limits<float>::quiet_NaN();
    floats[1] = -0.0f;
    floats[2] = std::numeric_limits<float>::denorm_min();
    floats[3] = std::numeric_limits<float>::infinity();
  }
  return image;
}

/// Writes an image and reads it by vtkTIFFReader, the right way up.
vtkSmartPointer<vtkImageData> WriteAndRead(vtkImageData* image)
{
  const std::vector<unsigned char> bytes = EncodeTiff(image);
  TemporaryFile file(testing::TempDir(), ".tif");
  file.Write(bytes.data(), bytes.size());
  vtkNew<vtkTIFFReader> reader;
  reader->SetFileName(file.GetPath().c_str());
  reader->SetOrientationType(4); // otherwise the top row would be at the bottom
  reader->Update();
  return reader->GetOutput();
}

void ExpectSameBits(vtkImageData* image, vtkImageData* other)
{
  vtkDataArray* const pixels = image->GetPointData()->GetScalars();
  vtkDataArray* const others = other->GetPointData()->GetScalars();
  ASSERT_EQ(pixels->GetDataType(), others->GetDataType());
  ASSERT_EQ(pixels->GetNumberOfComponents(), others->GetNumberOfComponents());
  ASSERT_EQ(pixels->GetNumberOfTuples(), others->GetNumberOfTuples());
  EXPECT_EQ(image->GetDimensions()[0], other->GetDimensions()[0]);
  EXPECT_EQ(image->GetSpacing()[0], other->GetSpacing()[0]);
  EXPECT_EQ(0,
    std::memcmp(pixels->GetVoidPointer(0), others->GetVoidPointer(0),
      static_cast<std::size_t>(pixels->GetNumberOfValues()) *
        static_cast<std::size_t>(pixels->GetDataTypeSize())));
}

} // namespace

TEST(EncodeTiff, VtkReadsTheSameBits)
{
  for (const auto& [width, height] : { std::pair(5, 3), std::pair(1, 4), std::pair(300, 333) })
  {
    for (const auto& [type, channels] :
      { std::pair(VTK_UNSIGNED_CHAR, 1), std::pair(VTK_UNSIGNED_CHAR, 3), std::pair(VTK_FLOAT, 1) })
    {
      const auto image = MakeImage(width, height, type, channels);
      ExpectSameBits(image, WriteAndRead(image));
    }
  }
}

// VTK's reader inverts alpha, but vtkTIFFWriter does not. ReadBackground() corrects that. If this
// test fails because the reader no longer does so, remove the correction.
TEST(EncodeTiff, VtkInvertsAlpha)
{
  const auto image = MakeImage(5, 3, VTK_UNSIGNED_CHAR, 4);
  const auto read = WriteAndRead(image);
  auto* const bytes = static_cast<unsigned char*>(read->GetScalarPointer());
  for (int k = 3; k < 5 * 3 * 4; k += 4)
  {
    bytes[k] = static_cast<unsigned char>(255 - bytes[k]);
  }
  ExpectSameBits(image, read);
}

TEST(EncodeTiff, RefusesOtherNumbersOfChannels)
{
  for (const int channels : { 2, 5 })
  {
    EXPECT_THROW(EncodeTiff(MakeImage(2, 2, VTK_FLOAT, channels)), Failure);
  }
}

// 4096 rows of 16 bytes fill one strip of 64 KiB.
TEST(EncodeTiff, PixelsFollowTheTags)
{
  for (const int height : { 1, 2, 4096, 4097 })
  {
    const auto image = MakeImage(1, height, VTK_FLOAT, 4);
    const std::size_t pixels = std::size_t{ 16 } * static_cast<std::size_t>(height);
    const std::vector<unsigned char> bytes = EncodeTiff(image);
    ASSERT_GT(bytes.size(), pixels);
    EXPECT_EQ((bytes.size() - pixels) % 4, 0u);
    EXPECT_EQ(0,
      std::memcmp(
        bytes.data() + bytes.size() - pixels, image->GetScalarPointer(0, height - 1, 0), 16));
    EXPECT_EQ(
      0, std::memcmp(bytes.data() + bytes.size() - 16, image->GetScalarPointer(0, 0, 0), 16));
  }
}
