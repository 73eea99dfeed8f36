// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's matrix of an input as the core's transform
 */
#ifndef TransformFromVTK_h
#define TransformFromVTK_h

#include "Transform.h"

class vtkMatrix4x4;

namespace lambent::adapters
{
/// The transform of an input connection; nullptr gives the identity. Throws std::runtime_error with
/// a message for the user if the matrix is not finite, singular, or not affine.
Transform transformFromVTK(vtkMatrix4x4* matrix, int connection);
}

#endif
