// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief decodes a DataArray of a GIFTI file
 *
 * The text of an array holds decimal numbers, base64 of the binary numbers, or base64 of a zlib
 * stream of them. Memory is allocated only for as many numbers as the text can hold; for compressed
 * arrays, up to 64 MiB plus 256 times the compressed size.
 *
 * Reference: J. Harwell and others, "GIFTI Surface Data Format", version 1.0, 2011.
 */

#ifndef GiftiArray_h
#define GiftiArray_h

#include <cstddef>
#include <string>
#include <vector>

namespace lambent::command
{

/// The attributes of a DataArray as they are written.
struct GiftiHeader
{
  std::string intent;
  std::string dataType;
  std::string encoding;
  std::string endian;
  std::string order;
  std::string dimensionality;
  std::string rows;    ///< Dim0
  std::string columns; ///< Dim1
};

/// The values of an array of any number of rows and 3 columns, row by row. Throws Failure if the
/// text holds more or fewer values.
std::vector<double> DecodeGiftiArray(const GiftiHeader& header, const std::string& text);

} // namespace lambent::command

#endif
