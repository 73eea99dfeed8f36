// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the cells shown by the changed pixels of a picture
 */

#ifndef ChangedCells_h
#define ChangedCells_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkIdTypeArray;
class vtkImageData;

namespace lambent::command
{

/// The cell and the input that each pixel of a rendered picture shows.
struct PixelIds
{
  vtkSmartPointer<vtkIdTypeArray> cells, inputs;
};

struct ChangedCell
{
  vtkIdType input, cell; ///< both are -1 for the background
  vtkIdType pixels;
  int x, y; ///< the first pixel
};

/// Sorted by input and cell. `difference` is the output of vtkLambentImageComparison.
std::vector<ChangedCell> FindChangedCells(vtkImageData* difference, const PixelIds& ids);

/// In words: "cells 3, 7-12 of 'a.vtp' and the background".
std::string Describe(
  const std::vector<ChangedCell>& cells, const std::vector<std::string>& inputNames);

} // namespace lambent::command

#endif
