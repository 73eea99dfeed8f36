// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief refuses BMP files that vtkBMPReader would read wrongly
 *
 * The reader ignores compression and missing rows.
 */

#ifndef CheckBmp_h
#define CheckBmp_h

#include <string>

namespace lambent::command
{

/// Throws Failure unless the file has 8 or 24 bits per pixel, no compression and all its rows.
void CheckBmp(const std::string& path);

} // namespace lambent::command

#endif
