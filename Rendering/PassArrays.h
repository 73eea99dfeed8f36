// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief arrays of the inputs that become arrays of the picture
 */
#ifndef PassArrays_h
#define PassArrays_h

#include "SceneSettings.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace lambent::adapters
{
/// Throws std::runtime_error if a name is that of an array the picture has itself or appears twice,
/// or if an association is neither points nor cells.
void checkNames(const std::vector<SceneSettings::PassArray>& arrays);

/// The input's array, or nullptr.
vtkDataArray* findArray(vtkPolyData* input, const SceneSettings::PassArray& array);

/// The names of the point or cell arrays that some inputs have, in quotation marks.
std::string listArrays(const std::vector<vtkPolyData*>& inputs, int association);

/// "point array "T"" or "cell array "T"".
std::string describe(const SceneSettings::PassArray& array);

/// Warnings about arrays that no input has. None if checkNames() would throw.
std::vector<std::string> describeMissing(const SceneSettings& settings);
}

#endif
