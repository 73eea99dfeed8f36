// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief compare a ray tracer's picture with that of brute force
 */
#ifndef FuzzReference_h
#define FuzzReference_h

#include "SceneSettings.h"

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkDataObject;
class vtkLambentRayTracer;

/// A ray tracer with the inputs and pass arrays that it was given, which it does not return.
struct FuzzSubject
{
  vtkLambentRayTracer* tracer;
  std::vector<vtkSmartPointer<vtkDataObject>> inputs;
  std::vector<lambent::adapters::SceneSettings::PassArray> passArrays;
};

/// Requires that the picture in this extent equals that of brute force.
void compareWithBruteForce(const FuzzSubject& subject, const std::array<int, 6>& extent);

#endif
