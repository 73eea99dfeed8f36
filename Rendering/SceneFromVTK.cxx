// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneFromVTK.h"

#include "CameraFrame.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"

#include <cmath>

namespace lambent::adapters
{
namespace
{
Vec3 toVec3(const double* v)
{
  return { v[0], v[1], v[2] };
}

/// An affine map, applied by our own sums, in one order.
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

/// A point of the space that camera lights live in: the camera stands at (0, 0, 1)
/// and looks at the origin, y is up, and the unit is the focal distance.
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

Camera cameraFromVTK(vtkCamera* camera)
{
  Camera result;
  result.position = toVec3(camera->GetPosition());
  result.focalPoint = toVec3(camera->GetFocalPoint());
  result.viewUp = toVec3(camera->GetViewUp());
  result.viewAngle = camera->GetViewAngle();
  result.horizontalViewAngle = camera->GetUseHorizontalViewAngle() != 0;
  result.parallel = camera->GetParallelProjection() != 0;
  result.parallelScale = camera->GetParallelScale();
  camera->GetWindowCenter(result.windowCenter);
  return result;
}

void applyFraming(const Camera& framed, vtkCamera* camera)
{
  camera->SetPosition(framed.position.x, framed.position.y, framed.position.z);
  camera->SetFocalPoint(framed.focalPoint.x, framed.focalPoint.y, framed.focalPoint.z);
  camera->SetViewUp(framed.viewUp.x, framed.viewUp.y, framed.viewUp.z);
  camera->SetViewAngle(framed.viewAngle);
  camera->SetParallelScale(framed.parallelScale);
}

std::string unsupportedSettings(vtkCamera* camera)
{
  std::string names;
  const auto add = [&names](bool isUsed, const char* name)
  {
    if (isUsed)
    {
      names += names.empty() ? name : std::string(", ") + name;
    }
  };
  const double* shear = camera->GetViewShear();
  add(camera->GetUserTransform() != nullptr, "UserTransform");
  add(camera->GetUserViewTransform() != nullptr, "UserViewTransform");
  add(!camera->GetModelTransformMatrix()->IsIdentity(), "ModelTransformMatrix");
  add(camera->GetUseOffAxisProjection() != 0, "UseOffAxisProjection");
  add(camera->GetUseExplicitProjectionTransformMatrix(), "UseExplicitProjectionTransformMatrix");
  add(shear[0] != 0.0 || shear[1] != 0.0, "ViewShear");
  return names;
}

std::string describeDefect(const Camera& camera)
{
  switch (findDefect(camera))
  {
    case CameraDefect::NotFinite:
      return "The camera has a setting that is not a finite number. Check SetPosition(), "
             "SetFocalPoint(), SetViewUp(), SetViewAngle(), SetParallelScale() and "
             "SetWindowCenter().";
    case CameraDefect::ViewAngle:
      return "The camera's view angle is " + std::to_string(camera.viewAngle) +
        " degrees; it must lie between 0 and 180. Call vtkCamera::SetViewAngle().";
    case CameraDefect::ParallelScale:
      return "The camera's parallel scale is " + std::to_string(camera.parallelScale) +
        "; it must be positive. Call vtkCamera::SetParallelScale().";
    case CameraDefect::NoDirection:
      return "The camera's position and focal point coincide. Move one of them with "
             "vtkCamera::SetPosition() or SetFocalPoint().";
    case CameraDefect::ViewUp:
      return "The camera's view-up is zero or parallel to its view direction. Call "
             "vtkCamera::SetViewUp() with another direction.";
    case CameraDefect::None:
      break;
  }
  return "";
}

Light lightFromVTK(vtkLight* light, const Camera& camera)
{
  Vec3 position = toVec3(light->GetPosition());
  Vec3 focalPoint = toVec3(light->GetFocalPoint());
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
  result.color = toVec3(light->GetDiffuseColor()) * light->GetIntensity();
  result.coneAngle = light->GetConeAngle();
  result.exponent = light->GetExponent();
  result.attenuation = toVec3(light->GetAttenuationValues());
  return result;
}

std::string describeDefect(const Light& light)
{
  const Vec3& attenuation = light.attenuation;
  if (!isFinite(light.position) || !isFinite(light.direction) || !isFinite(light.color) ||
    !isFinite(attenuation) || !std::isfinite(light.coneAngle) || !std::isfinite(light.exponent))
  {
    return "has a setting that is not a finite number. Check its position, focal point, "
           "transform matrix, colour, intensity, cone angle, exponent and attenuation.";
  }
  if (light.positional && attenuation.x <= 0.0 && attenuation.y <= 0.0 && attenuation.z <= 0.0)
  {
    return "has no positive attenuation value, so that its light would be divided by zero or "
           "less. Call vtkLight::SetAttenuationValues(1, 0, 0) for light that does not fade.";
  }
  return "";
}

Light headlight(const Camera& camera)
{
  Light result;
  result.direction = camera.focalPoint - camera.position;
  return result;
}

Appearance appearanceFromVTK(vtkProperty* property)
{
  Appearance result;
  if (!property)
  {
    return result;
  }
  result.diffuse = property->GetDiffuse();
  result.ambient = property->GetAmbient();
  result.diffuseColor = toVec3(property->GetDiffuseColor());
  result.ambientColor = toVec3(property->GetAmbientColor());
  result.shading = !property->GetLighting()    ? Shading::Unlit
    : property->GetInterpolation() == VTK_FLAT ? Shading::Flat
                                               : Shading::Smooth;
  result.cullFront = property->GetFrontfaceCulling() != 0;
  result.cullBack = property->GetBackfaceCulling() != 0;
  return result;
}

bool isFinite(const Appearance& appearance)
{
  return isFinite(appearance.diffuseColor) && isFinite(appearance.diffuseReflection()) &&
    isFinite(appearance.ambientReflection());
}
}
