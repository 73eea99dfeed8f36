// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief why a camera sees none of the faces
 *
 * By the geometry alone: what of the faces lies in front of the camera, what in its view,
 * and how large it is there.
 */

#ifndef EmptyView_h
#define EmptyView_h

#include "Options.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkCamera;
class vtkPolyData;

namespace lambent::command
{

/// The reason and what to try, for a picture in which no face is hit. Empty if there are no
/// faces, or only such with points that are not finite: that has been said before.
std::string WhyNothingIsHit(const Options& options,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, vtkCamera* camera);

} // namespace lambent::command

#endif
