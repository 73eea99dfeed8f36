// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputSurfaces.h"

#include "Abort.h"
#include "vtkLambentNormals.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <stdexcept>

namespace
{
/// Calls body() and puts the input's number before the message of what it throws.
template <typename Body>
void forInput(std::size_t input, Body&& body)
{
  try
  {
    body();
  }
  catch (const std::runtime_error& failure)
  {
    throw std::runtime_error("Input " + std::to_string(input) + ": " + failure.what());
  }
}

/// Aborts a filter as soon as the one that it works for is.
void followAbort(vtkObject* filter, unsigned long, void* owner, void*)
{
  if (isAborted(static_cast<vtkAlgorithm*>(owner)))
  {
    static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
  }
}

/// Angle-weighted normals of a mesh, whose attributes are not looked at.
vtkSmartPointer<vtkDataArray> computeNormals(vtkPolyData* input, vtkAlgorithm* owner)
{
  vtkNew<vtkPolyData> mesh;
  mesh->CopyStructure(input);
  vtkNew<vtkLambentNormals> filter;
  filter->SetInputData(mesh);

  // What is wrong with the mesh is told by the caller. Warnings are dropped: the
  // same cells are found again, and told of, when they are streamed.
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  filter->AddObserver(vtkCommand::ErrorEvent, silence);
  filter->AddObserver(vtkCommand::WarningEvent, silence);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  vtkNew<vtkCallbackCommand> follow;
  follow->SetClientData(owner);
  follow->SetCallback(followAbort);
  filter->AddObserver(vtkCommand::ProgressEvent, follow);
  filter->Update();
  return filter->GetOutput()->GetPointData()->GetNormals();
}
}

InputSurfaces::InputSurfaces(const std::vector<vtkPolyData*>& inputs,
  const std::vector<lambent::Material>& materials, const lambent::Parallel& parallel)
  : Inputs(inputs)
{
  std::size_t triangles = 0;
  for (std::size_t k = 0; k < inputs.size(); ++k)
  {
    forInput(k,
      [&]()
      {
        this->Surfaces.push_back(
          std::make_unique<SurfaceFromVTK>(inputs[k], materials[k], parallel));
        triangles += this->Surfaces[k]->surface().triangleCount();
        if (triangles >= lambent::noTriangle)
        {
          throw std::runtime_error(
            "with it the scene has more than 4294967294 triangles, the most that it can have.");
        }
      });
  }
}

void InputSurfaces::addPointNormals(bool useOwn, vtkAlgorithm* owner)
{
  for (std::size_t k = 0; k < this->Surfaces.size(); ++k)
  {
    const lambent::Surface& surface = this->Surfaces[k]->surface();
    if (surface.material.shading != lambent::Shading::Smooth || surface.triangleCount() == 0)
    {
      continue;
    }
    vtkSmartPointer<vtkDataArray> normals = this->Inputs[k]->GetPointData()->GetNormals();
    if (!useOwn || !normals)
    {
      normals = computeNormals(this->Inputs[k], owner);
      this->ComputedNormals.push_back(normals);
    }
    // None if the mesh has a wrong corner, which is found when it is streamed, or if the
    // owner was aborted.
    if (normals)
    {
      forInput(k, [&]() { this->Surfaces[k]->setPointNormals(normals); });
    }
  }
}

lambent::Bounds InputSurfaces::bounds(const lambent::Parallel& parallel) const
{
  lambent::Bounds all;
  for (const auto& surface : this->Surfaces)
  {
    all.add(findBounds(surface->surface(), parallel));
  }
  return all;
}

std::vector<lambent::Surface> InputSurfaces::surfaces() const
{
  std::vector<lambent::Surface> result;
  for (const auto& surface : this->Surfaces)
  {
    result.push_back(surface->surface());
  }
  return result;
}

InputSurfaces::Place InputSurfaces::find(std::size_t triangle) const
{
  std::size_t input = 0;
  while (triangle >= this->Surfaces[input]->surface().triangleCount())
  {
    triangle -= this->Surfaces[input]->surface().triangleCount();
    ++input;
  }
  return { input, this->Surfaces[input]->surface().cellOf(triangle) };
}

std::string InputSurfaces::describeWrongCorner(const lambent::MeshDefects& defects) const
{
  const Place place = this->find(defects.wrongCorner);
  return "Input " + std::to_string(place.input) + ": " +
    this->Surfaces[place.input]->describeWrongCell(place.cell);
}

std::string InputSurfaces::describeNotFinite(const lambent::MeshDefects& defects) const
{
  const Place place = this->find(defects.firstNotFinite);
  return std::to_string(defects.notFinite) +
    (defects.notFinite == 1 ? " cell has a point that is" : " cells have a point that is") +
    " not finite and cannot be drawn; the first is cell " + std::to_string(place.cell) +
    " of input " + std::to_string(place.input) + ". Remove such cells or correct their points.";
}
