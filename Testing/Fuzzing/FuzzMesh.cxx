// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzMesh.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <type_traits>

namespace
{
constexpr int mostPoints = 24;
constexpr int mostCells = 12; // of each kind
constexpr int mostIds = 9;    // of each cell

class SilentWindow : public vtkOutputWindow
{
public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow)
  void DisplayText(const char*) override {}
};
vtkStandardNewMacro(SilentWindow);

vtkSmartPointer<vtkDataArray> newArray(FuzzInput& input)
{
  static const int types[] = { VTK_FLOAT, VTK_FLOAT, VTK_DOUBLE, VTK_DOUBLE, VTK_INT,
    VTK_UNSIGNED_CHAR, VTK_ID_TYPE, VTK_BIT };
  const int kind = input.choice(9);
  if (kind == 8)
  {
    return vtkSmartPointer<vtkSOADataArrayTemplate<double>>::New();
  }
  return vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(types[kind]));
}

/// The nearest number that the array can hold; other conversions are undefined.
double fitting(vtkDataArray* array, double value)
{
  const int type = array->GetDataType();
  if (type == VTK_DOUBLE)
  {
    return value;
  }
  if (type == VTK_FLOAT)
  {
    constexpr double largest = std::numeric_limits<float>::max();
    return std::isfinite(value) ? std::min(std::max(value, -largest), largest) : value;
  }
  return std::isnan(value) ? 0.0 : std::floor(std::min(std::max(value, 0.0), 1.0));
}

vtkSmartPointer<vtkDataArray> makeTuples(FuzzInput& input, int count)
{
  return makeFuzzTuples(input, count, 3);
}

/// An id, usually of one of the points.
vtkIdType makeId(FuzzInput& input, int pointCount)
{
  const int id = input.byte();
  return id == 255 ? input.raw<std::int32_t>() : id % std::max(1, pointCount);
}

template <typename Array>
void setCells(FuzzInput& input, int pointCount, vtkCellArray* cells)
{
  using Value = typename Array::ValueType;
  vtkNew<Array> offsets, connectivity;
  const int count = input.choice(mostCells + 1);
  const bool isTriangles = input.flag();
  offsets->InsertNextValue(0);
  for (int cell = 0; cell < count; ++cell)
  {
    const int size = isTriangles ? 3 : input.choice(mostIds + 1);
    for (int k = 0; k < size; ++k)
    {
      connectivity->InsertNextValue(static_cast<Value>(makeId(input, pointCount)));
    }
    const bool isWrong = input.seldom(1);
    offsets->InsertNextValue(
      isWrong ? input.raw<std::int16_t>() : static_cast<Value>(connectivity->GetNumberOfValues()));
  }
  cells->SetData(offsets, connectivity);
}

vtkSmartPointer<vtkCellArray> makeCells(FuzzInput& input, int pointCount)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  switch (input.choice(8))
  {
    case 0:
    case 1:
    case 2:
      setCells<vtkTypeInt32Array>(input, pointCount, cells);
      break;
    case 3:
    case 4:
    case 5:
      setCells<vtkTypeInt64Array>(input, pointCount, cells);
      break;
    default:
      return nullptr;
  }
  return cells;
}

/// May set normals, an unused array of any length, and global ids.
void addData(FuzzInput& input, vtkIdType count, vtkDataSetAttributes* data)
{
  const int tuples = input.seldom() ? input.choice(mostPoints) : static_cast<int>(count);
  if (input.flag())
  {
    data->SetNormals(makeTuples(input, tuples));
  }
  if (input.seldom(64))
  {
    const auto array = makeTuples(input, input.choice(mostPoints));
    array->SetName(input.flag() ? "Normals" : "Other");
    data->AddArray(array);
    input.flag() ? data->SetActiveScalars(array->GetName()) : data->SetActiveNormals("Normals");
  }
  if (input.seldom())
  {
    data->SetGlobalIds(makeTuples(input, tuples));
  }
}

void count(vtkObject*, unsigned long, void* errors, void*)
{
  ++*static_cast<int*>(errors);
}
}

vtkSmartPointer<vtkDataArray> makeFuzzTuples(FuzzInput& input, int count, int usualComponents)
{
  vtkSmartPointer<vtkDataArray> array = newArray(input);
  const int components = input.seldom() ? 1 + input.choice(4) : usualComponents;
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  for (int i = 0; i < count; ++i)
  {
    for (int component = 0; component < components; ++component)
    {
      array->SetComponent(i, component, fitting(array, input.number()));
    }
  }
  return array;
}

vtkSmartPointer<vtkPolyData> makeFuzzMesh(FuzzInput& input)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  const int pointCount = input.choice(mostPoints);
  if (!input.seldom())
  {
    vtkNew<vtkPoints> points;
    points->SetData(makeTuples(input, pointCount));
    mesh->SetPoints(points);
  }
  const auto polygons = makeCells(input, pointCount);
  const auto strips = makeCells(input, pointCount);
  mesh->SetPolys(polygons);
  mesh->SetStrips(strips);
  if (input.seldom(64))
  {
    mesh->SetVerts(makeCells(input, pointCount));
    mesh->SetLines(makeCells(input, pointCount));
  }
  addData(input, mesh->GetNumberOfPoints(), mesh->GetPointData());
  addData(input, mesh->GetNumberOfCells(), mesh->GetCellData());
  return mesh;
}

ErrorCount::ErrorCount(vtkAlgorithm* algorithm)
{
  vtkNew<SilentWindow> silence;
  vtkOutputWindow::SetInstance(silence);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&this->errors);
  command->SetCallback(count);
  algorithm->AddObserver(vtkCommand::ErrorEvent, command);
  algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, command);
}
