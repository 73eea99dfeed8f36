// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief memory for the picture, in the filter's output
 */
#ifndef OutputImage_h
#define OutputImage_h

#include "Render.h"

class vtkImageData;
class vtkInformation;

/// Give the output the extent that is asked for, and its "Color" scalars. size: of the
/// whole image. Throws std::bad_alloc for more than the machine has memory.
lambent::Image allocateImage(
  const int size[2], int scalarType, vtkInformation* outInfo, vtkImageData* output);

#endif
