// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraFromVTK.h"

#include "CameraFrame.h"
#include "Vec3FromVTK.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

namespace lambent::adapters
{
Camera cameraFromVTK(vtkCamera* camera)
{
  Camera result;
  result.position = vec3FromVTK(camera->GetPosition());
  result.focalPoint = vec3FromVTK(camera->GetFocalPoint());
  result.viewUp = vec3FromVTK(camera->GetViewUp());
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
}
