// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief write the pixels of a cell: the colour of what is hit, or the background
 */
#ifndef lambent_Painting_h
#define lambent_Painting_h

#include "NearestHits.h"
#include "Render.h"
#include "Shading.h"

namespace lambent
{
class Painting
{
public:
  Painting(const Scene& scene, const Shader& shader, const CameraFrame& frame, const Image& image)
    : Description(scene)
    , Colors(shader)
    , Frame(frame)
    , Target(image)
  {
  }

  /// Paint the window of the hits; windows count from the image's part.
  void paint(const NearestHits& hits) const;

private:
  /// The background's colour in a row of the whole image.
  Vec3 background(int j) const;
  void store(std::size_t pixel, const Vec3& color) const;

  const Scene& Description;
  const Shader& Colors;
  const CameraFrame& Frame;
  const Image Target;
};
}

#endif
