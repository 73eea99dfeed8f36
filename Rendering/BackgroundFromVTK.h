// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkImageData as the core's background image
 */
#ifndef BackgroundFromVTK_h
#define BackgroundFromVTK_h

#include "Scene.h"
#include "SpansFromVTK.h"

class vtkImageData;

namespace lambent::adapters
{
/// nullptr gives none. The image and the spans must outlive the result. Throws std::runtime_error
/// with a message for the user.
BackgroundImage backgroundFromVTK(vtkImageData* image, SpansFromVTK& spans);

/// Whether there is an image that can be used and has no alpha.
bool isOpaque(vtkImageData* image);
}

#endif
