// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief toByte() for many values, with the same bits in each lane
 */
#ifndef lambent_ByteKernel_h
#define lambent_ByteKernel_h

#include "ChannelSpan.h"

namespace lambent
{
/// The largest `count` of storeBytes(), and the number of values that each channel must hold.
constexpr int mostBytePixels = 32;

/// Writes three or four channels of `count` pixels as bytes.
void storeBytes(const ChannelSpan& channels, int channelCount, int count, unsigned char* pixels);
}

#endif
