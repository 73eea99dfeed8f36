// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EncodeTiff.h"
#include "Messages.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace lambent::command
{
namespace
{

enum Type : std::uint16_t
{
  Short = 3,
  Long = 4,
  Rational = 5
};

struct Tag
{
  std::uint16_t number;
  Type type;
  std::vector<std::uint32_t> values; ///< a rational is two values
};

template <typename Value>
void Append(std::vector<unsigned char>& bytes, Value value)
{
  const auto* const first = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof(value));
}

std::vector<unsigned char> ValuesOf(const Tag& tag)
{
  std::vector<unsigned char> bytes;
  for (const std::uint32_t value : tag.values)
  {
    tag.type == Short ? Append(bytes, static_cast<std::uint16_t>(value)) : Append(bytes, value);
  }
  return bytes;
}

/// The header, the tags in ascending order, and the values that do not fit into their tags.
std::vector<unsigned char> HeaderOf(const std::vector<Tag>& tags)
{
  const std::uint16_t one = 1;
  const bool isLittleEndian = *reinterpret_cast<const unsigned char*>(&one) == 1;
  std::vector<unsigned char> bytes(2, isLittleEndian ? 'I' : 'M');
  Append(bytes, std::uint16_t{ 42 });
  Append(bytes, std::uint32_t{ 8 }); // the offset of the tags
  Append(bytes, static_cast<std::uint16_t>(tags.size()));
  const std::size_t tagSize = 12;
  const std::size_t end = bytes.size() + tags.size() * tagSize + sizeof(std::uint32_t);
  std::vector<unsigned char> further;
  for (const Tag& tag : tags)
  {
    std::vector<unsigned char> values = ValuesOf(tag);
    Append(bytes, tag.number);
    Append(bytes, static_cast<std::uint16_t>(tag.type));
    Append(bytes, static_cast<std::uint32_t>(tag.values.size() / (tag.type == Rational ? 2 : 1)));
    if (values.size() > sizeof(std::uint32_t))
    {
      Append(bytes, static_cast<std::uint32_t>(end + further.size()));
      further.insert(further.end(), values.begin(), values.end());
    }
    else
    {
      values.resize(sizeof(std::uint32_t)); // shorts are left-justified
      bytes.insert(bytes.end(), values.begin(), values.end());
    }
  }
  Append(bytes, std::uint32_t{ 0 }); // there is no second image
  bytes.insert(bytes.end(), further.begin(), further.end());
  bytes.resize((bytes.size() + 3) / 4 * 4);
  return bytes;
}

struct Layout
{
  std::uint32_t width, height, channels, channelSize, rowsPerStrip;
  std::size_t rowSize() const { return std::size_t{ 1 } * width * channels * channelSize; }
};

std::vector<Tag> TagsOf(const Layout& layout, std::size_t firstPixel)
{
  const bool isFloat = layout.channelSize == sizeof(float);
  std::vector<std::uint32_t> offsets, sizes;
  for (std::uint32_t row = 0; row < layout.height; row += layout.rowsPerStrip)
  {
    const std::uint32_t rows = std::min(layout.rowsPerStrip, layout.height - row);
    offsets.push_back(static_cast<std::uint32_t>(firstPixel + row * layout.rowSize()));
    sizes.push_back(static_cast<std::uint32_t>(rows * layout.rowSize()));
  }
  const auto forEachChannel = [&layout](std::uint32_t value)
  { return std::vector<std::uint32_t>(layout.channels, value); };
  std::vector<Tag> tags = {
    { 256, Long, { layout.width } }, { 257, Long, { layout.height } },
    { 258, Short, forEachChannel(8 * layout.channelSize) }, { 259, Short, { 1 } }, // not compressed
    { 262, Short, { layout.channels < 3 ? 1u : 2u } }, // grey, 0 is black; or RGB
    { 273, Long, offsets }, { 274, Short, { 1 } },     // the top row comes first
    { 277, Short, { layout.channels } }, { 278, Long, { layout.rowsPerStrip } },
    { 279, Long, sizes }, { 282, Rational, { 1, 1 } },  // pixels are square
    { 283, Rational, { 1, 1 } }, { 284, Short, { 1 } }, // the channels of a pixel are adjacent
    { 296, Short, { 1 } },                              // no unit of length
  };
  if (layout.channels == 4)
  {
    tags.push_back({ 338, Short, { isFloat ? 0u : 2u } }); // unspecified, or straight alpha
  }
  if (isFloat)
  {
    tags.push_back({ 339, Short, forEachChannel(3) }); // IEEE
  }
  return tags;
}

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
  Layout layout;
  layout.width = static_cast<std::uint32_t>(size[0]);
  layout.height = static_cast<std::uint32_t>(size[1]);
  layout.channels = static_cast<std::uint32_t>(channels);
  layout.channelSize = static_cast<std::uint32_t>(pixels->GetDataTypeSize());
  layout.rowsPerStrip =
    static_cast<std::uint32_t>(std::max<std::size_t>(1, 65536 / layout.rowSize()));
  return layout;
}

} // namespace

std::vector<unsigned char> EncodeTiff(vtkImageData* image)
{
  const Layout layout = LayoutOf(image);
  const std::size_t pixels = layout.rowSize() * layout.height;
  if (pixels > 0xFFFFFFFF - (std::size_t{ 1 } << 26)) // leaves room for the tags
  {
    throw Failure(
      "the picture is too large for this kind of file; choose a name that ends in .vti");
  }
  // The size of the header does not depend on the offsets in it.
  const std::size_t firstPixel = HeaderOf(TagsOf(layout, 0)).size();
  std::vector<unsigned char> bytes = HeaderOf(TagsOf(layout, firstPixel));
  bytes.resize(firstPixel + pixels);
  const auto* const bottom =
    static_cast<const unsigned char*>(image->GetPointData()->GetScalars()->GetVoidPointer(0));
  for (std::uint32_t row = 0; row < layout.height; ++row)
  {
    std::memcpy(bytes.data() + firstPixel + row * layout.rowSize(),
      bottom + (layout.height - 1 - row) * layout.rowSize(), layout.rowSize());
  }
  return bytes;
}

} // namespace lambent::command
