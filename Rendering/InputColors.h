// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief how the colours of an input come from one of its arrays
 */
#ifndef InputColors_h
#define InputColors_h

#include "vtkDataObject.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"

#include <string>

namespace lambent::adapters
{
/// The settings of the same names in vtkLambentRayTracer.
struct InputColors
{
  bool scalarVisibility = false; ///< off: the rest is not used
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  std::string arrayName; ///< empty: the active scalars, of the points or else of the cells
  int component = 0;     ///< or -1, the magnitude
  vtkSmartPointer<vtkScalarsToColors> lookupTable; ///< null: that of the array, or VTK's default
  bool hasScalarRange = false;                     ///< otherwise, the table's or the array's
  double scalarRange[2] = { 0.0, 1.0 };
  bool interpolateScalarsBeforeMapping = false;
};
}

#endif
