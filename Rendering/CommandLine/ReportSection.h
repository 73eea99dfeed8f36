// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a report's section about one comparison: pictures side by side, and the changed cells
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
  vtkSmartPointer<vtkImageData> picture, baseline; ///< baseline: null if there is none
  vtkSmartPointer<vtkImageData> difference;        ///< null if the two cannot be compared
  std::vector<ChangedCell> cells;                  ///< empty if the picture was read from a file
  std::vector<std::string> inputs;                 ///< the inputs that the cells belong to
};

/// The section in HTML. A comparison that passed gets only a heading and a line.
std::string DescribeInHtml(const std::string& name, const Verdict& verdict, VtkMessages& messages);

} // namespace lambent::command

#endif
