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
/// Writes three or four channels of `count` pixels, at most 32, as bytes. May read 32 values of
/// each channel.
/// The largest `count` of storeBytes(), and the number of values that each channel must hold.
constexpr int mostBytePixels = 32;

void storeBytes(const double* const* channels, int channelCount, int count, unsigned char* pixels);
}

#endif
