// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief finds arrays of the inputs by name, and lists them in messages
 */

#ifndef InputArrays_h
#define InputArrays_h

#include "PassValue.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;
class vtkPolyData;

namespace lambent::command
{

/// The point or cell data of a mesh. `association` is not Any.
vtkDataSetAttributes* AttributesOf(vtkPolyData* mesh, PassValue::Association association);

/// The array of that name; null if there is none, or if it is not of numbers.
vtkDataArray* ArrayOf(
  vtkPolyData* mesh, PassValue::Association association, const std::string& name);

/// Whether any mesh has an array of numbers of that name.
bool HasArray(const std::vector<vtkSmartPointer<vtkPolyData>>& meshes,
  PassValue::Association association, const std::string& name);

/// Which arrays a message lists, and in which order.
struct ArrayList
{
  PassValue::Association association = PassValue::Association::Any; ///< Any: points before cells
  std::string nearest; ///< arrays whose names are most like this one come first; empty: by name
  bool withOwn = true; ///< also those that a pass cannot have, see IsOwnArray()
};

/// Lists the arrays of numbers: "point:temperature, cell:region" or "none".
std::string ListArrays(
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, const ArrayList& wanted);

/// The number of letters to insert, remove or replace to change one text into the other. Upper and
/// lower case count as the same letter.
std::size_t EditDistance(const std::string& a, const std::string& b);

} // namespace lambent::command

#endif
