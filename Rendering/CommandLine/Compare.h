// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief compare a picture with its baseline, and tell
 */

#ifndef Compare_h
#define Compare_h

#include "ChangedCells.h"
#include "Options.h"

class vtkImageData;

namespace lambent::command
{

class VtkMessages;

/**
 * Compares as the options say, writes what they ask for and says in one line what
 * was found; on standard output, or on standard error if the picture goes there. If
 * the picture was drawn (there are ids), another line names the cells that differ.
 * True if it passed.
 *
 * With LAMBENT_UPDATE_BASELINES=1 in the environment the picture becomes the baseline
 * instead of failing. When CTest runs the command, files that differ are also named in the
 * tags that CTest takes to CDash.
 */
bool Compare(
  vtkImageData* picture, const PixelIds& ids, const Options& options, VtkMessages& messages);

} // namespace lambent::command

#endif
