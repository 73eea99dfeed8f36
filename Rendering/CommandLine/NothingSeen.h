// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief why a picture shows nothing
 *
 * A picture shows something if any pixel is neither black nor of the background colour; this test
 * is fast. (With a background image, the scene is first rendered again without it.) Otherwise the
 * scene is rendered again:
 * 1. all white and unlit, to find where a face is hit;
 * 2. with one property of the lights or the surface changed after the other, until something shows.
 *    That property is the reason. A property that already has the new value is skipped.
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

/// The reason and what to try, in one line; empty if the picture shows something.
std::string WhyNothingIsSeen(const Options& options,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, vtkImageData* picture);

} // namespace lambent::command

#endif
