// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the range and the lookup table of `--color-by`, which all inputs share
 */

#ifndef ColorScale_h
#define ColorScale_h

#include "ColorBy.h"
#include "Options.h"

#include <array>

class vtkLookupTable;

namespace lambent::command
{

/// The range of `--range`, or else of the finite numbers in the arrays of all inputs; 0 to 1 if
/// there are none. If they differ by less than a millionth, they count as one number, the first of
/// the range. Throws WrongUsage if `--log` cannot show it.
std::array<double, 2> RangeOf(const Options& options, const ColorBy& colorBy,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

/// The table of 256 colours over the range.
vtkSmartPointer<vtkLookupTable> MakeTable(
  const ColorOptions& options, const std::array<double, 2>& range);

} // namespace lambent::command

#endif
