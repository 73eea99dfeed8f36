// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief checks the faces of a polyhedron
 */

#ifndef CheckFaces_h
#define CheckFaces_h

#include "vtkType.h"

class vtkUnstructuredGrid;

namespace lambent::command
{

/// Throws Failure unless this cell, a polyhedron, has faces and they name existing points.
void CheckFaces(vtkUnstructuredGrid* grid, vtkIdType cell);

} // namespace lambent::command

#endif
