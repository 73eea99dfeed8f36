// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what the filter puts into its output
 */
#ifndef OutputImage_h
#define OutputImage_h

#include "Render.h"

#include <vector>

class vtkImageData;
class vtkInformation;

namespace lambent::adapters
{
class InputSurfaces;

/// Give the output the extent that is asked for, and its "Color" scalars. size: of the
/// whole image. Throws std::bad_alloc for more than the machine has memory.
Image allocateImage(
  const int size[2], int scalarType, vtkInformation* outInfo, vtkImageData* output);

/// Add the point arrays "CellIds" and "InputIds" to the output, from the number of the
/// triangle that each pixel shows.
void addIds(
  const std::vector<std::uint32_t>& triangles, const InputSurfaces& surfaces, vtkImageData* output);
}

#endif
