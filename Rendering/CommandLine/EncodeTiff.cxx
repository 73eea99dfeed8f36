// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EncodeTiff.h"
#include "Messages.h"
#include "TiffErrors.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <utility>

namespace lambent::command
{
namespace
{

/// A file in memory. libtiff calls these functions, so they must not throw exceptions.
struct MemoryFile
{
  std::vector<unsigned char> bytes;
  std::size_t position = 0;

  static MemoryFile& Of(thandle_t handle) { return *static_cast<MemoryFile*>(handle); }

  static tmsize_t Read(thandle_t, void*, tmsize_t) { return 0; } // a new file has nothing to read

  static tmsize_t Write(thandle_t handle, void* data, tmsize_t size)
  {
    MemoryFile& file = Of(handle);
    const std::size_t end = file.position + static_cast<std::size_t>(size);
    try
    {
      file.bytes.resize(std::max(file.bytes.size(), end));
    }
    catch (const std::exception&)
    {
      return 0;
    }
    std::memcpy(file.bytes.data() + file.position, data, static_cast<std::size_t>(size));
    file.position = end;
    return size;
  }

  /// `whence` is SEEK_SET, SEEK_CUR or SEEK_END, in C's order 0, 1, 2.
  static toff_t Seek(thandle_t handle, toff_t offset, int whence)
  {
    MemoryFile& file = Of(handle);
    const toff_t starts[] = { 0, file.position, file.bytes.size() };
    return file.position = starts[whence] + offset; // may be behind the end
  }

  static int Close(thandle_t) { return 0; }

  static toff_t Size(thandle_t handle) { return Of(handle).bytes.size(); }
};

struct Layout
{
  std::uint32_t width, height;
  std::uint16_t channels, channelSize;
  std::size_t rowSize() const { return std::size_t{ 1 } * width * channels * channelSize; }
  std::uint32_t rowsPerStrip() const
  {
    return std::max(1u, static_cast<std::uint32_t>(65536 / rowSize()));
  }
};

Layout LayoutOf(vtkImageData* image)
{
  const int* const size = image->GetDimensions();
  vtkDataArray* const pixels = image->GetPointData()->GetScalars();
  const int channels = pixels->GetNumberOfComponents();
  if (channels != 1 && channels != 3 && channels != 4)
  {
    throw Failure("a TIFF file holds 1, 3 or 4 numbers per pixel, and this array has " +
      std::to_string(channels) + "; choose a name that ends in .vti");
  }
  const Layout layout = { static_cast<std::uint32_t>(size[0]), static_cast<std::uint32_t>(size[1]),
    static_cast<std::uint16_t>(channels), static_cast<std::uint16_t>(pixels->GetDataTypeSize()) };
  if (layout.rowSize() * layout.height >
    0xFFFFFFFF - (std::size_t{ 1 } << 26)) // leaves room for tags
  {
    throw Failure(
      "the picture is too large for this kind of file; choose a name that ends in .vti");
  }
  return layout;
}

void SetTags(TIFF* tiff, const Layout& layout)
{
  const bool isFloat = layout.channelSize == sizeof(float);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, layout.width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, layout.height);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8 * layout.channelSize);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, layout.channels);
  TIFFSetField(
    tiff, TIFFTAG_PHOTOMETRIC, layout.channels < 3 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, layout.rowsPerStrip());
  TIFFSetField(tiff, TIFFTAG_XRESOLUTION, 1.0); // pixels are square, without a unit of length
  TIFFSetField(tiff, TIFFTAG_YRESOLUTION, 1.0);
  TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
  if (layout.channels == 4)
  {
    const std::uint16_t fourth = isFloat ? EXTRASAMPLE_UNSPECIFIED : EXTRASAMPLE_UNASSALPHA;
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &fourth);
  }
  if (isFloat)
  {
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  }
}

bool WriteRows(TIFF* tiff, const Layout& layout, vtkImageData* image)
{
  auto* const bottom =
    static_cast<unsigned char*>(image->GetPointData()->GetScalars()->GetVoidPointer(0));
  for (std::uint32_t row = 0; row < layout.height; ++row)
  {
    if (TIFFWriteScanline(tiff, bottom + (layout.height - 1 - row) * layout.rowSize(), row, 0) != 1)
    {
      return false;
    }
  }
  return TIFFFlush(tiff) == 1; // the last strip and the tags
}

} // namespace

std::vector<unsigned char> EncodeTiff(vtkImageData* image)
{
  const Layout layout = LayoutOf(image);
  const TiffErrors errors;
  MemoryFile file;
  file.bytes.reserve(layout.rowSize() * layout.height + 65536); // for most pictures enough
  std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(
    TIFFClientOpen("", "w", &file, MemoryFile::Read, MemoryFile::Write, MemoryFile::Seek,
      MemoryFile::Close, MemoryFile::Size, nullptr, nullptr),
    TIFFClose);
  if (tiff)
  {
    SetTags(tiff.get(), layout);
  }
  if (!tiff || !WriteRows(tiff.get(), layout, image))
  {
    throw Failure(std::string("libtiff failed: ") + errors.First());
  }
  tiff.reset(); // before the bytes move away
  return std::move(file.bytes);
}

} // namespace lambent::command
