// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief files that name other files: pieces, blocks, time series
 *
 * VTK's readers of such files leave out what they cannot read. Here every part
 * goes the way of a file of its own, with the same checks, and a part that
 * cannot be read fails the whole. Names are relative to the file that has them.
 */

#ifndef Collection_h
#define Collection_h

#include "Formats.h"

#include <string>
#include <vector>

namespace lambent::command
{

/// The files that the <Piece> elements of a parallel XML file name. Throws Failure if there is
/// none.
std::vector<std::string> PiecesIn(const std::string& path, VtkMessages& messages);

/// Reads a file that another one names, by `read`, or if it is null as its name tells. Throws
/// Failure with the name of the part; also where files name each other in a circle.
vtkSmartPointer<vtkDataObject> ReadPart(const std::string& owner, const std::string& name,
  ReadFunction read, VtkMessages& messages, Progress& progress);

} // namespace lambent::command

#endif
