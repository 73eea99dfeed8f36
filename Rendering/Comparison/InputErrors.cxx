// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputErrors.h"

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"

#include <set>

namespace
{
std::string findError(vtkAlgorithm* algorithm, int port, std::set<vtkAlgorithm*>& seen)
{
  for (int k = 0; k < algorithm->GetNumberOfInputConnections(port); ++k)
  {
    vtkAlgorithm* const producer = algorithm->GetInputAlgorithm(port, k);
    if (!producer || !seen.insert(producer).second)
    {
      continue;
    }
    if (producer->GetErrorCode() != vtkErrorCode::NoError)
    {
      return producer->GetClassName() + std::string(" reports: ") +
        vtkErrorCode::GetStringFromErrorCode(producer->GetErrorCode());
    }
    for (int p = 0; p < producer->GetNumberOfInputPorts(); ++p)
    {
      const std::string error = findError(producer, p, seen);
      if (!error.empty())
      {
        return error;
      }
    }
  }
  return "";
}
}

std::string findInputError(vtkAlgorithm* comparison)
{
  const char* const roles[] = { "The picture", "The baseline" };
  std::set<vtkAlgorithm*> seen;
  for (int port = 0; port < 2; ++port)
  {
    const std::string error = findError(comparison, port, seen);
    if (!error.empty())
    {
      return std::string(roles[port]) + " could not be produced: " + error;
    }
  }
  return "";
}
