// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief compare a picture with its baseline and report the result
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
 * Compares as the options say, writes the requested files and prints the result in one line: on
 * standard output, or on standard error if the picture goes to standard output. If the picture was
 * rendered by this run (there are ids), a second line names the cells that differ. Returns true if
 * the comparison passed.
 *
 * With LAMBENT_UPDATE_BASELINES=1 in the environment, a picture that differs, or has no baseline
 * yet, becomes the baseline. When CTest runs the command, files that differ are also named in the
 * tags that CTest sends to CDash.
 */
bool Compare(
  vtkImageData* picture, const PixelIds& ids, const Options& options, VtkMessages& messages);

} // namespace lambent::command

#endif
