// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief checks that a file can be opened and read
 */

#ifndef CheckFile_h
#define CheckFile_h

#include <string>

namespace lambent::command
{

/// Throws Failure unless the path is a readable regular file. It must not be empty unless
/// `mayBeEmpty` is true.
void CheckFile(const std::string& path, bool mayBeEmpty = false);

} // namespace lambent::command

#endif
