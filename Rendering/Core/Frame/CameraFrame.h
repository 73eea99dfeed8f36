// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the camera's orthonormal frame and its lattice of rays
 *
 * A point v becomes (right.(v-E), up.(v-E), forward.(v-E)), E the eye. Pixel
 * (i, j), i from the left and j from the bottom, has its ray through (x(i), y(j))
 * of the plane at distance 1 (perspective), or parallel to the view direction
 * through (x(i), y(j)). Pixels are square; the view angle spans the image's
 * height, or its width if the camera says so, as in vtkRenderer.
 */
#ifndef lambent_CameraFrame_h
#define lambent_CameraFrame_h

#include "Bounds.h"
#include "ImageContract.h"
#include "Scene.h"

namespace lambent
{
/// What is wrong with a camera; the caller words the message.
enum class CameraDefect
{
  None,
  NotFinite,
  ViewAngle,     ///< not in (0, 180) degrees
  ParallelScale, ///< not positive
  NoDirection,   ///< position and focal point coincide
  ViewUp         ///< zero or parallel to the view direction
};

CameraDefect findDefect(const Camera& camera);

struct CameraFrame
{
  /// The frame of a camera without defect, for an image of width x height.
  CameraFrame(const Camera& camera, int width, int height);

  Vec3 eye, right, up, forward;
  bool parallel;
  double pixel;   ///< side of a pixel on the image plane
  double centerX; ///< where the image plane's origin lies, in pixels
  double centerY;

  double x(int i) const { return ((i + 0.5) - this->centerX) * this->pixel; }
  double y(int j) const { return ((j + 0.5) - this->centerY) * this->pixel; }

  FramePoint toFrame(const Vec3& v) const
  {
    const Vec3 d = v - this->eye;
    const double z = dot(this->forward, d);
    return { dot(this->right, d), dot(this->up, d), z, this->parallel ? 1.0 : z };
  }

  /// The point at a depth on the ray through (x, y), relative to the eye, with
  /// the world's axes. (Relative, so that a scene far from the origin loses
  /// nothing.)
  Vec3 fromEye(double x, double y, double depth) const
  {
    const Vec3 across = this->right * x + this->up * y;
    return this->parallel ? across + this->forward * depth : (across + this->forward) * depth;
  }
};

/**
 * The camera with its direction and view-up kept and the box just in view, as
 * vtkRenderer::ResetCamera() frames it: view angle 30 degrees, focal point in the
 * centre of the bounds, position and parallel scale so that the bounding sphere
 * touches the edges of the image. With empty bounds the camera as it is.
 */
Camera frameBounds(const Camera& camera, const Bounds& bounds, int width, int height);
}

#endif
