// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorsOfInputs.h"

#include "ColorsFromVTK.h"
#include "InputName.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace lambent::adapters
{
namespace
{
/// Blocks of one connection.
class BlockColors
{
public:
  explicit BlockColors(const SceneSettings::Input& first)
    : First(first)
  {
  }

  void add(const SceneSettings::Input& block, InputColors& colors)
  {
    vtkDataArray* const array = findColorArray(block.mesh, colors).array;
    if (!array)
    {
      colors.scalarVisibility = false;
      return;
    }
    this->Blocks.push_back(&colors);
    const bool isMapped = array->GetDataType() != VTK_UNSIGNED_CHAR && !array->GetLookupTable();
    if (isMapped && colors.component < array->GetNumberOfComponents())
    {
      double range[2];
      array->GetFiniteRange(range, std::max(-1, colors.component));
      this->Low = std::min(this->Low, range[0]);
      this->High = std::max(this->High, range[1]);
    }
  }

  void finish() const
  {
    const InputColors& wanted = this->First.colors;
    if (this->Blocks.empty() && !wanted.arrayName.empty())
    {
      const bool isOfCells = wanted.association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
      throw std::runtime_error(nameOfInput(this->First.connection, -1, "") +
        ": the colours come from the " + (isOfCells ? "cell" : "point") + " array \"" +
        wanted.arrayName +
        "\", which none of its blocks has as numbers. Call SetInputColorArray() with another name, "
        "or SetInputScalarVisibility() with false.");
    }
    if (wanted.hasScalarRange || wanted.lookupTable || this->Low > this->High)
    {
      return;
    }
    for (InputColors* colors : this->Blocks)
    {
      colors->hasScalarRange = true;
      colors->scalarRange[0] = this->Low;
      colors->scalarRange[1] = this->High;
    }
  }

private:
  const SceneSettings::Input& First;
  std::vector<InputColors*> Blocks; ///< that have the array
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();
};
}

std::vector<InputColors> colorsOfInputs(const std::vector<SceneSettings::Input>& inputs)
{
  std::vector<InputColors> result;
  for (const SceneSettings::Input& input : inputs)
  {
    result.push_back(input.colors);
    result.back().scalarVisibility = input.colors.scalarVisibility && !input.color;
  }
  for (std::size_t k = 0; k < inputs.size();)
  {
    std::size_t end = k + 1;
    if (inputs[k].block >= 0 && inputs[k].colors.scalarVisibility)
    {
      BlockColors blocks(inputs[k]);
      for (end = k; end < inputs.size() && inputs[end].connection == inputs[k].connection; ++end)
      {
        blocks.add(inputs[end], result[end]);
      }
      blocks.finish();
    }
    k = end;
  }
  return result;
}
}
