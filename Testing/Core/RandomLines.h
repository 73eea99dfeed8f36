// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief seeded random scenes with lines and points of all lengths and widths
 */
#ifndef RandomLines_h
#define RandomLines_h

#include "RandomScenes.h"

/// The number of kinds of lines; the remainder of the seed selects one.
constexpr int randomLineKinds = 8;

/// The random scene of the seed with surfaces of lines; two of three have only these.
RandomScene makeRandomLines(unsigned int seed);

/// The same, with a picture small enough for brute force with many samples.
RandomScene makeFewRandomLines(unsigned int seed);

#endif
