// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief from the bytes of a PNG file to its pixels, or to what is wrong with them
 *
 * vtkPNGReader ends the process where libpng finds an error. Here an error is an exception:
 *
 * 1. The chunks of the file are checked: each has a length and a check sum, and the last is
 *    IEND (ISO/IEC 15948, 5). This finds files that are cut short, and changed bytes.
 * 2. libpng decodes the pixels, with its errors caught. This finds what a careless program wrote
 *    into sound chunks.
 *
 * The pixels are those of vtkPNGReader: the bottom row first, palettes as colours, at least a
 * byte a value, a transparent colour as an alpha channel.
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
  int bytesPerValue = 1;                   ///< 1, or 2 in the byte order of the machine
  std::unique_ptr<unsigned char[]> pixels; ///< width x height x components values
  std::map<std::string, std::string> texts;
};

/// Whether this library was built with libpng; without it, decoding throws.
bool canDecodePng();

/// Throws std::runtime_error, with a sentence for the user, if the bytes are not a whole PNG file.
PngPicture decodePng(std::string_view bytes);

#endif
