// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief run a reader that may crash in a child process
 *
 * Most readers of VTK and assimp believe what a file says of itself. On broken
 * files they crash, hang, or ask for more memory than there is. So they run in
 * a child, which hands back the surface through a pipe; whatever happens to the
 * child is one Failure here.
 *
 * 1. fork(). The child lets go of the standard streams and takes its limits.
 * 2. The child reads, and sends its progress on the way; then its warnings,
 *    and the surface or the reason why there is none.
 * 3. The parent takes these, waits for the child, and judges its end.
 *
 * Limits: POSIX only. The child ends with the parent (it cannot write into a
 * closed pipe), and is killed if the parent gives up.
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

/// What `read` returns, computed in a child process; throws Failure as `read` does, and if the
/// child crashes or exceeds its limits.
vtkSmartPointer<vtkPolyData> ReadIsolated(const std::function<vtkSmartPointer<vtkPolyData>()>& read,
  const ChildLimits& limits, VtkMessages& messages, Progress& progress);

} // namespace lambent::command

#endif
