// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief settings of single input connections, which stay with their connections
 *
 * A setting is identified by the number of its connection, and may be made before that connection
 * exists. When a connection is removed, so are its settings. The settings of later connections,
 * and of numbers that are not connected yet, move up. When all connections are replaced or removed
 * at once, settings stay with their numbers: it is the same scene with other meshes.
 */
#ifndef InputSettings_h
#define InputSettings_h

#include "InputColors.h"
#include "SceneSettings.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <functional>
#include <map>
#include <vector>

class vtkAlgorithm;

namespace lambent::adapters
{
/// The settings of a connection. Null means that one is not set.
struct InputSetting
{
  vtkSmartPointer<vtkProperty> Property;
  vtkSmartPointer<vtkMatrix4x4> Transform;
  vtkSmartPointer<vtkCompositeDataDisplayAttributes> BlockAttributes;
  InputColors Colors;
  vtkSmartPointer<vtkTexture> Texture;
  SphereSettings Spheres;
};

class InputSettings
{
public:
  /// The settings by the number of the connection; only those that are set.
  const std::map<int, InputSetting>& all() const { return this->Settings; }

  /// Those of a connection, which are the default ones if it has none.
  const InputSetting& of(int connection) const;
  InputSetting& change(int connection) { return this->Settings[connection]; }

  /// Runs `change`, which changes the connections of port 0, and makes the settings follow their
  /// connections. `removed` is the number of the connection that it removes, if known.
  void follow(vtkAlgorithm* filter, const std::function<void()>& change, int removed = -1);
  /// Like follow(). But if no connection is kept, or the first one is, settings stay with their
  /// numbers.
  void followReplacement(vtkAlgorithm* filter, const std::function<void()>& change);

private:
  void move(const std::vector<int>& numbers, int fewer);

  std::map<int, InputSetting> Settings;
};
}

#endif
