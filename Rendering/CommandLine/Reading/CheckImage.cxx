// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckImage.h"
#include "FileBytes.h"
#include "Messages.h"

#include <cstdint>
#include <cstdlib>
#include <map>

namespace lambent::command
{
namespace
{

const char* const Remedy = "; convert it to .png";

/// Reads unsigned integers at offsets in a file, in its byte order.
class Numbers
{
public:
  Numbers(const FileBytes& bytes, bool isLittleEndian)
    : Bytes(bytes)
    , IsLittleEndian(isLittleEndian)
  {
  }

  std::uint32_t At(std::size_t place, std::size_t size) const
  {
    if (place > this->Bytes.size() || this->Bytes.size() - place < size)
    {
      throw Failure("it is incomplete; use a complete copy");
    }
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < size; ++k)
    {
      const std::size_t byte = this->IsLittleEndian ? size - 1 - k : k;
      number = number << 8 | static_cast<unsigned char>(this->Bytes.begin()[place + byte]);
    }
    return number;
  }

private:
  const FileBytes& Bytes;
  bool IsLittleEndian;
};

/// Tag numbers of TIFF 6.0.
enum TiffTag
{
  BitsPerSample = 258,
  Compression = 259,
  Photometric = 262,
  Orientation = 274,
  SamplesPerPixel = 277,
  PlanarConfiguration = 284,
  TileWidth = 322,
  ExtraSamples = 338,
  SampleFormat = 339
};

/// Returns the first value of each tag of the first picture; meaningless for tags that are not
/// whole numbers.
std::map<std::uint32_t, std::uint32_t> ReadTags(const FileBytes& bytes)
{
  const std::string start(bytes.view().substr(0, 2));
  const Numbers numbers(bytes, start == "II");
  if ((start != "II" && start != "MM") || numbers.At(2, 2) != 42)
  {
    throw Failure("it is not a classic TIFF file (up to 4 GiB)" + std::string(Remedy));
  }
  std::map<std::uint32_t, std::uint32_t> tags;
  const std::size_t first = numbers.At(4, 4);
  const std::uint32_t count = numbers.At(first, 2);
  for (std::uint32_t k = 0; k < count; ++k)
  {
    const std::size_t tag = first + 2 + 12 * std::size_t{ k };
    const std::uint32_t type = numbers.At(tag + 2, 2);
    const std::size_t size = type == 3 ? 2 : type == 4 ? 4 : 1;
    const bool isInside = numbers.At(tag + 4, 4) * std::uint64_t{ size } <= 4;
    tags[numbers.At(tag, 2)] = numbers.At(isInside ? tag + 8 : numbers.At(tag + 8, 4), size);
  }
  return tags;
}

} // namespace

void CheckTiff(const std::string& path)
{
  const FileBytes bytes(path);
  const std::map<std::uint32_t, std::uint32_t> tags = ReadTags(bytes);
  const auto valueOf = [&tags](TiffTag tag, std::uint32_t standard)
  { return tags.count(tag) > 0 ? tags.at(tag) : standard; };
  const auto refuse = [](bool isWrong, const std::string& what)
  {
    if (isWrong)
    {
      throw Failure("VTK's reader cannot read a TIFF " + what + Remedy);
    }
  };
  const std::uint32_t samples = valueOf(SamplesPerPixel, 1), bits = valueOf(BitsPerSample, 1),
                      format = valueOf(SampleFormat, 1), colors = valueOf(Photometric, 1),
                      compression = valueOf(Compression, 1), turned = valueOf(Orientation, 1);
  const bool isGrey = samples == 1 && colors == 1;
  const bool isPlain = samples == 1 && colors <= 3 && colors != 2; // grey, or a palette
  const bool isColor = (samples == 3 || samples == 4) && colors == 2;
  refuse(!isPlain && !isColor, "of this colour model (only grey, palettes, RGB and RGBA)");
  refuse(bits != 8 && !isGrey, "of colours with " + std::to_string(bits) + " bits per channel");
  refuse(
    !(bits == 8 && format == 1) && !(bits == 16 && format == 1) && !(bits == 32 && format == 3),
    "with grey of " + std::to_string(bits) + " bits in this sample format");
  refuse(samples == 4 && valueOf(ExtraSamples, 0) == 1, "with premultiplied alpha");
  refuse(compression != 1 && compression != 5 && compression != 8 && compression != 32773,
    "with this compression (only none, LZW, deflate and PackBits)");
  refuse(valueOf(PlanarConfiguration, 1) != 1, "with separate planes");
  refuse(tags.count(TileWidth) > 0, "in tiles");
  refuse(turned != 1 && turned != 4, "with an orientation that rotates or mirrors it");
}

void CheckBmp(const std::string& path)
{
  const FileBytes bytes(path);
  const Numbers numbers(bytes, true);
  if (bytes.view().substr(0, 2) != "BM" || numbers.At(14, 4) != 40)
  {
    throw Failure(
      "it is not a BMP file, or of a version that VTK does not read" + std::string(Remedy));
  }
  const std::uint32_t bits = numbers.At(28, 2);
  if ((bits != 8 && bits != 24) || numbers.At(30, 4) != 0)
  {
    throw Failure("VTK's reader cannot read a BMP " +
      (numbers.At(30, 4) != 0 ? "with compression"
                              : "of " + std::to_string(bits) + " bits per pixel (only 8 and 24)") +
      Remedy);
  }
  const std::int64_t width = static_cast<std::int32_t>(numbers.At(18, 4)),
                     height = std::llabs(static_cast<std::int32_t>(numbers.At(22, 4)));
  const std::int64_t row = (width * (bits / 8) + 3) / 4 * 4;
  if (width < 1 || height < 1 ||
    row * height > static_cast<std::int64_t>(bytes.size()) - numbers.At(10, 4))
  {
    throw Failure("it is incomplete; use a complete copy");
  }
}

} // namespace lambent::command
