// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CoverWithTexture.h"
#include "Messages.h"
#include "Progress.h"
#include "ReadBackground.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace lambent::command
{
namespace
{

vtkIdType CountPolygons(vtkPolyData* mesh)
{
  return mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips();
}

bool HasCoordinates(vtkPolyData* mesh)
{
  return CountPolygons(mesh) > 0 && mesh->GetPointData()->GetTCoords();
}

void WarnOfUncovered(const Options& options, const MaterialInputs::Meshes& meshes)
{
  for (std::size_t k = 0; k < meshes.size(); ++k)
  {
    if (!options.quiet && !HasCoordinates(meshes[k]))
    {
      Say("warning: '" + options.inputs[k] +
        "': --texture does not cover it, because it has no texture coordinates; add them to the "
        "file");
    }
  }
}

} // namespace

std::vector<MeshLooks> CoverWithTexture(const Options& options,
  const MaterialInputs::Meshes& meshes, VtkMessages& messages, Progress& progress)
{
  if (std::none_of(meshes.begin(), meshes.end(), HasCoordinates))
  {
    throw WrongUsage("--texture " + options.texture +
      ": no input has faces with texture coordinates; add them to a file, for instance with "
      "vtkTextureMapToPlane, or omit --texture");
  }
  Look look;
  look.image = ReadBackground(options.texture, messages, progress);
  WarnOfUncovered(options, meshes);
  std::vector<MeshLooks> all(meshes.size());
  for (std::size_t k = 0; k < meshes.size(); ++k)
  {
    if (HasCoordinates(meshes[k]))
    {
      all[k].looks.push_back(look);
      all[k].ofPolygon.assign(static_cast<std::size_t>(CountPolygons(meshes[k])), 0);
    }
  }
  return all;
}

} // namespace lambent::command
