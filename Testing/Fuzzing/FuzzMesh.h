// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief any vtkPolyData at all, from the bytes of a fuzzer
 */
#ifndef FuzzMesh_h
#define FuzzMesh_h

#include "FuzzInput.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;
class vtkPolyData;

/// Points of any type, all four kinds of cells, of 32 and 64 bits, right or wrong; point and
/// cell data of any length and type.
vtkSmartPointer<vtkPolyData> makeFuzzMesh(FuzzInput& input);

/// Counts the errors of an algorithm. Whatever VTK prints is silenced from the first on.
class ErrorCount
{
public:
  explicit ErrorCount(vtkAlgorithm* algorithm);

  int errors = 0; ///< the algorithm's own and its executive's
};

#endif
