// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief shade the samples of a tile and give their colours to the film
 *
 * paintPlainly() finds the surface point of one sample after the other and is the definition.
 * paint() takes rows piece by piece, which begin as background, and leaves the hits on
 * surfaces that are shaded alike to a kernel, which gives the same bits.
 */
#ifndef lambent_Painting_h
#define lambent_Painting_h

#include "Film.h"
#include "LightModel.h"
#include "SampleBatch.h"
#include "TileSamples.h"
#include "TrianglePoints.h"

namespace lambent
{
class Painting
{
public:
  Painting(const TrianglePoints& points, const LightModel& light, const Film& film)
    : Points(points)
    , Light(light)
    , Target(film)
  {
  }

  /// triangles: what each sample sees.
  void paintPlainly(const TileSamples& samples, const std::uint32_t* triangles) const;
  void paint(const TileSamples& samples, const std::uint32_t* triangles, SampleBatch& batch) const;
  void paintBackground(const Window& pixels) const { this->Target.storeBackground(pixels); }

private:
  void shade(SampleBatch& batch) const;
  bool nextRange(SampleBatch& batch, RunRange& range) const;
  static void shadeUnlit(const RunRange& range, SampleBatch& batch);
  static void loadReflection(const RunRange& range, SampleBatch& batch);

  const TrianglePoints& Points;
  const LightModel& Light;
  const Film& Target;
};
}

#endif
