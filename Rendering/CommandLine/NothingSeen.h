// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief why a picture shows nothing
 *
 * A picture shows something as soon as a pixel is neither black nor of the background's
 * colour; that is found at once. Otherwise the scene is drawn again, first all white and
 * unlit, to see where a face is hit at all; then with one property of the lights changed
 * after the other, until something shows: that property is the matter. A property that has the
 * value already is passed over.
 */

#ifndef NothingSeen_h
#define NothingSeen_h

#include "Options.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace lambent::command
{

/// One line: the reason, and what to try; empty if the picture shows something.
std::string WhyNothingIsSeen(const Options& options,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, vtkImageData* picture);

} // namespace lambent::command

#endif
