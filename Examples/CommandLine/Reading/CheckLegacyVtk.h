// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief keep VTK's legacy reader from cells that would make it crash
 *
 * Up to version 4 of the format the cells are one list of numbers, "count, ids,
 * count, ids, ...", of a length that the line above it tells. vtkDataReader
 * takes the list for whole also where the file ends within it, and then goes
 * through counts that nobody has written. Here each such list is gone through
 * first.
 */

#ifndef CheckLegacyVtk_h
#define CheckLegacyVtk_h

#include <string>

namespace lambent::command
{

/// Throws Failure if a list of cells in the file is cut short or does not add up.
void CheckLegacyVtk(const std::string& path);

} // namespace lambent::command

#endif
