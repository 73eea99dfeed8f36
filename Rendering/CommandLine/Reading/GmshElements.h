// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the section $Elements of a Gmsh file
 *
 * In version 2, text files have a line for each element, and binary files have blocks of elements
 * of one type. In version 4.1 both have blocks.
 */

#ifndef GmshElements_h
#define GmshElements_h

namespace lambent::command
{

class MshCursor;
class NumberedMesh;
class Progress;

/// Adds the elements of the section that starts at the cursor, after its keyword. Throws Failure.
void TakeGmshElements(MshCursor& cursor, bool isVersion2, NumberedMesh& mesh, Progress& progress);

} // namespace lambent::command

#endif
