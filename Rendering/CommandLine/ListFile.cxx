// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ListFile.h"
#include "ColorBy.h"
#include "ReadSurface.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <vector>

namespace lambent::command
{
namespace
{

using Row = std::vector<std::string>;

struct Block
{
  std::string name; ///< its number, and its name if it has one
  vtkDataSet* data;
};

/// An array of that name in the points, or in the cells, of one or several blocks.
struct ListedArray
{
  std::string name, type;
  bool isOfCells;
  int components;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  std::size_t blocks = 0;
};

std::vector<Block> BlocksOf(vtkDataObject* data)
{
  std::vector<Block> blocks;
  auto* const composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    auto* const dataSet = vtkDataSet::SafeDownCast(data);
    return dataSet ? std::vector<Block>{ { "0", dataSet } } : blocks;
  }
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    const char* const name = iterator->HasCurrentMetaData()
      ? iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
      : nullptr;
    if (auto* const dataSet = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      blocks.push_back(
        { std::to_string(blocks.size()) + (name ? " " + std::string(name) : ""), dataSet });
    }
  }
  return blocks;
}

const char* KindOf(vtkDataSet* data)
{
  switch (data->GetDataObjectType())
  {
    case VTK_POLY_DATA:
      return "polygons";
    case VTK_UNSTRUCTURED_GRID:
      return "unstructured";
    case VTK_STRUCTURED_GRID:
      return "structured";
    case VTK_RECTILINEAR_GRID:
      return "rectilinear";
    case VTK_IMAGE_DATA:
    case VTK_STRUCTURED_POINTS:
    case VTK_UNIFORM_GRID:
      return "image";
    default:
      return "other";
  }
}

/// The type in one word, such as float32.
std::string TypeOf(vtkAbstractArray* array)
{
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers || array->GetDataType() == VTK_BIT)
  {
    return numbers ? "bit" : "text";
  }
  const bool isFloat = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  const bool isSigned = numbers->GetDataTypeMin() < 0;
  return (isFloat       ? "float"
             : isSigned ? "int"
                        : "uint") +
    std::to_string(8 * array->GetDataTypeSize());
}

void Merge(std::vector<ListedArray>& list, vtkAbstractArray* array, bool isOfCells)
{
  const std::string name = array->GetName() && *array->GetName() ? array->GetName() : "-";
  const std::string type = TypeOf(array);
  const int components = array->GetNumberOfComponents();
  auto at = std::find_if(list.begin(), list.end(),
    [&](const ListedArray& known)
    {
      return known.name == name && known.type == type && known.isOfCells == isOfCells &&
        known.components == components;
    });
  if (at == list.end())
  {
    at = list.insert(at, ListedArray{ name, type, isOfCells, components });
  }
  ++at->blocks;
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  if (numbers && components > 0 && numbers->GetNumberOfTuples() > 0 && !AreColors(numbers))
  {
    double range[2];
    numbers->GetFiniteRange(range, components > 1 ? -1 : 0);
    at->low = std::min(at->low, range[0]);
    at->high = std::max(at->high, range[1]);
  }
}

std::vector<ListedArray> ArraysOf(const std::vector<Block>& blocks)
{
  std::vector<ListedArray> list;
  for (const bool isOfCells : { false, true })
  {
    for (const Block& block : blocks)
    {
      vtkFieldData* const data = isOfCells ? static_cast<vtkFieldData*>(block.data->GetCellData())
                                           : static_cast<vtkFieldData*>(block.data->GetPointData());
      for (int k = 0; k < data->GetNumberOfArrays(); ++k)
      {
        Merge(list, data->GetAbstractArray(k), isOfCells);
      }
    }
  }
  return list;
}

std::string TextOf(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/// Rows with their columns aligned.
std::string Table(const std::vector<Row>& rows)
{
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows)
  {
    for (std::size_t k = 0; k < row.size(); ++k)
    {
      widths[k] = std::max(widths[k], row[k].size());
    }
  }
  std::string text;
  for (const Row& row : rows)
  {
    for (std::size_t k = 0; k + 1 < row.size(); ++k)
    {
      text += row[k] + std::string(widths[k] + 2 - row[k].size(), ' ');
    }
    text += row.back() + "\n";
  }
  return text;
}

std::string Count(vtkIdType count, const std::string& noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// "x 0 to 1, y 0 to 2, z 0 to 3"; nothing if there are no points.
std::string BoundsOf(const vtkBoundingBox& box)
{
  std::string text;
  for (int axis = 0; box.IsValid() && axis < 3; ++axis)
  {
    text += (axis == 0 ? "" : ", ") + std::string(1, "xyz"[axis]) + " " +
      TextOf(box.GetMinPoint()[axis]) + " to " + TextOf(box.GetMaxPoint()[axis]);
  }
  return text.empty() ? text : text + "\n";
}

} // namespace

std::string ListData(const std::string& path, vtkDataObject* data)
{
  const std::vector<Block> blocks = BlocksOf(data);
  std::vector<Row> rows = { { "points", "cells", "kind", "block" } };
  vtkIdType points = 0, cells = 0;
  vtkBoundingBox box;
  for (const Block& block : blocks)
  {
    box.AddBounds(block.data->GetBounds());
    points += block.data->GetNumberOfPoints();
    cells += block.data->GetNumberOfCells();
    rows.push_back({ std::to_string(block.data->GetNumberOfPoints()),
      std::to_string(block.data->GetNumberOfCells()), KindOf(block.data), block.name });
  }
  std::string text = path + ": " + Count(points, "point") + ", " + Count(cells, "cell") + ", " +
    Count(static_cast<vtkIdType>(blocks.size()), "block") + "\n" + BoundsOf(box) + "\n" +
    Table(rows);
  rows = { { "of", "type", "components", "low", "high", "blocks", "array" } };
  for (const ListedArray& array : ArraysOf(blocks))
  {
    const bool hasRange = array.low <= array.high;
    rows.push_back({ array.isOfCells ? "cell" : "point", array.type,
      std::to_string(array.components), hasRange ? TextOf(array.low) : "-",
      hasRange ? TextOf(array.high) : "-", std::to_string(array.blocks), array.name });
  }
  return text + "\n" + (rows.size() == 1 ? "no arrays\n" : Table(rows));
}

std::string ListFile(const std::string& path, VtkMessages& messages, Progress& progress)
{
  // The file may be read in a child process, which returns meshes only: one with the text as the
  // bytes of an array.
  const auto mesh = ReadAs(path, messages, progress,
    [&path](vtkDataObject* data)
    {
      const std::string text = ListData(path, data);
      vtkNew<vtkUnsignedCharArray> bytes;
      bytes->SetNumberOfTuples(static_cast<vtkIdType>(text.size()));
      std::copy(text.begin(), text.end(), bytes->GetPointer(0));
      auto carrier = vtkSmartPointer<vtkPolyData>::New();
      carrier->GetPointData()->AddArray(bytes);
      return carrier;
    });
  auto* const bytes = vtkUnsignedCharArray::SafeDownCast(mesh->GetPointData()->GetAbstractArray(0));
  return std::string(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues());
}

} // namespace lambent::command
