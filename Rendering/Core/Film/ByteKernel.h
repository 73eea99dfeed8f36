// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief toByte() for many values, with the same bits in each lane
 */
#ifndef lambent_ByteKernel_h
#define lambent_ByteKernel_h

namespace lambent
{
/// Writes red, green and blue of `count` pixels, at most 32, as bytes. May read 32 values of each
/// channel.
void storeBytes(
  const double* red, const double* green, const double* blue, int count, unsigned char* pixels);
}

#endif
