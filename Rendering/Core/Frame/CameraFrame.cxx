// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraFrame.h"

#include "Elementary.h"

namespace lambent
{
namespace
{
bool isAllFinite(const Camera& camera)
{
  return isFinite(camera.position) && isFinite(camera.focalPoint) && isFinite(camera.viewUp) &&
    std::isfinite(camera.viewAngle) && std::isfinite(camera.parallelScale) &&
    std::isfinite(camera.windowCenter[0]) && std::isfinite(camera.windowCenter[1]);
}
}

CameraDefect findDefect(const Camera& camera)
{
  // If the sine of the angle between view-up and direction is below this, the last bits of either
  // could turn the image.
  constexpr double parallelSine = 1e-10;
  if (!isAllFinite(camera))
  {
    return CameraDefect::NotFinite;
  }
  if (!camera.parallel && !(camera.viewAngle > 0.0 && camera.viewAngle < 180.0))
  {
    return CameraDefect::ViewAngle;
  }
  if (camera.parallel && !(camera.parallelScale > 0.0))
  {
    return CameraDefect::ParallelScale;
  }
  const double distance = length(camera.focalPoint - camera.position);
  if (!(distance > 0.0 && std::isfinite(distance)))
  {
    return CameraDefect::NoDirection;
  }
  const Vec3 side =
    cross(normalized(camera.focalPoint - camera.position), normalized(camera.viewUp));
  return length(side) > parallelSine ? CameraDefect::None : CameraDefect::ViewUp;
}

CameraFrame::CameraFrame(const Camera& camera, int width, int height, int samplesPerPixel)
  : eye(camera.position)
  , forward(normalized(camera.focalPoint - camera.position))
  , parallel(camera.parallel)
  , samplesPerPixel(samplesPerPixel)
  , centerX(0.5 * width - (0.5 * width) * camera.windowCenter[0])
  , centerY(0.5 * height - (0.5 * height) * camera.windowCenter[1])
{
  this->right = normalized(cross(this->forward, normalized(camera.viewUp)));
  this->up = cross(this->right, this->forward);
  if (camera.parallel)
  {
    this->pixel = 2.0 * camera.parallelScale / height;
  }
  else
  {
    this->pixel =
      2.0 * tanDegrees(0.5 * camera.viewAngle) / (camera.horizontalViewAngle ? width : height);
  }
}

Camera frameBounds(const Camera& camera, const Bounds& bounds, int width, int height)
{
  if (bounds.empty())
  {
    return camera;
  }
  const double diagonal = length(bounds.high - bounds.low);
  const double radius = diagonal > 0.0 ? 0.5 * diagonal : 0.5; // as vtkRenderer for a point
  const double aspect = static_cast<double>(width) / height;

  Camera result = camera;
  result.viewAngle = 30.0;
  // The tangent of half the angle along the image's shorter side.
  double tangent = tanDegrees(0.5 * result.viewAngle);
  if (aspect >= 1.0 && camera.horizontalViewAngle)
  {
    tangent /= aspect;
  }
  else if (aspect < 1.0 && !camera.horizontalViewAngle)
  {
    tangent *= aspect;
  }
  const double sine = tangent / std::sqrt(1.0 + tangent * tangent);
  const Vec3 backward = normalized(camera.position - camera.focalPoint);
  result.focalPoint = (bounds.low + bounds.high) * 0.5;
  result.position = result.focalPoint + backward * (radius / sine);
  result.parallelScale = aspect < 1.0 ? radius / aspect : radius;
  if (std::fabs(dot(normalized(camera.viewUp), backward)) > 0.999)
  {
    result.viewUp = { -camera.viewUp.z, camera.viewUp.x, camera.viewUp.y };
  }
  return result;
}
}
