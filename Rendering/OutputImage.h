// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the arrays of the output
 */
#ifndef OutputImage_h
#define OutputImage_h

#include "Image.h"
#include "SceneSettings.h"

#include <vector>

class vtkImageData;
class vtkInformation;

namespace lambent::adapters
{
class InputSurfaces;
class WatchedParallel;

/// What the output holds.
struct OutputSettings
{
  int size[2] = { 0, 0 }; ///< of the whole image
  int scalarType = 0;     ///< of "Color"
  int samples = 1;
  bool alpha = false;
  bool ids = false;
  bool blockIds = false;             ///< also the ids of blocks
  std::vector<PassContent> contents; ///< of passTable
  std::vector<SceneSettings::PassArray> passArrays;
};

/// Gives the output the extent that is asked for, and its arrays but for the ids. Throws
/// std::bad_alloc if all of them need more than the machine's memory.
Image allocateImage(const OutputSettings& settings, const InputSurfaces& surfaces,
  vtkInformation* outInfo, vtkImageData* output);

/// Adds the point arrays "CellIds", "InputIds" and perhaps "BlockIds" to the output, given the
/// number of the primitive that each pixel shows. Throws Aborted if the filter should stop.
void addIds(const std::uint32_t* primitives, const InputSurfaces& surfaces, bool hasBlockIds,
  const WatchedParallel& parallel, vtkImageData* output);
}

#endif
