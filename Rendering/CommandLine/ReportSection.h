// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what a report says of one comparison: pictures side by side, and the changed cells
 */

#ifndef ReportSection_h
#define ReportSection_h

#include "ChangedCells.h"

#include <string>
#include <vector>

class vtkImageData;

namespace lambent::command
{

class VtkMessages;

struct Verdict
{
  bool passed = false;
  std::string message;
  vtkSmartPointer<vtkImageData> picture, baseline; ///< no baseline: there is none
  vtkSmartPointer<vtkImageData> difference;        ///< none: they cannot be compared
  std::vector<ChangedCell> cells;                  ///< if we drew the picture
  std::vector<std::string> inputs;                 ///< what the cells are of
};

/// As HTML. Of what has passed there is no more than a line.
std::string DescribeInHtml(const std::string& name, const Verdict& verdict, VtkMessages& messages);

} // namespace lambent::command

#endif
