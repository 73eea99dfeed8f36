// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief shades the samples of a tile that sees transparent surfaces, and stores its pixels
 *
 * All hits of a sample are composited from the nearest to the farthest (T. Porter and T. Duff,
 * "Compositing Digital Images", SIGGRAPH 1984). With colour C = 0 and transmittance T = 1 at first,
 * a hit of colour c and opacity a makes them
 *
 *     C + (T a) c    and    T (1 - a)
 *
 * until T is 0 or no hit is left. The colour of the sample is C + T b, where b is the background,
 * and its alpha is 1 - T. Hits of opacity 0 are not seen. If none is seen, the sample is
 * background. The primitive and the passes of a sample are those of the nearest hit that is seen,
 * whatever its opacity.
 *
 * paintPlainly() handles one sample at a time and is the definition. paint() shades the nearest
 * hits of all samples, then the next ones, and so on. It gives the same bits.
 */
#ifndef lambent_LayerPainting_h
#define lambent_LayerPainting_h

#include "Film.h"
#include "PassPainting.h"
#include "SampleShading.h"
#include "SortedLayers.h"

#include <memory>
#include <vector>

namespace lambent
{
/// A worker's memory for the current tile.
struct LayerMemory
{
  SortedLayers sorted;
  SampleBatch batch;
  EdgesInTile edges;
  PointBatch points;
  TileColors colors;                     ///< C and, as the fourth channel, T
  std::vector<std::uint32_t> primitives; ///< that each sample sees
  std::vector<std::uint32_t> rowCounts;  ///< the most hits that a sample of the row has
  PassMemory passes;
};

class LayerPainting
{
public:
  LayerPainting(const SurfacePoints& points, const LightModel& light, const Film& film,
    const PassPainting& passes)
    : Points(points)
    , Shades(points, light)
    , Target(film)
    , Passes(passes)
  {
  }

  /// Both paint the hits in memory.sorted.
  void paintPlainly(const TileSamples& samples, LayerMemory& memory) const;
  void paint(const TileSamples& samples, LayerMemory& memory) const;

private:
  void begin(const TileSamples& samples, LayerMemory& memory) const;
  bool paintLayer(const TileSamples& samples, std::uint32_t layer, LayerMemory& memory) const;
  void flush(const TileSamples& samples, LayerMemory& memory) const;
  void addBackground(const TileSamples& samples, LayerMemory& memory) const;
  void finish(const TileSamples& samples, LayerMemory& memory) const;
  FilmColor sampleColor(const TileSamples& samples, int i, int j, LayerMemory& memory) const;

  const SurfacePoints& Points;
  const SampleShading Shades;
  const Film& Target;
  const PassPainting& Passes;
};
}

#endif
