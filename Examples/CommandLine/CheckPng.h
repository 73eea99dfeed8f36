// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether a PNG file is whole
 *
 * Whatever libpng finds wrong with a file ends the process in vtkPNGReader. So the file
 * is looked over first. That it is cut short, or that a byte has changed, shows in the
 * chunks that a PNG is made of: each has a length and a check sum, and the last is IEND
 * (ISO/IEC 15948, 5). What a careless program may have written into whole chunks shows
 * when libpng itself decodes them.
 */

#ifndef CheckPng_h
#define CheckPng_h

#include <string_view>

namespace lambent::command
{

/// Throws Failure if the bytes are not a whole PNG file.
void CheckPng(std::string_view bytes);

} // namespace lambent::command

#endif
