// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "IdleProperty.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace lambent::command
{
namespace
{

using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;

std::string Conflict(const std::string& option, const std::string& other)
{
  return option + " has no effect with " + other + "; omit one of them";
}

std::string NameOf(Representation representation)
{
  return std::string("--representation ") +
    (representation == Representation::Points ? "points" : "wireframe");
}

bool AreLinesDrawn(const Options& options, const Meshes& meshes)
{
  const bool hasEdges = options.edges || options.edgeColor;
  return !AreAllSpheres(options) && options.representation != Representation::Points &&
    (hasEdges || options.representation == Representation::Wireframe ||
      std::any_of(meshes.begin(), meshes.end(),
        [](vtkPolyData* mesh) { return mesh->GetNumberOfLines() > 0; }));
}

bool ArePointsDrawn(const Options& options, const Meshes& meshes)
{
  return !AreAllSpheres(options) &&
    (options.representation == Representation::Points ||
      std::any_of(meshes.begin(), meshes.end(),
        [](vtkPolyData* mesh) { return mesh->GetNumberOfVerts() > 0; }));
}

} // namespace

bool AreAllSpheres(const Options& options)
{
  return options.spheres && options.spheres->array.empty();
}

std::string WhyTextureIsIdle(const Options& options)
{
  const bool isSurface = options.representation == Representation::Surface;
  return options.texture.empty() ? ""
    : AreAllSpheres(options)     ? Conflict("--texture", "--spheres")
    : !isSurface                 ? Conflict("--texture", NameOf(options.representation))
                                 : "";
}

std::vector<std::string> WhyPropertyIsIdle(
  const Options& options, const Meshes& meshes, bool hasHighlights)
{
  std::vector<std::string> reasons;
  const auto add = [&reasons](bool isIdle, const std::string& reason)
  {
    if (isIdle)
    {
      reasons.push_back(reason);
    }
  };
  const Options usual;
  const bool areSpheres = AreAllSpheres(options);
  const bool isSurface = options.representation == Representation::Surface;
  const std::string edges = options.edges ? "--edges" : "--edge-color";
  add(areSpheres && !isSurface, Conflict(NameOf(options.representation), "--spheres"));
  if (options.edges || options.edgeColor)
  {
    add(areSpheres, Conflict(edges, "--spheres"));
    add(!areSpheres && !isSurface, Conflict(edges, NameOf(options.representation)));
  }
  add(options.specular.value_or(0) > 0 && options.shading == Shading::Unlit,
    Conflict("--specular", "--shading unlit"));
  add(options.specularPower && options.specular.value_or(0) <= 0 && !hasHighlights,
    "--specular-power has no effect without --specular; add one, such as --specular 0.3");
  add(options.lineWidth != usual.lineWidth && !AreLinesDrawn(options, meshes),
    "--line-width has no effect, because no lines are drawn; add --edges or --representation "
    "wireframe, or omit it");
  add(options.pointSize != usual.pointSize && !ArePointsDrawn(options, meshes),
    "--point-size has no effect, because no points are drawn; add --representation points, or "
    "omit it");
  return reasons;
}

} // namespace lambent::command
