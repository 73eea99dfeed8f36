// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's arrays as the core's spans
 *
 * Tuples and numbers of float and double, and cells of 32 and 64 bits, are used in place. Other
 * number types and memory layouts are converted into memory that the SpansFromVTK owns. The arrays
 * and the SpansFromVTK must outlive the spans.
 */
#ifndef SpansFromVTK_h
#define SpansFromVTK_h

#include "AttributeSpan.h"
#include "Spans.h"

#include "vtkObjectBase.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkCellArray;
class vtkDataArray;

namespace lambent::adapters
{
class SpansFromVTK
{
public:
  /// Tuples of three components; no tuples for nullptr.
  TupleSpan tuples(vtkDataArray* array);
  /// Numbers of an array with one component; none for nullptr.
  ScalarSpan scalars(vtkDataArray* array);
  /// Values of any number type and number of components. Bits become bytes. Returns a null span for
  /// nullptr, and an empty span of the array's type if it has no tuples.
  AttributeSpan attribute(vtkDataArray* array, bool isPerCell);
  /// No cells for nullptr.
  CellSpan cells(vtkCellArray* array);

private:
  vtkDataArray* asReals(vtkDataArray* array);

  std::vector<vtkSmartPointer<vtkObjectBase>> Converted;
};
}

#endif
