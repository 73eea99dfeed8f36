// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "GiftiArray.h"
#include "Messages.h"
#include "TextNumber.h"

#include "vtkBase64Utilities.h"

#ifdef LAMBENT_HAS_ZLIB
#include "vtk_zlib.h"
#endif

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <new>

namespace lambent::command
{
namespace
{

constexpr const char* Whole = "; use a complete copy";
// As for gzipped files: more than any mesh needs, less than a decompression bomb.
constexpr std::size_t FreeSize = std::size_t{ 64 } << 20;
constexpr std::size_t MostRatio = 256;

using Bytes = std::vector<unsigned char>;

bool IsSpace(char c)
{
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// The number of values in the array. Bounded, so that sizes in bytes cannot overflow.
std::size_t CountValues(const GiftiHeader& header)
{
  constexpr std::int64_t most = 0x7fffffff;
  std::int64_t rows = -1;
  const char* const end = ReadInteger(header.rows.c_str(), rows);
  if (header.rows.empty() || *end != '\0' || rows < 0 || rows > most)
  {
    throw Failure("its Dim0 is '" + header.rows.substr(0, 20) + "'" + Whole);
  }
  if (header.dimensionality != "2" || header.columns != "3")
  {
    throw Failure("it does not have 3 columns (Dimensionality 2, Dim1 3)" + std::string(Whole));
  }
  return 3 * static_cast<std::size_t>(rows);
}

void RequireRoom(bool isEnough, std::size_t count)
{
  if (!isEnough)
  {
    throw Failure(
      "it has fewer than the " + std::to_string(count) + " numbers of its Dim0 and Dim1" + Whole);
  }
}

[[noreturn]] void ThrowMore()
{
  throw Failure("it has more numbers than its Dim0 and Dim1 declare" + std::string(Whole));
}

std::vector<double> DecodeText(const std::string& text, std::size_t count)
{
  RequireRoom(count <= text.size() / 2 + 1, count); // at least a digit and a space each
  const char* at = text.c_str();
  const char* const end = at + text.size();
  std::vector<double> values;
  values.reserve(count);
  while (true)
  {
    at = std::find_if_not(at, end, IsSpace);
    if (at == end)
    {
      break;
    }
    double value = 0;
    const char* const behind = ReadNumber(at, end, value);
    if (behind == at || (behind != end && !IsSpace(*behind)))
    {
      throw Failure("its value " + std::to_string(values.size()) + " is not a number" + Whole);
    }
    if (values.size() == count)
    {
      ThrowMore();
    }
    values.push_back(value);
    at = behind;
  }
  RequireRoom(values.size() == count, count);
  return values;
}

Bytes DecodeBase64(const std::string& text)
{
  Bytes packed;
  packed.reserve(text.size());
  std::copy_if(
    text.begin(), text.end(), std::back_inserter(packed), [](char c) { return !IsSpace(c); });
  const auto padding = std::find(packed.begin(), packed.end(), '=');
  const auto letters = static_cast<std::size_t>(padding - packed.begin());
  Bytes bytes(packed.size() / 4 * 3 + 3);
  const std::size_t size =
    vtkBase64Utilities::DecodeSafely(packed.data(), packed.size(), bytes.data(), bytes.size());
  // VTK stops at the first character that is not base64.
  if (packed.size() % 4 != 0 || packed.size() - letters > 2 || size != letters * 3 / 4)
  {
    throw Failure("its text is not base64" + std::string(Whole));
  }
  bytes.resize(size);
  return bytes;
}

#ifdef LAMBENT_HAS_ZLIB
/// Limited to 4 GiB, because zlib counts in 32 bits.
Bytes Inflate(Bytes& packed, std::size_t size)
{
  constexpr std::size_t most = 0xffffffff;
  if (packed.size() > most || size >= most)
  {
    throw Failure("it is larger than 4 GiB; save it with the encoding Base64Binary");
  }
  Bytes plain(size + 1); // one byte more, to detect excess data
  z_stream state = {};
  if (inflateInit2(&state, 15 + 32) != Z_OK) // 32: accept a zlib or gzip header
  {
    throw std::bad_alloc();
  }
  state.next_in = packed.data();
  state.avail_in = static_cast<uInt>(packed.size());
  state.next_out = plain.data();
  state.avail_out = static_cast<uInt>(plain.size());
  const int result = inflate(&state, Z_FINISH);
  const std::size_t used = plain.size() - state.avail_out;
  inflateEnd(&state);
  if (used > size)
  {
    ThrowMore();
  }
  if (result != Z_STREAM_END)
  {
    throw Failure("its compressed data is corrupt" + std::string(Whole));
  }
  plain.resize(used);
  return plain;
}
#else
Bytes Inflate(Bytes&, std::size_t)
{
  throw Failure(
    "this build of lambent was made without VTK::zlib, and it is compressed; save it with "
    "the encoding Base64Binary");
}
#endif

bool IsThisMachineLittle()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

template <typename Value>
std::vector<double> DecodeBytes(
  const GiftiHeader& header, const std::string& text, std::size_t count)
{
  const std::size_t size = count * sizeof(Value);
  Bytes bytes = DecodeBase64(text);
  if (header.encoding == "GZipBase64Binary")
  {
    if (size > FreeSize + MostRatio * bytes.size())
    {
      throw Failure("its Dim0 declares more than " + std::to_string(MostRatio) +
        " times the size of its compressed data, which no mesh needs" + Whole);
    }
    bytes = Inflate(bytes, size);
  }
  RequireRoom(bytes.size() >= size, count);
  if (bytes.size() > size)
  {
    ThrowMore();
  }
  const bool isLittle = header.endian == "LittleEndian";
  if (!isLittle && header.endian != "BigEndian")
  {
    throw Failure("its Endian is neither LittleEndian nor BigEndian" + std::string(Whole));
  }
  std::vector<double> values(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    unsigned char* const at = bytes.data() + k * sizeof(Value);
    if (isLittle != IsThisMachineLittle())
    {
      std::reverse(at, at + sizeof(Value));
    }
    Value value;
    std::memcpy(&value, at, sizeof(Value));
    values[k] = static_cast<double>(value);
  }
  return values;
}

using Decode = std::vector<double> (*)(const GiftiHeader&, const std::string&, std::size_t);

const struct
{
  const char* name;
  Decode decode;
} Types[] = {
  { "NIFTI_TYPE_FLOAT32", DecodeBytes<float> },
  { "NIFTI_TYPE_FLOAT64", DecodeBytes<double> },
  { "NIFTI_TYPE_INT8", DecodeBytes<std::int8_t> },
  { "NIFTI_TYPE_UINT8", DecodeBytes<std::uint8_t> },
  { "NIFTI_TYPE_INT16", DecodeBytes<std::int16_t> },
  { "NIFTI_TYPE_UINT16", DecodeBytes<std::uint16_t> },
  { "NIFTI_TYPE_INT32", DecodeBytes<std::int32_t> },
  { "NIFTI_TYPE_UINT32", DecodeBytes<std::uint32_t> },
  { "NIFTI_TYPE_INT64", DecodeBytes<std::int64_t> },
  { "NIFTI_TYPE_UINT64", DecodeBytes<std::uint64_t> },
};

Decode FindDecode(const std::string& name)
{
  for (const auto& [type, decode] : Types)
  {
    if (type == name)
    {
      return decode;
    }
  }
  throw Failure("its DataType is '" + name.substr(0, 40) + "', which is not known" + Whole);
}

std::vector<double> DecodeAny(const GiftiHeader& header, const std::string& text)
{
  const std::size_t count = CountValues(header);
  const Decode decode = FindDecode(header.dataType);
  if (header.encoding == "ASCII")
  {
    return DecodeText(text, count);
  }
  if (header.encoding == "Base64Binary" || header.encoding == "GZipBase64Binary")
  {
    return decode(header, text, count);
  }
  if (header.encoding == "ExternalFileBinary")
  {
    throw Failure("its numbers are in another file (ExternalFileBinary), which is not read; save "
                  "them in the file, as `wb_command -gifti-convert GZIP_BASE64_BINARY` does");
  }
  throw Failure(
    "its Encoding is '" + header.encoding.substr(0, 40) + "', which is not known" + Whole);
}

} // namespace

std::vector<double> DecodeGiftiArray(const GiftiHeader& header, const std::string& text)
{
  const std::vector<double> values = DecodeAny(header, text);
  if (header.order == "RowMajorOrder")
  {
    return values;
  }
  if (header.order != "ColumnMajorOrder")
  {
    throw Failure(
      "its ArrayIndexingOrder is neither RowMajorOrder nor ColumnMajorOrder" + std::string(Whole));
  }
  std::vector<double> turned(values.size());
  const std::size_t rows = values.size() / 3;
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    turned[3 * (k % rows) + k / rows] = values[k];
  }
  return turned;
}

} // namespace lambent::command
