// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the section $Elements of a file of Gmsh
 *
 * Version 2 has a line for each element, or in binary files blocks of elements of
 * one type; version 4.1 has blocks in both.
 */

#ifndef GmshElements_h
#define GmshElements_h

namespace lambent::command
{

class MshCursor;
class NumberedMesh;
class Progress;

/// Adds the elements of a section whose first line comes next. Throws Failure.
void TakeGmshElements(MshCursor& cursor, bool isVersion2, NumberedMesh& mesh, Progress& progress);

} // namespace lambent::command

#endif
