// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the message about a cell that uses a point that does not exist
 */
#ifndef MissingPoint_h
#define MissingPoint_h

#include "vtkType.h"

#include <string>

namespace lambent::adapters
{
/// The message goes after the name of the cell. Valid points are 0 to points - 1.
inline std::string describeMissingPoint(vtkIdType point, vtkIdType points)
{
  return "uses point " + std::to_string(point) + ", but there are " +
    (points > 0 ? std::to_string(points) + " points, 0 to " + std::to_string(points - 1)
                : "no points") +
    ". Correct the connectivity of its vtkCellArray, or add the missing points.";
}
}

#endif
