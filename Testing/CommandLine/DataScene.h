// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a mesh with arrays, and the scene that options make of it
 */
#ifndef DataScene_h
#define DataScene_h

#include "Messages.h"
#include "Options.h"
#include "Scene.h"

#include "vtkLambentRayTracer.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;

inline vtkSmartPointer<vtkPolyData> Triangle()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell({ 0, 1, 2 });
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  return mesh;
}

template <typename Array>
vtkSmartPointer<Array> Numbers(const char* name, int components, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const double value : values)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>(value));
  }
  return array;
}

/// Points: t, 2 to 8, v, of three components, rgb and m, of bytes. Cell: t, c and a text.
inline vtkSmartPointer<vtkPolyData> Colored()
{
  auto mesh = Triangle();
  vtkPointData* const points = mesh->GetPointData();
  points->AddArray(Numbers<vtkDoubleArray>("t", 1, { 2, 4, 8 }));
  points->AddArray(Numbers<vtkFloatArray>("v", 3, { 3, 0, 4, 0, 0, 1, 0, 0, 0 }));
  points->AddArray(Numbers<vtkUnsignedCharArray>("rgb", 3, { 1, 2, 3, 4, 5, 6, 7, 8, 9 }));
  points->AddArray(Numbers<vtkUnsignedCharArray>("m", 1, { 0, 3, 1 }));
  vtkCellData* const cells = mesh->GetCellData();
  cells->AddArray(Numbers<vtkDoubleArray>("t", 1, { 5 }));
  cells->AddArray(Numbers<vtkDoubleArray>("c", 1, { -5 }));
  vtkNew<vtkStringArray> text;
  text->SetName("text");
  text->InsertNextValue("steel");
  cells->AddArray(text);
  return mesh;
}

inline lambent::command::Parsed Parse(std::vector<const char*> arguments)
{
  for (const char* const first : { "x.png", "-o", "a.vtp", "lambent" })
  {
    arguments.insert(arguments.begin(), first);
  }
  return lambent::command::ParseOptions(static_cast<int>(arguments.size()), arguments.data(), "");
}

inline vtkSmartPointer<vtkLambentRayTracer> Scene(
  const std::vector<const char*>& arguments, const Meshes& meshes = { Colored() })
{
  lambent::command::Parsed parsed = Parse(arguments);
  EXPECT_FALSE(parsed.exitStatus) << parsed.standardError;
  parsed.options.size = { 8, 8 };
  return lambent::command::MakeScene(parsed.options, meshes);
}

inline std::string Refusal(
  const std::vector<const char*>& arguments, const Meshes& meshes = { Colored() })
{
  try
  {
    Scene(arguments, meshes);
    return "";
  }
  catch (const lambent::command::WrongUsage& reason)
  {
    return reason.what();
  }
}

#endif
