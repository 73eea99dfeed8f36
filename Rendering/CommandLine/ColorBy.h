// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the array of `--color-by` in the inputs
 *
 * The option's text is NAME, NAME:COMPONENT or NAME:magnitude, with or without point: or cell:
 * before it. Names may have colons, too: an array of the whole name comes first.
 */

#ifndef ColorBy_h
#define ColorBy_h

#include "PassValue.h"

#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace lambent::command
{

/// The component that stands for the magnitude of a tuple, as in vtkLambentRayTracer.
constexpr int Magnitude = -1;

struct ColorBy
{
  PassValue::Association association = PassValue::Association::Any;
  std::string array;
  std::optional<int> component; ///< absent: all of a colour, or the magnitude
};

/// The array in one input.
struct ShownArray
{
  vtkDataArray* array;
  bool isOfCells;
  int component; ///< or Magnitude
  bool areColors;
};

/// Parses the text of `--color-by`. Throws WrongUsage if no input has such an array of numbers (the
/// message lists those that exist, the nearest name first), or if one lacks the component.
ColorBy FindColorBy(
  const std::string& text, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

/// The array in this input, of its points, or else of its cells; empty if it has none.
std::optional<ShownArray> ShownArrayOf(vtkPolyData* mesh, const ColorBy& colorBy);

/// Whether an array is of colours: 3 or 4 unsigned chars.
bool AreColors(vtkDataArray* array);

} // namespace lambent::command

#endif
