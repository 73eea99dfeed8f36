// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's properties as the core's appearances
 */
#ifndef AppearanceFromVTK_h
#define AppearanceFromVTK_h

#include "Surface.h"

#include <string>

class vtkProperty;

namespace lambent::adapters
{
/// nullptr gives the default appearance.
Appearance appearanceFromVTK(vtkProperty* property);

/// What is wrong with an appearance, and the remedy; the message goes after the name of the
/// property. Empty if nothing is wrong.
std::string describeDefect(const Appearance& appearance);
}

#endif
