// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "IdleOptions.h"
#include "DataColors.h"
#include "IdleFeatureAngle.h"
#include "IdleProperty.h"
#include "Messages.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace lambent::command
{
namespace
{

void Warn(const Options& options, const std::string& reason)
{
  if (!options.quiet)
  {
    Say("warning: " + reason);
  }
}

bool HaveHighlights(const std::vector<MeshLooks>& meshes)
{
  return std::any_of(meshes.begin(), meshes.end(),
    [](const MeshLooks& mesh)
    {
      return std::any_of(mesh.looks.begin(), mesh.looks.end(),
        [](const Look& look) { return look.material.specular && look.material.hasHighlights; });
    });
}

} // namespace

void DropIdleOptions(Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes,
  const std::vector<MeshLooks>& looks, vtkImageData* background)
{
  const std::string whyAngle = WhyFeatureAngleIsIdle(options, meshes);
  if (!whyAngle.empty())
  {
    options.featureAngle.reset();
    Warn(options, whyAngle);
  }
  for (const std::string& why : WhyColorsAreIdle(options, meshes))
  {
    Warn(options, why);
  }
  for (const std::string& why : WhyPropertyIsIdle(options, meshes, HaveHighlights(looks)))
  {
    Warn(options, why);
  }
  const std::string whyTexture = WhyTextureIsIdle(options);
  if (!whyTexture.empty())
  {
    options.texture.clear();
    Warn(options, whyTexture);
  }
  const Triple black{ 0, 0, 0 };
  if (background && background->GetNumberOfScalarComponents() % 2 == 1 &&
    options.background != black)
  {
    options.background = black;
    Warn(options,
      "--background has no effect, because '" + options.backgroundImage +
        "' has no alpha channel; omit one of them");
  }
}

} // namespace lambent::command
