// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the settings of colours of all inputs, where blocks of one composite input share some
 *
 * Blocks share one range: without a table and a range, that of the array's finite numbers in all
 * blocks. A block without the array, or with a colour of its own, has no colours of the array.
 */
#ifndef ColorsOfInputs_h
#define ColorsOfInputs_h

#include "SceneSettings.h"

#include <vector>

namespace lambent::adapters
{
/// The settings of each input. Throws std::runtime_error with a message for the user if no block of
/// an input has the array that is named.
std::vector<InputColors> colorsOfInputs(const std::vector<SceneSettings::Input>& inputs);
}

#endif
