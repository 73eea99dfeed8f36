// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief decode a PNG file from memory, and report its defects
 *
 * vtkPNGReader terminates the process when libpng finds an error. Here errors are exceptions:
 *
 * 1. The chunks of the file are checked: each has a length and a checksum, and the last is
 *    IEND (ISO/IEC 15948, 5). This finds truncated files and changed bytes.
 * 2. libpng decodes the pixels, and its errors are caught. This finds invalid contents in valid
 *    chunks, written by a careless program.
 *
 * The pixels are those of vtkPNGReader: the bottom row comes first, palettes become colours,
 * values have at least a byte, and a transparent colour becomes an alpha channel.
 */
#ifndef DecodePng_h
#define DecodePng_h

#include <map>
#include <memory>
#include <string>
#include <string_view>

struct PngPicture
{
  int width = 0;
  int height = 0;
  int components = 0;                      ///< 1 to 4
  int bytesPerValue = 1;                   ///< 1, or 2 in native byte order
  std::unique_ptr<unsigned char[]> pixels; ///< width x height x components values
  std::map<std::string, std::string> texts;
};

/// Whether this library was built with libpng; without it, decoding throws.
bool canDecodePng();

/// Throws std::runtime_error with a message for the user if the bytes are not a complete PNG file.
PngPicture decodePng(std::string_view bytes);

#endif
