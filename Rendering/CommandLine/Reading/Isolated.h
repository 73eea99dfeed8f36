// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief runs a reader that may crash in a child process
 *
 * Most readers of VTK and assimp trust the file. On broken files they crash, hang, or allocate more
 * memory than there is. So they run in a child process, which returns the surface through a pipe.
 * Any failure of the child becomes a Failure here.
 *
 * 1. The parent calls fork(). The child detaches from the standard streams and applies its limits.
 * 2. The child reads the file and sends its progress, then its warnings, and the surface or an
 *    error.
 * 3. The parent receives these, waits for the child and checks its exit status.
 *
 * Limits: POSIX only. The child ends with the parent, because it cannot write into a closed pipe,
 * and is killed if the parent gives up.
 */

#ifndef Isolated_h
#define Isolated_h

#include "ChildLimits.h"

#include "vtkSmartPointer.h"

#include <functional>

class vtkPolyData;

namespace lambent::command
{

class Progress;
class VtkMessages;

/// Runs `read` in a child process and returns its result. Throws Failure if `read` does, or if the
/// child crashes or exceeds its limits.
vtkSmartPointer<vtkPolyData> ReadIsolated(const std::function<vtkSmartPointer<vtkPolyData>()>& read,
  const ChildLimits& limits, VtkMessages& messages, Progress& progress);

} // namespace lambent::command

#endif
