// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether a filter should stop, in every version of VTK
 */
#ifndef Abort_h
#define Abort_h

#include "vtkAlgorithm.h"
#include "vtkVersion.h"

namespace lambent::adapters
{
inline bool isAborted(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}
}

#endif
