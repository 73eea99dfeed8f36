// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the camera's orthonormal frame and its lattice of rays
 *
 * A point v becomes (right.(v-E), up.(v-E), forward.(v-E)), where E is the eye. In pixel (i, j), i
 * counts from the left and j from the bottom. In a perspective view, its ray passes through (x(i),
 * y(j)) of the plane at distance 1. In a parallel view, its ray passes through (x(i), y(j)),
 * parallel to the view direction. Pixels are square. The view angle spans the height of the image,
 * or its width if the camera says so, as in vtkRenderer.
 */
#ifndef lambent_CameraFrame_h
#define lambent_CameraFrame_h

#include "Bounds.h"
#include "ImageContract.h"
#include "Scene.h"

namespace lambent
{
/// The defect of a camera. The caller words the message.
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
  /// The frame for an image of width x height samples, with samplesPerPixel across a pixel of the
  /// picture. The camera must have no defect.
  CameraFrame(const Camera& camera, int width, int height, int samplesPerPixel = 1);

  Vec3 eye, right, up, forward;
  bool parallel;
  double pixel;        ///< side length of a sample on the image plane
  int samplesPerPixel; ///< across a pixel of the picture, in which widths of lines are measured
  double centerX;      ///< position of the image plane's origin, in samples
  double centerY;

  double x(int i) const { return ((i + 0.5) - this->centerX) * this->pixel; }
  double y(int j) const { return ((j + 0.5) - this->centerY) * this->pixel; }

  /// Half of a width in pixels of the picture, on the image plane.
  double halfOf(double width) const { return 0.5 * (width * this->samplesPerPixel) * this->pixel; }

  FramePoint toFrame(const Vec3& v) const
  {
    const Vec3 d = v - this->eye;
    const double z = dot(this->forward, d);
    return { dot(this->right, d), dot(this->up, d), z, this->parallel ? 1.0 : z };
  }

  /// The point at a depth on the ray through (x, y), relative to the eye, along the axes of the
  /// world. It is relative so that a scene far from the origin loses no precision.
  Vec3 fromEye(double x, double y, double depth) const
  {
    const Vec3 across = this->right * x + this->up * y;
    return this->parallel ? across + this->forward * depth : (across + this->forward) * depth;
  }
};

/**
 * Moves a camera until the bounds are just in view, as vtkRenderer::ResetCamera() does. The
 * direction stays, and view-up, too, unless the two are almost parallel. The view angle becomes 30
 * degrees and the focal point the centre of the bounds. Position and parallel scale make the
 * bounding sphere touch the edges of the image. With empty bounds, returns the camera unchanged.
 */
Camera frameBounds(const Camera& camera, const Bounds& bounds, int width, int height);
}

#endif
