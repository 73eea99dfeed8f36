// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the peak memory of a contest
 */
#ifndef Memory_h
#define Memory_h

#include "Peers.h"

/// The bytes by which running a contest once increases resident memory at the peak, minus
/// imageBytes for the image. Meaningful once per process, before anything else runs.
double peakMemory(const Contest& contest, double imageBytes);

#endif
