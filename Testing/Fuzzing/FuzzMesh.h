// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief make arbitrary vtkPolyData from the bytes of a fuzzer
 */
#ifndef FuzzMesh_h
#define FuzzMesh_h

#include "FuzzInput.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkPolyData;

/// Points of any type; all four kinds of cells with 32-bit or 64-bit ids, valid or not; point and
/// cell data of any length and type.
vtkSmartPointer<vtkPolyData> makeFuzzMesh(FuzzInput& input);

/// An array of any numeric type.
vtkSmartPointer<vtkDataArray> makeFuzzTuples(FuzzInput& input, int count, int usualComponents);

/// Counts the errors of an algorithm. The first instance silences all output of VTK.
class ErrorCount
{
public:
  explicit ErrorCount(vtkAlgorithm* algorithm);

  int errors = 0; ///< those of the algorithm and of its executive
};

#endif
