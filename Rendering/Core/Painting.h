// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief shade the samples of a tile and give their colours to the film
 *
 * Windows and rows count in samples here.
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

#include <vector>

namespace lambent
{
/// What a worker needs for the tile at hand.
struct PaintingMemory
{
  SampleBatch batch;
  // Where pixels have several samples.
  TileColors colors;
  std::vector<unsigned char> isHit; ///< rows of pixels
};

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
  void paint(
    const TileSamples& samples, const std::uint32_t* triangles, PaintingMemory& memory) const;
  void paintBackground(const Window& samples) const
  {
    this->Target.storeBackground(this->pixelsOf(samples));
  }

private:
  Window pixelsOf(const Window& samples) const
  {
    const int n = this->Target.target().samples;
    return { samples.i0 / n, samples.i1 / n, samples.j0 / n, samples.j1 / n };
  }
  Vec3 sampleColor(const TileSamples& samples, const std::uint32_t* triangles, int i, int j) const;
  template <typename BackgroundOf, typename StoreTo>
  void paintRow(const TileSamples& samples, const std::uint32_t* triangles, int row,
    SampleBatch& batch, const BackgroundOf& background, const StoreTo& store) const;
  void paintAverages(
    const TileSamples& samples, const std::uint32_t* triangles, PaintingMemory& memory) const;
  template <typename StoreTo>
  void shade(SampleBatch& batch, const StoreTo& store) const;
  bool nextRange(SampleBatch& batch, RunRange& range) const;
  static void shadeUnlit(const RunRange& range, SampleBatch& batch);
  static void loadReflection(const RunRange& range, SampleBatch& batch);

  const TrianglePoints& Points;
  const LightModel& Light;
  const Film& Target;
};
}

#endif
