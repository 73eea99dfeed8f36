// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief why a camera sees none of the faces
 *
 * The reason follows from the geometry: which faces lie in front of the camera, which lie in its
 * view, and how large they appear there.
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

/// The reason why no face is hit, and what to try. Empty if there are no faces, or if none has only
/// finite points: those cases have already caused warnings.
std::string WhyNothingIsHit(const Options& options,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, vtkCamera* camera);

} // namespace lambent::command

#endif
