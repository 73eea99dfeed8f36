// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief no file that the command reads is written over by what it writes
 */

#ifndef ProtectFiles_h
#define ProtectFiles_h

#include "Options.h"

namespace lambent::command
{

/**
 * Throws Failure if an output (-o, --difference, --report) is also an input, the picture, the
 * baseline or another output, under whatever name; or if a picture would be compared with
 * itself, which always passes. Known before anything is drawn.
 */
void ProtectFiles(const Options& options);

} // namespace lambent::command

#endif
