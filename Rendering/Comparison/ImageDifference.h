// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the difference of two arrays of pixels, in numbers and as pixels
 *
 * The rows are compared in parallel and what they yield is added up in their order,
 * so that sums of floating-point numbers come out the same with any number of threads.
 */
#ifndef ImageDifference_h
#define ImageDifference_h

#include "vtkType.h"

class vtkDataArray;

struct ImageDifference
{
  double maximum = 0.0;
  double sumOfSquares = 0.0;
  vtkIdType changed = 0; ///< pixels
  vtkIdType first = -1;  ///< index of the first changed pixel
  int extent[4] = { 0, -1, 0, -1 };
};

/**
 * Compare two arrays of the same type, number of components and length, in rows of
 * so many pixels. The third, of that kind as well, receives the absolute differences.
 * False if the type is not a number type. Two values are the same if they are equal or
 * both NaN; a NaN in one alone differs by infinity.
 */
bool subtractImages(vtkDataArray* picture, vtkDataArray* baseline, int width,
  ImageDifference& result, vtkDataArray* absolute);

/// From absolute differences, of which the largest is given, a picture in which the smallest
/// shows; see vtkLambentImageComparison::SetHighlight().
void highlight(vtkDataArray* absolute, double maximum, vtkDataArray* bytes);

#endif
