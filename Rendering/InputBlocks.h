// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the meshes of an input connection: the input itself, or the blocks of a composite one
 *
 * 1. Visit the tree in the order of VTK's flat index: the root is 0, each block comes before its
 *    children, and empty places count.
 * 2. On the way down, remember the display attributes. As in vtkCompositePolyDataMapper2, those of
 * a block apply to all below it that do not have their own, and attributes are looked up by the
 *    data object.
 * 3. Each visible vtkPolyData with cells becomes an input of the scene. A visible leaf of another
 *    class is listed, unless it is empty.
 */
#ifndef InputBlocks_h
#define InputBlocks_h

#include "SceneSettings.h"

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;

namespace lambent::adapters
{
/// Adds the meshes of `data` to the scene. They have the settings of `input`, except for mesh and
/// block. Attributes may be nullptr. Throws std::runtime_error with a message for the user if a
/// block contains itself.
void addBlocks(const SceneSettings::Input& input, vtkDataObject* data,
  vtkCompositeDataDisplayAttributes* attributes, SceneSettings& scene);
}

#endif
