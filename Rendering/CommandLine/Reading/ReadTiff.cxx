// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadTiff.h"
#include "Messages.h"
#include "TiffErrors.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace lambent::command
{
namespace
{

int Tag(TIFF* tiff, std::uint32_t tag)
{
  std::uint16_t value = 0;
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

/// VTK's type of the samples, or VTK_VOID if libtiff has to convert them.
int TypeOf(TIFF* tiff)
{
  const int bits = Tag(tiff, TIFFTAG_BITSPERSAMPLE), format = Tag(tiff, TIFFTAG_SAMPLEFORMAT),
            colors = Tag(tiff, TIFFTAG_PHOTOMETRIC), rows = Tag(tiff, TIFFTAG_ORIENTATION),
            others = Tag(tiff, TIFFTAG_SAMPLESPERPIXEL) - (colors == PHOTOMETRIC_RGB ? 3 : 1);
  std::uint16_t count = 0, *extra = nullptr;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_EXTRASAMPLES, &count, &extra);
  const bool isInRows = !TIFFIsTiled(tiff) &&
    Tag(tiff, TIFFTAG_PLANARCONFIG) == PLANARCONFIG_CONTIG &&
    (rows == ORIENTATION_TOPLEFT || rows == ORIENTATION_BOTLEFT);
  const bool isPlain = (colors == PHOTOMETRIC_MINISBLACK || colors == PHOTOMETRIC_RGB) &&
    (others == 0 || others == 1) && !(count > 0 && extra[0] == EXTRASAMPLE_ASSOCALPHA);
  if (isInRows && isPlain && format == SAMPLEFORMAT_UINT)
  {
    return bits == 8 ? VTK_UNSIGNED_CHAR : bits == 16 ? VTK_UNSIGNED_SHORT : VTK_VOID;
  }
  if (isInRows && isPlain && format == SAMPLEFORMAT_IEEEFP)
  {
    return bits == 32 ? VTK_FLOAT : bits == 64 ? VTK_DOUBLE : VTK_VOID;
  }
  return VTK_VOID;
}

bool CopyRows(TIFF* tiff, vtkImageData* image)
{
  const int top = image->GetDimensions()[1] - 1;
  const bool isFromTop = Tag(tiff, TIFFTAG_ORIENTATION) == ORIENTATION_TOPLEFT;
  int row = 0;
  while (row <= top &&
    TIFFReadScanline(tiff, image->GetScalarPointer(0, isFromTop ? top - row : row, 0),
      static_cast<std::uint32_t>(row), 0) == 1)
  {
    ++row;
  }
  return row > top;
}

/// Lets libtiff convert the image to RGBA. It multiplies the colours by alpha, so this divides
/// them.
bool ConvertRows(TIFF* tiff, vtkImageData* image)
{
  const auto width = static_cast<std::uint32_t>(image->GetDimensions()[0]),
             height = static_cast<std::uint32_t>(image->GetDimensions()[1]);
  std::vector<std::uint32_t> pixels(std::size_t{ 1 } * width * height);
  const bool isRead =
    TIFFReadRGBAImageOriented(tiff, width, height, pixels.data(), ORIENTATION_BOTLEFT, 1) == 1;
  auto* channel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (const std::uint32_t pixel : pixels)
  {
    const std::uint32_t alpha = TIFFGetA(pixel);
    for (const std::uint32_t color : { TIFFGetR(pixel), TIFFGetG(pixel), TIFFGetB(pixel) })
    {
      *channel++ = static_cast<unsigned char>(
        alpha > 0 ? std::min<std::uint32_t>(255, (255 * color + alpha / 2) / alpha) : 0);
    }
    *channel++ = static_cast<unsigned char>(alpha);
  }
  return isRead;
}

vtkSmartPointer<vtkImageData> ReadImage(TIFF* tiff)
{
  std::uint32_t width = 0, height = 0;
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
  constexpr std::uint32_t most = std::numeric_limits<int>::max();
  if (width - 1 >= most || height - 1 >= most)
  {
    throw Failure("its size is invalid; correct it");
  }
  if (Tag(tiff, TIFFTAG_ORIENTATION) > ORIENTATION_BOTLEFT)
  {
    throw Failure("its orientation is rotated by 90 degrees; convert it to .png");
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(width), static_cast<int>(height), 1);
  const int type = TypeOf(tiff);
  const bool isCopied = type != VTK_VOID;
  image->AllocateScalars(
    isCopied ? type : VTK_UNSIGNED_CHAR, isCopied ? Tag(tiff, TIFFTAG_SAMPLESPERPIXEL) : 4);
  return (isCopied ? CopyRows : ConvertRows)(tiff, image) ? image : nullptr;
}

} // namespace

vtkSmartPointer<vtkImageData> ReadTiff(const std::string& path)
{
  const TiffErrors errors;
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(path.c_str(), "r"), TIFFClose);
  const auto image = tiff ? ReadImage(tiff.get()) : nullptr;
  return image ? image
               : throw Failure(std::string("libtiff cannot read it: ") + errors.First() +
                   "; check that it is complete, or convert it to .png");
}

} // namespace lambent::command
