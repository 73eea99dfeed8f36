// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief make lookup tables and textures from the bytes of a fuzzer
 */
#ifndef FuzzColors_h
#define FuzzColors_h

#include "FuzzInput.h"

#include "vtkSmartPointer.h"

class vtkLookupTable;
class vtkScalarsToColors;
class vtkTexture;

/// A linear or logarithmic table with alpha, special colours and annotations. It may be empty.
vtkSmartPointer<vtkLookupTable> makeFuzzLookupTable(FuzzInput& input);

/// Such a table, or a vtkColorTransferFunction, which may be empty, too.
vtkSmartPointer<vtkScalarsToColors> makeFuzzTable(FuzzInput& input);

/// A texture with any settings, which may lack its image, or have an invalid one.
vtkSmartPointer<vtkTexture> makeFuzzTexture(FuzzInput& input);

#endif
