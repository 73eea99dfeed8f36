// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputSurfaces.h"

#include "Chunks.h"
#include "InputName.h"
#include "InputShares.h"
#include "PassArrays.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>

namespace lambent::adapters
{
namespace
{
/// Calls body(). If it throws, puts the name of the input before the message, whose first letter
/// becomes lower case.
template <typename Body>
void forInput(const SceneSettings::Input& input, Body&& body)
{
  try
  {
    body();
  }
  catch (const std::runtime_error& failure)
  {
    throw std::runtime_error(nameOf(input) + ": " + withinSentence(failure.what()));
  }
}
}

InputSurfaces::InputSurfaces(const std::vector<SceneSettings::Input>& inputs,
  const std::vector<Appearance>& appearances, const std::vector<LineStyle>& lineStyles,
  const Parallel& parallel)
  : Inputs(inputs)
{
  InputShares shares(inputs, parallel);
  for (std::size_t k = 0; k < inputs.size(); ++k)
  {
    forInput(inputs[k],
      [&]()
      {
        this->Surfaces.push_back(std::make_unique<SurfaceFromVTK>(
          inputs[k], appearances[k], lineStyles[k], shares.next()));
        this->Surfaces[k]->forSurfaces(
          [&](const Surface& surface) {
            this->Pieces.push_back({ 0, k, &surface });
          });
      });
  }
}

void InputSurfaces::numberPrimitives()
{
  std::size_t primitives = 0;
  for (Piece& piece : this->Pieces)
  {
    piece.firstPrimitive = primitives;
    primitives += piece.surface->primitiveCount();
    if (primitives >= noPrimitive)
    {
      throw std::runtime_error(nameOf(this->Inputs[piece.input]) +
        ": with it the scene has more than 4294967294 triangles, spheres and lines, which is the "
        "maximum.");
    }
  }
}

void InputSurfaces::addNormals(bool useOwn, double featureAngle, const Parallel& parallel)
{
  std::vector<std::size_t> small, large; // the inputs that need computed normals
  for (std::size_t k = 0; k < this->Surfaces.size(); ++k)
  {
    SurfaceFromVTK& surface = *this->Surfaces[k];
    vtkDataArray* const own = this->Inputs[k].mesh->GetPointData()->GetNormals();
    const bool hasFaces = surface.surface().triangleCount() > 0;
    if (surface.surface().appearance.shading != Shading::Smooth ||
      !(hasFaces || surface.hasLines()))
    {
      continue;
    }
    if (useOwn && own)
    {
      const bool isSmall = static_cast<std::size_t>(own->GetNumberOfTuples()) < trianglesOfSmall;
      const Unwatched unwatched(parallel);
      const Share watched(parallel, 0.0, 0.0); // normals are only copied, if at all
      forInput(this->Inputs[k],
        [&]() {
          surface.setPointNormals(own, isSmall ? static_cast<const Parallel&>(unwatched) : watched);
        });
      continue;
    }
    if (hasFaces)
    {
      (surface.surface().triangleCount() < trianglesOfSmall ? small : large).push_back(k);
    }
  }
  this->HasComputedNormals = !small.empty() || !large.empty();
  const double count = static_cast<double>(std::max<std::size_t>(large.size(), 1) + 1);
  this->computeSmallNormals(small, featureAngle, Share(parallel, 0.0, 1.0 / count));
  for (std::size_t k = 0; k < large.size(); ++k)
  {
    const Share share(parallel, (k + 1) / count, (k + 2) / count);
    forInput(this->Inputs[large[k]],
      [&]() { this->Surfaces[large[k]]->computeNormals(featureAngle, share); });
  }
}

/// Uses one thread for each input, several at a time. If some fail, throws the first input's error.
void InputSurfaces::computeSmallNormals(
  const std::vector<std::size_t>& inputs, double featureAngle, const Parallel& parallel)
{
  constexpr std::size_t inputsPerChunk = 16;
  std::vector<std::string> failures(inputs.size());
  forEachChunk<inputsPerChunk>(parallel, inputs.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        try
        {
          forInput(this->Inputs[inputs[k]],
            [&]() { this->Surfaces[inputs[k]]->computeNormals(featureAngle, Parallel()); });
        }
        catch (const std::runtime_error& failure)
        {
          failures[k] = failure.what();
        }
      }
    });
  const auto first = std::find_if(
    failures.begin(), failures.end(), [](const std::string& text) { return !text.empty(); });
  if (first != failures.end())
  {
    throw std::runtime_error(*first);
  }
}

void InputSurfaces::addColors(std::size_t k, const InputColors& settings)
{
  forInput(this->Inputs[k], [&]() { this->Surfaces[k]->addColors(settings); });
}

void InputSurfaces::addTexture(std::size_t k, const Texture& texture)
{
  forInput(this->Inputs[k], [&]() { this->Surfaces[k]->addTexture(texture); });
}

void InputSurfaces::addAttributes(const std::vector<SceneSettings::PassArray>& arrays)
{
  for (std::size_t attribute = 0; attribute < arrays.size(); ++attribute)
  {
    std::size_t first = this->Surfaces.size(); // input that has it
    for (std::size_t k = 0; k < this->Surfaces.size(); ++k)
    {
      forInput(this->Inputs[k], [&]() { this->Surfaces[k]->addAttribute(arrays[attribute]); });
      const auto components = [&](std::size_t input)
      { return this->Surfaces[input]->surface().attributes[attribute].components; };
      if (!this->Surfaces[k]->surface().attributes[attribute])
      {
        continue;
      }
      first = std::min(first, k);
      if (components(k) != components(first))
      {
        throw std::runtime_error(nameOf(this->Inputs[k]) + ": the " + describe(arrays[attribute]) +
          " has " + std::to_string(components(k)) + " components, but that of " +
          withinSentence(nameOf(this->Inputs[first])) + " has " +
          std::to_string(components(first)) +
          ". Give them the same number, or rename one of them.");
      }
    }
  }
}

/// Returns the form of the output array: double if an input has numbers that float cannot hold,
/// otherwise float. Inputs without values are considered only if no input has values.
InputSurfaces::ArrayForm InputSurfaces::formOf(std::size_t attribute) const
{
  const auto valuesOf = [attribute](const auto& surface) -> const AttributeSpan&
  { return surface->surface().attributes[attribute]; };
  const bool hasValues = std::any_of(this->Surfaces.begin(), this->Surfaces.end(),
    [&](const auto& surface) { return static_cast<bool>(valuesOf(surface)); });
  ArrayForm form;
  for (const auto& surface : this->Surfaces)
  {
    const AttributeSpan& values = valuesOf(surface);
    if (values || !hasValues)
    {
      form.components = std::max(form.components, values.components);
      form.isDouble = form.isDouble ||
        (values.type >= AttributeType::Int32 && values.type != AttributeType::Float);
    }
  }
  return form;
}

std::vector<Surface> InputSurfaces::surfaces() const
{
  std::vector<Surface> result;
  for (const auto& surface : this->Surfaces)
  {
    surface->append(result);
  }
  return result;
}

const InputSurfaces::Piece& InputSurfaces::pieceOf(std::size_t primitive) const
{
  return *(std::upper_bound(this->Pieces.begin(), this->Pieces.end(), primitive,
             [](std::size_t number, const Piece& piece) { return number < piece.firstPrimitive; }) -
    1);
}

InputSurfaces::Place InputSurfaces::find(std::size_t primitive) const
{
  const Piece& piece = this->pieceOf(primitive);
  return { piece.input, piece.surface->cellOf(primitive - piece.firstPrimitive),
    this->Inputs[piece.input].connection, this->Inputs[piece.input].block };
}

std::string InputSurfaces::describeWrongCorner(const MeshDefects& defects) const
{
  const Place place = this->find(defects.wrongCorner);
  return nameOf(this->Inputs[place.input]) + ": " +
    this->Surfaces[place.input]->describeWrongCell(place.cell);
}

std::string InputSurfaces::describeNotFinite(const MeshDefects& defects) const
{
  const Place place = this->find(defects.firstNotFinite);
  if (this->Surfaces[place.input]->surface().kind() == PrimitiveKind::Sphere)
  {
    return std::to_string(defects.notFinite) +
      (defects.notFinite == 1 ? " sphere or cell has a point that is"
                              : " spheres or cells have a point that is") +
      " not finite and cannot be rendered; the first is the sphere at point " +
      std::to_string(place.cell) + " of " + withinSentence(nameOf(this->Inputs[place.input])) +
      ". Remove such points or correct them.";
  }
  return std::to_string(defects.notFinite) +
    (defects.notFinite == 1 ? " cell has a point that is" : " cells have a point that is") +
    " not finite and cannot be rendered; the first is cell " + std::to_string(place.cell) + " of " +
    withinSentence(nameOf(this->Inputs[place.input])) +
    ". Remove such cells or correct their points.";
}
}
