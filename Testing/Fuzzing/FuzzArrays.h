// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief add arrays that a ray tracer uses to a mesh, by the bytes of a fuzzer
 */
#ifndef FuzzArrays_h
#define FuzzArrays_h

#include "FuzzInput.h"

class vtkPolyData;

/// Adds a point array "Heat" and a cell array "Part" of any type and the right length. May also add
/// active scalars, texture coordinates, ghost flags, and radii: the point array "Radius". Seldom
/// are these of the wrong type or length.
void addFuzzArrays(FuzzInput& input, vtkPolyData* mesh);

#endif
