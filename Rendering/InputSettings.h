// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what is set for single input connections, and stays with them
 *
 * Settings are found by the number of a connection, and may be made before there is one
 * of that number. When a connection is removed, its settings go with it; those of others, and
 * of numbers that are not connected yet, move up. When all connections are replaced or removed
 * at once, settings stay with their numbers: the same scene, of other meshes.
 */
#ifndef InputSettings_h
#define InputSettings_h

#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <map>
#include <vector>

class vtkAlgorithm;

namespace lambent::adapters
{
struct InputSetting
{
  vtkSmartPointer<vtkProperty> Property; ///< none: that of all inputs
};

class InputSettings
{
public:
  /// By the number of the connection; only those that are set.
  const std::map<int, InputSetting>& all() const { return this->Settings; }

  vtkProperty* property(int connection) const;
  void setProperty(int connection, vtkProperty* property);

  /// Run `change`, which changes the connections of port 0, and follow them. `removed` is
  /// the connection that it removes, if that is known.
  void follow(vtkAlgorithm* filter, const std::function<void()>& change, int removed = -1);
  /// The same, unless no connection, or just the first, stays: settings then stay with their
  /// numbers.
  void followReplacement(vtkAlgorithm* filter, const std::function<void()>& change);

private:
  void move(const std::vector<int>& numbers, int fewer);

  std::map<int, InputSetting> Settings;
};
}

#endif
