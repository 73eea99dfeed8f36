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

/// Warns if this, the last byte of a text, does not end a line: the last number in it may be cut.
void CheckLastByte(char last);

} // namespace lambent::command

#endif
