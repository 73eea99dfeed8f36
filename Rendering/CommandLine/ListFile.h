// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief describes the contents of a file, for `--list`
 *
 * Prints the file's data as it is stored, before any surface is extracted: one line for the file
 * and one for its bounds, then a table of its data sets (blocks) and one of its arrays. Columns are
 * separated by at least two spaces, and the names, which may have spaces, are in the last one.
 */

#ifndef ListFile_h
#define ListFile_h

#include <string>

class vtkDataObject;

namespace lambent::command
{

class Progress;
class VtkMessages;

/// The text, which ends with a line end. Throws Failure if the file cannot be read.
std::string ListFile(const std::string& path, VtkMessages& messages, Progress& progress);

/// The same for data that has been read.
std::string ListData(const std::string& path, vtkDataObject* data);

} // namespace lambent::command

#endif
