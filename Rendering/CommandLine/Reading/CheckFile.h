// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what keeps a file from being read
 */

#ifndef CheckFile_h
#define CheckFile_h

#include <string>

namespace lambent::command
{

/// Throws Failure unless there is a regular file that may be read, with something in it.
void CheckFile(const std::string& path, bool mayBeEmpty = false);

} // namespace lambent::command

#endif
