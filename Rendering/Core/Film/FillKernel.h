// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief fills memory that will not be read soon, past the caches
 *
 * A pass of a large image does not fit into the caches. Ordinary stores would first load each cache
 * line from memory, and displace others.
 */
#ifndef lambent_FillKernel_h
#define lambent_FillKernel_h

#include <cstddef>

namespace lambent
{
/// Stores NaN, always the same one. Call finishFilling() before other threads may read the memory.
void fillWithNaN(float* to, std::size_t count);
void fillWithNaN(double* to, std::size_t count);
void finishFilling();
}

#endif
