// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief three doubles of VTK as a vector
 */
#ifndef Vec3FromVTK_h
#define Vec3FromVTK_h

#include "Arithmetic.h"

namespace lambent::adapters
{
inline Vec3 vec3FromVTK(const double* v)
{
  return { v[0], v[1], v[2] };
}
}

#endif
