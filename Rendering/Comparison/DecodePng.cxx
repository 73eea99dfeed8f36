// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DecodePng.h"

#include <stdexcept>

#if VTK_MODULE_ENABLE_VTK_png
#include "vtk_png.h"

#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <vector>

namespace
{
using namespace std::string_view_literals;

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n"sv;

constexpr std::array<std::uint32_t, 256> makeTable()
{
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n)
  {
    table[n] = n;
    for (int bit = 0; bit < 8; ++bit)
    {
      table[n] = (table[n] & 1 ? 0xEDB88320u : 0u) ^ (table[n] >> 1);
    }
  }
  return table;
}

/// The CRC-32 checksum of ISO 3309.
std::uint32_t checkSum(std::string_view bytes)
{
  static constexpr auto table = makeTable();
  std::uint32_t sum = 0xFFFFFFFFu;
  for (const char byte : bytes)
  {
    sum = table[(sum ^ static_cast<unsigned char>(byte)) & 0xFF] ^ (sum >> 8);
  }
  return ~sum;
}

std::uint32_t bigEndian(std::string_view bytes)
{
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4))
  {
    value = value << 8 | static_cast<unsigned char>(byte);
  }
  return value;
}

/// Throws unless each chunk is complete: length, type, data, checksum.
void checkChunks(std::string_view bytes)
{
  for (std::string_view type; type != "IEND";)
  {
    if (bytes.size() < 12 || bigEndian(bytes) > bytes.size() - 12)
    {
      throw std::runtime_error("it is not a complete PNG file");
    }
    const std::size_t length = bigEndian(bytes);
    if (checkSum(bytes.substr(4, 4 + length)) != bigEndian(bytes.substr(8 + length)))
    {
      throw std::runtime_error("the file is damaged: a check sum is wrong");
    }
    type = bytes.substr(4, 4);
    bytes.remove_prefix(12 + length);
  }
}

/**
 * libpng with its input and its last error. libpng reports errors by longjmp(), which must not
 * skip destructors. So each function that calls it has a setjmp() and no local objects, and
 * returns false after an error.
 */
struct Decoder
{
  explicit Decoder(std::string_view source)
    : bytes(source)
    , png(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, onError, onWarning))
    , info(png ? png_create_info_struct(png) : nullptr)
  {
    if (!info)
    {
      png_destroy_read_struct(&png, nullptr, nullptr);
      throw std::runtime_error("there is not enough memory to read the file");
    }
  }
  ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  [[noreturn]] static void onError(png_structp png, png_const_charp text)
  {
    auto* self = static_cast<Decoder*>(png_get_error_ptr(png));
    std::strncpy(self->error, text, sizeof self->error - 1);
    png_longjmp(png, 1);
  }
  static void onWarning(png_structp, png_const_charp) {}

  static void onRead(png_structp png, png_bytep target, std::size_t size)
  {
    auto* self = static_cast<Decoder*>(png_get_io_ptr(png));
    if (size > self->bytes.size())
    {
      png_error(png, "it ends too early");
    }
    std::memcpy(target, self->bytes.data(), size);
    self->bytes.remove_prefix(size);
  }

  std::string_view bytes;
  char error[256] = {};
  png_structp png;
  png_infop info;
};

bool readHeader(Decoder& decoder)
{
  if (setjmp(png_jmpbuf(decoder.png)))
  {
    return false;
  }
  png_set_read_fn(decoder.png, &decoder, Decoder::onRead);
  png_read_info(decoder.png, decoder.info);
  return true;
}

/// Sets the pixel format that DecodePng.h describes.
bool setTransformations(Decoder& decoder)
{
  if (setjmp(png_jmpbuf(decoder.png)))
  {
    return false;
  }
  png_set_expand(decoder.png);
  const std::uint16_t one = 1;
  if (*reinterpret_cast<const unsigned char*>(&one) == 1)
  {
    png_set_swap(decoder.png);
  }
  png_set_interlace_handling(decoder.png);
  png_read_update_info(decoder.png, decoder.info);
  return true;
}

bool readPixels(Decoder& decoder, png_bytepp rows)
{
  if (setjmp(png_jmpbuf(decoder.png)))
  {
    return false;
  }
  png_read_image(decoder.png, rows);
  png_read_end(decoder.png, decoder.info);
  return true;
}

void require(bool isRead, const Decoder& decoder)
{
  if (!isRead)
  {
    throw std::runtime_error("the file is damaged: " + std::string(decoder.error));
  }
}

/// Deflate expands a byte to at most 1032. Rejects larger images, which cannot be complete, before
/// memory is allocated.
void checkSize(const Decoder& decoder, std::size_t fileSize)
{
  const std::size_t height = png_get_image_height(decoder.png, decoder.info);
  if (png_get_rowbytes(decoder.png, decoder.info) > 1100 * fileSize / height)
  {
    throw std::runtime_error("the file is damaged: it is too short for its " +
      std::to_string(png_get_image_width(decoder.png, decoder.info)) + " x " +
      std::to_string(height) + " pixels");
  }
}
}

bool canDecodePng()
{
  return true;
}

PngPicture decodePng(std::string_view bytes)
{
  if (bytes.substr(0, signature.size()) != signature)
  {
    throw std::runtime_error("it is not a PNG file");
  }
  checkChunks(bytes.substr(signature.size()));

  Decoder decoder(bytes);
  require(readHeader(decoder), decoder);
  checkSize(decoder, bytes.size());
  require(setTransformations(decoder), decoder);
  PngPicture picture;
  picture.width = static_cast<int>(png_get_image_width(decoder.png, decoder.info));
  picture.height = static_cast<int>(png_get_image_height(decoder.png, decoder.info));
  picture.components = png_get_channels(decoder.png, decoder.info);
  picture.bytesPerValue = png_get_bit_depth(decoder.png, decoder.info) == 16 ? 2 : 1;

  const std::size_t rowSize = png_get_rowbytes(decoder.png, decoder.info);
  picture.pixels.reset(new unsigned char[rowSize * static_cast<std::size_t>(picture.height)]);
  std::vector<png_bytep> rows;
  for (int j = picture.height - 1; j >= 0; --j)
  {
    rows.push_back(picture.pixels.get() + rowSize * static_cast<std::size_t>(j));
  }
  require(readPixels(decoder, rows.data()), decoder);

  png_textp texts = nullptr;
  const int count = png_get_text(decoder.png, decoder.info, &texts, nullptr);
  for (int k = 0; k < count; ++k)
  {
    picture.texts[texts[k].key] = texts[k].text ? texts[k].text : "";
  }
  return picture;
}

#else

bool canDecodePng()
{
  return false;
}

PngPicture decodePng(std::string_view)
{
  throw std::runtime_error("this Lambent was built without VTK::png; build it with that module");
}

#endif
