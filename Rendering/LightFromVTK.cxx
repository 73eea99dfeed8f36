// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightFromVTK.h"

#include "Vec3FromVTK.h"

#include "vtkLight.h"
#include "vtkMatrix4x4.h"

#include <cmath>

namespace lambent::adapters
{
namespace
{
/// Applies an affine map, with sums in our own fixed order.
Vec3 transformed(vtkMatrix4x4* matrix, const Vec3& p)
{
  if (!matrix)
  {
    return p;
  }
  const auto row = [&](int i)
  {
    return ((matrix->GetElement(i, 0) * p.x + matrix->GetElement(i, 1) * p.y) +
             matrix->GetElement(i, 2) * p.z) +
      matrix->GetElement(i, 3);
  };
  return { row(0), row(1), row(2) };
}

/// Converts a point from the space of camera lights: the camera is at (0, 0, 1) and looks at the
/// origin, y is up, and the unit is the focal distance.
Vec3 fromCameraSpace(const Vec3& p, const Camera& camera)
{
  const Vec3 view = camera.focalPoint - camera.position;
  const double distance = length(view);
  const Vec3 forward = normalized(view);
  const Vec3 right = normalized(cross(forward, camera.viewUp));
  const Vec3 up = cross(right, forward);
  return camera.focalPoint + (((right * p.x + up * p.y) - forward * p.z) * distance);
}
}

Light lightFromVTK(vtkLight* light, const Camera& camera)
{
  Vec3 position = vec3FromVTK(light->GetPosition());
  Vec3 focalPoint = vec3FromVTK(light->GetFocalPoint());
  if (light->LightTypeIsHeadlight())
  {
    position = camera.position;
    focalPoint = camera.focalPoint;
  }
  else if (light->LightTypeIsCameraLight())
  {
    position = fromCameraSpace(position, camera);
    focalPoint = fromCameraSpace(focalPoint, camera);
  }
  else
  {
    position = transformed(light->GetTransformMatrix(), position);
    focalPoint = transformed(light->GetTransformMatrix(), focalPoint);
  }
  Light result;
  result.positional = light->GetPositional() != 0;
  result.position = position;
  result.direction = focalPoint - position;
  result.color = vec3FromVTK(light->GetDiffuseColor()) * light->GetIntensity();
  result.specularColor = vec3FromVTK(light->GetSpecularColor()) * light->GetIntensity();
  result.coneAngle = light->GetConeAngle();
  result.exponent = light->GetExponent();
  result.attenuation = vec3FromVTK(light->GetAttenuationValues());
  return result;
}

std::string describeDefect(const Light& light)
{
  const Vec3& attenuation = light.attenuation;
  if (!isFinite(light.position) || !isFinite(light.direction) || !isFinite(light.color) ||
    !isFinite(light.specularColor) || !isFinite(attenuation) || !std::isfinite(light.coneAngle) ||
    !std::isfinite(light.exponent))
  {
    return "has a setting that is not a finite number. Check its position, focal point, "
           "transform matrix, colour, intensity, cone angle, exponent and attenuation.";
  }
  if (light.positional && attenuation.x <= 0.0 && attenuation.y <= 0.0 && attenuation.z <= 0.0)
  {
    return "has no positive attenuation value, so its light would be divided by zero or "
           "less. Call vtkLight::SetAttenuationValues(1, 0, 0) for light without attenuation.";
  }
  return "";
}

Light headlight(const Camera& camera)
{
  Light result;
  result.direction = camera.focalPoint - camera.position;
  return result;
}
}
