// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether a PNG file is whole
 *
 * vtkPNGReader ends the process over a file that is cut short, or in which a byte has
 * changed. Both show in the chunks that a PNG is made of: each has a length and a
 * check sum, and the last is IEND (ISO/IEC 15948, 5).
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
