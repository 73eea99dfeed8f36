// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the numbers of a DataArray of a GIFTI file
 *
 * The text of an array is decimal numbers, or base64 of the numbers in memory, or
 * base64 of a zlib stream of them. Memory is allocated only for as many numbers as
 * the text can hold; packed ones up to 64 MiB and 256 times its size.
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

/// What the attributes of a DataArray say, as they are written.
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
/// text does not hold exactly that many.
std::vector<double> DecodeGiftiArray(const GiftiHeader& header, const std::string& text);

} // namespace lambent::command

#endif
