// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's ghost arrays as the core's flags
 */
#ifndef GhostsFromVTK_h
#define GhostsFromVTK_h

#include "DrawnTriangles.h"

class vtkPolyData;

namespace lambent::adapters
{
/// The flags of the points, and of the polygons and strips. The polydata must outlive them. Throws
/// std::runtime_error with a message for the user if an array has the wrong type or length.
GhostFlags ghostsFromVTK(vtkPolyData* polyData);
}

#endif
