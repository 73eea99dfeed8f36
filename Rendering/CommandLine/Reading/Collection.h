// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief files that name other files: pieces, blocks, time series
 *
 * VTK's readers of such files skip the parts that they cannot read. Here every part is read with
 * the same checks as a separate file, and reading fails if any part cannot be read. Names are
 * relative to the file that contains them.
 */

#ifndef Collection_h
#define Collection_h

#include "Formats.h"

#include <string>
#include <vector>

namespace lambent::command
{

/// The files named by the <Piece> elements of a parallel XML file. Throws Failure if there are
/// none.
std::vector<std::string> PiecesIn(const std::string& path, VtkMessages& messages);

/// Reads a file that another one names, with `read`, or by its extension if `read` is null. Throws
/// Failure with the name of the part, also if files name each other in a circle.
vtkSmartPointer<vtkDataObject> ReadPart(const std::string& owner, const std::string& name,
  ReadFunction read, VtkMessages& messages, Progress& progress);

} // namespace lambent::command

#endif
