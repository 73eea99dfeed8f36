// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the difference of two arrays of pixels, as statistics and as pixels
 *
 * The rows are compared in parallel. Their results are added in row order, so that
 * floating-point sums are the same with any number of threads.
 */
#ifndef ImageDifference_h
#define ImageDifference_h

#include "vtkType.h"

class vtkDataArray;

struct ImageDifference
{
  double maximum = 0.0;
  double sumOfSquares = 0.0;
  vtkIdType changed = 0; ///< the number of changed pixels
  vtkIdType first = -1;  ///< index of the first changed pixel
  int extent[4] = { 0, -1, 0, -1 };
};

/**
 * Compare two arrays of the same type, number of components and length, in rows of `width`
 * pixels. `absolute`, an array like them, receives the absolute differences. Returns false if the
 * type is not numeric. Two values are the same if they are equal or both NaN. If only one is NaN,
 * the difference is infinity.
 */
bool subtractImages(vtkDataArray* picture, vtkDataArray* baseline, int width,
  ImageDifference& result, vtkDataArray* absolute);

/// Convert absolute differences, the largest of which is `maximum`, to a picture in which even the
/// smallest is visible; see vtkLambentImageComparison::SetHighlight().
void highlight(vtkDataArray* absolute, double maximum, vtkDataArray* bytes);

#endif
