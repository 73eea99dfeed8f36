// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief lines in a parallel view whose rays are at known places
 */
#ifndef LinesOnRays_h
#define LinesOnRays_h

#include "FilmPicture.h"

/// A picture of 64 x 64 pixels of size 1 in a parallel view along -z, whose rays are at halves.
struct LinesOnRays
{
  std::vector<double> points;
  std::vector<std::int32_t> corners;
  RandomScene random;

  LinesOnRays(const std::vector<lambent::Vec3>& ends, double width, double scale = 1.0)
  {
    this->random.width = this->random.height = 64;
    lambent::Camera& camera = this->random.scene.camera;
    camera.position = { 0.0, 0.0, 50.0 * scale };
    camera.focalPoint = lambent::Vec3(0.0);
    camera.parallel = true;
    camera.parallelScale = 32.0 * scale;
    for (const lambent::Vec3& end : ends)
    {
      this->corners.push_back(static_cast<std::int32_t>(this->points.size() / 3));
      this->points.insert(this->points.end(), { end.x * scale, end.y * scale, end.z * scale });
    }
    lambent::Surface surface;
    surface.points = { this->points.data(), true, ends.size() };
    surface.corners = { this->corners.data(), false, this->corners.size() };
    surface.width = width;
    this->random.scene.surfaces = { surface };
  }

  FilmPicture picture() const
  {
    return makePicture(this->random, FilmRequest(), whole(this->random), lambent::Settings());
  }
  static bool isHit(const FilmPicture& picture, int i, int j)
  {
    return picture.primitives[64 * j + i] != lambent::noPrimitive;
  }
};

#endif
