// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EncodeTiff.h"
#include "Messages.h"
#include "ReadTiff.h"
#include "TemporaryFile.h"
#include "TiffErrors.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTIFFReader.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <memory>

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

std::unique_ptr<TemporaryFile> Write(vtkImageData* image)
{
  const std::vector<unsigned char> bytes = EncodeTiff(image);
  auto file = std::make_unique<TemporaryFile>(testing::TempDir(), ".tif");
  file->Write(bytes.data(), bytes.size());
  return file;
}

/// Writes an image and reads it by vtkTIFFReader, the right way up.
vtkSmartPointer<vtkImageData> WriteAndRead(vtkImageData* image)
{
  const auto file = Write(image);
  vtkNew<vtkTIFFReader> reader;
  reader->SetFileName(file->GetPath().c_str());
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

// Unlike ReadTiff(), vtkTIFFReader inverts alpha and misreads several floats.
TEST(EncodeTiff, OurReaderReadsTheSameBits)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT })
  {
    for (const int channels : { 1, 3, 4 })
    {
      const auto image = MakeImage(300, 333, type, channels);
      const auto file = Write(image);
      ExpectSameBits(image, ReadTiff(file->GetPath()));
    }
  }
}

TEST(EncodeTiff, RefusesOtherNumbersOfChannels)
{
  for (const int channels : { 2, 5 })
  {
    EXPECT_THROW(EncodeTiff(MakeImage(2, 2, VTK_FLOAT, channels)), Failure);
  }
}

TEST(EncodeTiff, RefusesImagesBeyond32BitOffsets)
{
  const auto image = MakeImage(1, 1, VTK_UNSIGNED_CHAR, 3);
  image->SetDimensions(40000, 40000, 1); // 4.8e9 bytes, if there were pixels
  try
  {
    EncodeTiff(image);
    FAIL();
  }
  catch (const Failure& failure)
  {
    EXPECT_STREQ("the picture is too large for this kind of file; choose a name that ends in .vti",
      failure.what());
  }
}

// 4096 rows of 16 bytes fill one strip of 64 KiB.
TEST(EncodeTiff, PixelsFollowTheHeader)
{
  for (const int height : { 1, 2, 4096, 4097 })
  {
    const auto image = MakeImage(1, height, VTK_FLOAT, 4);
    const std::vector<unsigned char> bytes = EncodeTiff(image);
    const std::size_t header = 8, last = header + 16 * (static_cast<std::size_t>(height) - 1);
    ASSERT_GT(bytes.size(), last + 16);
    EXPECT_EQ(0, std::memcmp(&bytes[header], image->GetScalarPointer(0, height - 1, 0), 16));
    EXPECT_EQ(0, std::memcmp(&bytes[last], image->GetScalarPointer(0, 0, 0), 16));
    EXPECT_EQ(bytes, EncodeTiff(image));
  }
}

// The handlers are global, and VTK's reader also sets them.
TEST(TiffErrors, HandlersAreRestored)
{
  const TIFFErrorHandler handler = [](const char*, const char*, va_list) {};
  const TIFFErrorHandler before = TIFFSetErrorHandler(handler);
  const TIFFErrorHandler warningsBefore = TIFFSetWarningHandler(handler);
  {
    const TiffErrors errors;
    EXPECT_STREQ("", errors.First());
    EXPECT_EQ(nullptr, TIFFOpen("no/such/file.tif", "r"));
    EXPECT_EQ(nullptr, TIFFOpen("another.tif", "r"));
    EXPECT_NE(nullptr, std::strstr(errors.First(), "no/such/file.tif")) << errors.First();
  }
  EXPECT_STREQ("", TiffErrors().First());
  EXPECT_EQ(handler, TIFFSetErrorHandler(before));
  EXPECT_EQ(handler, TIFFSetWarningHandler(warningsBefore));
}
