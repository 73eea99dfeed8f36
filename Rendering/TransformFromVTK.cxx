// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TransformFromVTK.h"

#include "InputName.h"

#include "vtkMatrix4x4.h"

#include <stdexcept>

namespace lambent::adapters
{
namespace
{
/// Returns what is wrong, or an empty string.
std::string describeDefect(vtkMatrix4x4* matrix, const Transform& transform)
{
  switch (defectOf(transform))
  {
    case TransformDefect::NotFinite:
      return "has an element that is not a finite number. Give it finite ones";
    case TransformDefect::Singular:
      return "is singular: it flattens the input, so that normals are not defined. Scale each axis "
             "by a factor other than 0";
    default:
      break;
  }
  const bool isAffine = matrix->GetElement(3, 0) == 0.0 && matrix->GetElement(3, 1) == 0.0 &&
    matrix->GetElement(3, 2) == 0.0 && matrix->GetElement(3, 3) == 1.0;
  return isAffine ? "" : "has a last row other than 0 0 0 1. Remove the projection from it";
}
}

Transform transformFromVTK(vtkMatrix4x4* matrix, int connection)
{
  Transform transform;
  if (!matrix)
  {
    return transform;
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      transform.rows[i][k] = matrix->GetElement(i, k);
    }
  }
  const std::string defect = describeDefect(matrix, transform);
  if (!defect.empty())
  {
    throw std::runtime_error(nameOfInput(connection, -1, "") + ": its transform " + defect +
      ", or call SetInputTransform(" + std::to_string(connection) + ", nullptr).");
  }
  return transform;
}
}
