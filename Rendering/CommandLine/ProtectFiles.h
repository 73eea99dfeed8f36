// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief keeps the command from overwriting a file that it reads
 */

#ifndef ProtectFiles_h
#define ProtectFiles_h

#include "Options.h"

namespace lambent::command
{

/**
 * Throws Failure if an output (-o, --pass, --difference, --report) is also an input, the background
 * image, the picture, the baseline or another output, under any name, or if a picture would be
 * compared with itself, which always passes. Runs before anything is rendered.
 */
void ProtectFiles(const Options& options);

} // namespace lambent::command

#endif
