// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief toByte() for many values, lane by lane to the bit
 */
#ifndef lambent_ByteKernel_h
#define lambent_ByteKernel_h

namespace lambent
{
/// Write red, green and blue of `count` pixels, at most 32, as bytes; values may be read up to
/// the 32nd.
void storeBytes(
  const double* red, const double* green, const double* blue, int count, unsigned char* pixels);
}

#endif
