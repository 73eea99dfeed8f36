// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief how much memory a contest takes at its peak
 */
#ifndef Memory_h
#define Memory_h

#include "Peers.h"

/// Bytes of resident memory that running it once adds at the peak, of which imageBytes are
/// the image's and not counted. Meaningful once a process, before anything else is run.
double peakMemory(const Contest& contest, double imageBytes);

#endif
