// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureFromVTK.h"

#include "LookupTableFromVTK.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace lambent::adapters
{
namespace
{
/// The image after an update. Never nullptr.
vtkImageData* imageOf(vtkTexture* texture)
{
  if (texture->GetCubeMap())
  {
    throw std::runtime_error(
      "its vtkTexture is a cube map, which has six images. Call vtkTexture::CubeMapOff().");
  }
  if (texture->GetNumberOfInputConnections(0) == 0)
  {
    throw std::runtime_error("its vtkTexture has no image. Call vtkTexture::SetInputConnection() "
                             "or SetInputData().");
  }
  int port = 0;
  vtkAlgorithm* const producer = texture->GetInputAlgorithm(0, 0, port);
  auto* const executive = vtkStreamingDemandDrivenPipeline::SafeDownCast(producer->GetExecutive());
  if (executive && !executive->UpdateWholeExtent())
  {
    throw std::runtime_error(
      "the image of its vtkTexture cannot be updated. Correct the filter or reader that produces "
      "it.");
  }
  auto* const image = vtkImageData::SafeDownCast(producer->GetOutputDataObject(port));
  if (!image)
  {
    throw std::runtime_error(
      "the input of its vtkTexture is no vtkImageData. Call vtkTexture::SetInputConnection() with "
      "a filter or reader of images.");
  }
  return image;
}

vtkDataArray* pixelsOf(vtkImageData* image)
{
  vtkDataArray* const ofPoints = image->GetPointData()->GetScalars();
  vtkDataArray* const pixels = ofPoints ? ofPoints : image->GetCellData()->GetScalars();
  if (!pixels || pixels->GetNumberOfTuples() == 0 || pixels->GetNumberOfComponents() < 1)
  {
    throw std::runtime_error("the image of its vtkTexture has no pixels. Set its active scalars, "
                             "and check the filter or reader that produces it.");
  }
  return pixels;
}

/// Whether the pixels are colours, not numbers to be mapped.
bool areColors(vtkTexture* texture, vtkDataArray* pixels)
{
  const int type = pixels->GetDataType();
  return texture->GetColorMode() != VTK_COLOR_MODE_MAP_SCALARS &&
    (type == VTK_UNSIGNED_CHAR ||
      (texture->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS &&
        (type == VTK_UNSIGNED_SHORT || type == VTK_FLOAT) && pixels->GetNumberOfComponents() > 2));
}

TextureWrap wrapOf(vtkTexture* texture)
{
  switch (texture->GetWrap())
  {
    case vtkTexture::ClampToEdge:
      return TextureWrap::ClampToEdge;
    case vtkTexture::MirroredRepeat:
      return TextureWrap::MirroredRepeat;
    case vtkTexture::ClampToBorder:
      return TextureWrap::ClampToBorder;
    default:
      return TextureWrap::Repeat;
  }
}

/// The table to use: the texture's, or a new one over the range of the pixels.
vtkSmartPointer<vtkScalarsToColors> tableFor(vtkTexture* texture, vtkDataArray* pixels)
{
  if (texture->GetLookupTable())
  {
    return texture->GetLookupTable();
  }
  double range[2];
  pixels->GetFiniteRange(range, 0);
  const auto table = vtkSmartPointer<vtkLookupTable>::New();
  if (range[0] <= range[1]) // otherwise no number is finite
  {
    table->SetRange(range);
  }
  return table;
}

void checkTable(vtkScalarsToColors* table)
{
  const double* const range = table->GetRange();
  const bool isLogarithmic = table->UsingLogScale() != 0;
  auto* const function = vtkColorTransferFunction::SafeDownCast(table);
  if (function && function->GetSize() == 0)
  {
    throw std::runtime_error("the colour transfer function of its vtkTexture has no colours. Call "
                             "vtkColorTransferFunction::AddRGBPoint().");
  }
  if (!std::isfinite(range[0]) || !std::isfinite(range[1]) || range[0] > range[1] ||
    (isLogarithmic && !(range[0] > 0.0)))
  {
    std::ostringstream text;
    text << "the lookup table of its vtkTexture has the range " << range[0] << " to " << range[1]
         << "; both must be finite"
         << (isLogarithmic ? " and, on a logarithmic scale, greater than 0" : "")
         << ", and the first must not be greater. Call vtkLookupTable::SetRange().";
    throw std::runtime_error(text.str());
  }
}
}

TextureFromVTK::TextureFromVTK(vtkTexture* texture)
{
  vtkImageData* const image = imageOf(texture);
  vtkDataArray* const pixels = pixelsOf(image);
  this->setSize(image, pixels);
  this->setPixels(texture, pixels);
  this->setMatrix(texture);
  this->Result.wrap = wrapOf(texture);
  this->Result.isInterpolated = texture->GetInterpolate() != 0;
  this->Result.isSRGB = texture->GetUseSRGBColorSpace();
  const float* const border = texture->GetBorderColor();
  this->Result.border = { Vec3(border[0], border[1], border[2]), border[3] };
  this->Result.hasAlpha = this->Result.isAnyTransparent();
}

/// As in vtkOpenGLTexture, the image may lie in any coordinate plane, the pixels may be its cells,
/// and an image that is one pixel wide is turned.
void TextureFromVTK::setSize(vtkImageData* image, vtkDataArray* pixels)
{
  int size[3];
  image->GetDimensions(size);
  const vtkIdType tuples = pixels->GetNumberOfTuples();
  if (tuples == image->GetNumberOfCells())
  {
    std::for_each(size, size + 3, [](int& n) { n -= n > 1 ? 1 : 0; });
  }
  if (size[0] > 1 && size[1] > 1 && size[2] > 1)
  {
    throw std::runtime_error("the image of its vtkTexture has " + std::to_string(size[2]) +
      " slices; a texture has one. Call vtkExtractVOI.");
  }
  const vtkIdType expected = static_cast<vtkIdType>(size[0]) * size[1] * size[2];
  if (tuples != expected)
  {
    throw std::runtime_error("the image of its vtkTexture has " + std::to_string(expected) +
      " pixels, but its scalars have " + std::to_string(tuples) +
      " tuples. Set its extent to match them.");
  }
  this->Result.width = size[0] == 1 ? size[1] : size[0];
  this->Result.height = size[0] == 1 || size[1] == 1 ? size[2] : size[1];
}

void TextureFromVTK::setPixels(vtkTexture* texture, vtkDataArray* pixels)
{
  if (!areColors(texture, pixels))
  {
    this->map(texture, pixels);
    return;
  }
  if (pixels->GetNumberOfComponents() > 4)
  {
    throw std::runtime_error("the image of its vtkTexture has " +
      std::to_string(pixels->GetNumberOfComponents()) +
      " components; colours have 1 to 4: grey, grey and alpha, RGB or RGBA. Call "
      "vtkImageExtractComponents.");
  }
  this->Result.pixels = this->Spans.attribute(pixels, false);
}

void TextureFromVTK::map(vtkTexture* texture, vtkDataArray* pixels)
{
  const vtkSmartPointer<vtkScalarsToColors> table = tableFor(texture, pixels);
  checkTable(table);
  vtkLookupTable* const plain = vtkLookupTable::SafeDownCast(table);
  const bool isDirect = texture->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS;
  if (!plain || isDirect || table->GetIndexedLookup() || table->GetAlpha() < 1.0 ||
    pixels->GetNumberOfComponents() > 1)
  {
    table->Build();
    this->MappedByVTK = vtkSmartPointer<vtkUnsignedCharArray>::Take(
      table->MapScalars(pixels, texture->GetColorMode(), -1));
    this->Result.pixels = this->Spans.attribute(this->MappedByVTK, false);
    return;
  }
  const LookupTableFromVTK colors(plain, plain->GetRange());
  const AttributeSpan numbers = this->Spans.attribute(pixels, false);
  const auto count = static_cast<std::size_t>(pixels->GetNumberOfTuples());
  this->Mapped.resize(4 * count);
  for (std::size_t k = 0; k < count; ++k)
  {
    std::copy_n(colors.table().entry(numbers.at(k, 0)), 4, &this->Mapped[4 * k]);
  }
  this->Result.pixels = { this->Mapped.data(), AttributeType::UInt8, 4, false };
}

void TextureFromVTK::setMatrix(vtkTexture* texture)
{
  if (!texture->GetTransform())
  {
    return;
  }
  vtkMatrix4x4* const matrix = texture->GetTransform()->GetMatrix();
  bool isFinite = true;
  for (int row = 0; row < 2; ++row)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double element = matrix->GetElement(row, k == 2 ? 3 : k); // the third coordinate is 0
      this->Result.matrix[row][k] = element;
      isFinite = isFinite && std::isfinite(element);
    }
  }
  if (!isFinite || matrix->GetElement(3, 0) != 0.0 || matrix->GetElement(3, 1) != 0.0 ||
    matrix->GetElement(3, 3) != 1.0)
  {
    throw std::runtime_error(
      "the transform of its vtkTexture is not finite, or its last row is not 0 0 0 1. Call "
      "vtkTexture::SetTransform() with an affine one.");
  }
}
}
