// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputSurfaces.h"

#include "Chunks.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace
{
/// Calls body() and puts the input's number before the message of what it throws, which may
/// have begun a sentence.
template <typename Body>
void forInput(std::size_t input, Body&& body)
{
  try
  {
    body();
  }
  catch (const std::runtime_error& failure)
  {
    std::string message = failure.what();
    if (!message.empty())
    {
      message[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
    }
    throw std::runtime_error("Input " + std::to_string(input) + ": " + message);
  }
}
}

InputSurfaces::InputSurfaces(const std::vector<vtkPolyData*>& inputs,
  const std::vector<lambent::Appearance>& appearances, const lambent::Parallel& parallel)
  : Inputs(inputs)
{
  std::size_t triangles = 0;
  for (std::size_t k = 0; k < inputs.size(); ++k)
  {
    forInput(k,
      [&]()
      {
        this->Surfaces.push_back(
          std::make_unique<SurfaceFromVTK>(inputs[k], appearances[k], parallel));
        triangles += this->Surfaces[k]->surface().triangleCount();
        if (triangles >= lambent::noTriangle)
        {
          throw std::runtime_error(
            "with it the scene has more than 4294967294 triangles, the most that it can have.");
        }
      });
  }
}

void InputSurfaces::addNormals(bool useOwn, double featureAngle, const lambent::Parallel& parallel)
{
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(this->Surfaces.size(), 1));
  for (std::size_t k = 0; k < this->Surfaces.size(); ++k)
  {
    SurfaceFromVTK& surface = *this->Surfaces[k];
    if (surface.surface().appearance.shading != lambent::Shading::Smooth ||
      surface.surface().triangleCount() == 0)
    {
      continue;
    }
    forInput(k,
      [&]()
      {
        vtkDataArray* const own = this->Inputs[k]->GetPointData()->GetNormals();
        if (useOwn && own)
        {
          surface.setPointNormals(own);
          return;
        }
        this->HasComputedNormals = true;
        surface.computeNormals(featureAngle,
          lambent::Share(
            parallel, share * static_cast<double>(k), share * static_cast<double>(k + 1)));
      });
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
