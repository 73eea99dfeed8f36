// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the points of a polydata as the core's spheres
 */
#ifndef SpheresFromVTK_h
#define SpheresFromVTK_h

#include "SceneSettings.h"
#include "SpansFromVTK.h"
#include "Surface.h"

class vtkPolyData;

namespace lambent::adapters
{
/// Gives a surface, whose points must be set, the radii of its spheres. Throws std::runtime_error
/// with a message for the user if a radius is negative or not finite, or the array is missing or
/// does not have one number per point. The polydata and the spans must outlive the surface.
void setSpheres(
  const SphereSettings& settings, vtkPolyData* input, SpansFromVTK& spans, Surface& surface);
}

#endif
