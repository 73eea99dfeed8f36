// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief shades the samples of a tile, and stores their colours and passes
 *
 * Windows and rows are counted in samples here.
 *
 * paintPlainly() shades one sample at a time and is the definition. paint() splits rows into
 * pieces, which begin as background, shades them with SampleShading, and gives the same bits.
 */
#ifndef lambent_Painting_h
#define lambent_Painting_h

#include "CellEdges.h"
#include "Film.h"
#include "LightModel.h"
#include "PassPainting.h"
#include "SampleShading.h"
#include "TileSamples.h"

#include <memory>
#include <vector>

namespace lambent
{
/// A worker's memory for the current tile.
struct PaintingMemory
{
  SampleBatch batch;
  EdgesInTile edges;
  // Used if pixels have several samples.
  TileColors colors;
  std::vector<unsigned char> isHit;   ///< per row of pixels
  std::unique_ptr<PassMemory> passes; ///< if the image has passes
};

class Painting
{
public:
  Painting(const SurfacePoints& points, const LightModel& light, const Film& film,
    const PassPainting& passes)
    : Points(points)
    , Shades(points, light)
    , Target(film)
    , Passes(passes)
  {
  }

  /// primitives: the primitive that each sample sees.
  void paintPlainly(const TileSamples& samples, const std::uint32_t* primitives) const;
  void paint(
    const TileSamples& samples, const std::uint32_t* primitives, PaintingMemory& memory) const;
  void paintBackground(const Window& samples) const
  {
    this->Target.storeBackground(this->Target.target().pixelsOf(samples));
    this->Passes.paintNothing(samples);
  }

private:
  FilmColor sampleColor(
    const TileSamples& samples, const std::uint32_t* primitives, int i, int j) const;
  template <typename BackgroundOf, typename StoreTo>
  void paintRow(const TileSamples& samples, const std::uint32_t* primitives, int row,
    PaintingMemory& memory, const BackgroundOf& background, const StoreTo& store,
    PointBatch* points = nullptr) const;
  void paintSamples(
    const TileSamples& samples, const std::uint32_t* primitives, PaintingMemory& memory) const;
  void paintAverages(
    const TileSamples& samples, const std::uint32_t* primitives, PaintingMemory& memory) const;
  template <typename StoreTo>
  void shade(PaintingMemory& memory, const StoreTo& store, PointBatch* points = nullptr) const;
  void fillBackground(SampleBatch& batch) const;
  void fillMissed(SampleBatch& batch, int number) const;

  const SurfacePoints& Points;
  const SampleShading Shades;
  const Film& Target;
  const PassPainting& Passes;
};
}

#endif
