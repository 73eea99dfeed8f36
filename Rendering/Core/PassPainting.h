// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief stores the passes of an image: depth, normals, positions, attributes
 *
 * A pass shows what the middle sample of each pixel sees. paintPlainly() handles one pixel at a
 * time and is the definition. paint() computes the surface points of many pixels in a kernel, and
 * gives the same bits. If a pixel has only one sample, its surface point is computed for shading
 * anyway, and Painting passes it to store().
 */
#ifndef lambent_PassPainting_h
#define lambent_PassPainting_h

#include "Image.h"
#include "PointBatch.h"
#include "SurfacePoints.h"
#include "TileSamples.h"

namespace lambent
{
/// A worker's memory for the current tile.
struct PassMemory
{
  SampleBatch batch;
  PointBatch points;
  std::uint32_t hits[SampleBatch::pieceSize];
  double xs[SampleBatch::places + TileSamples::widestVector]; ///< of the middle samples, by place
};

class PassPainting
{
public:
  PassPainting(const SurfacePoints& points, const Image& image)
    : Points(points)
    , Target(image)
  {
  }

  bool isNeeded() const { return !this->Target.passes.empty(); }

  /// primitives: the primitive that each sample sees.
  void paintPlainly(const TileSamples& samples, const std::uint32_t* primitives) const;
  void paint(const TileSamples& samples, const std::uint32_t* primitives, PassMemory& memory) const;
  void paintNothing(const Window& samples) const;
  /// Stores the pixels of a batch of middle samples.
  void store(const SampleBatch& batch, const PointBatch& points) const;
  void storeNothing(int i, int j, int count) const;

private:
  std::size_t pixel(int i, int j) const
  {
    return static_cast<std::size_t>(j) * this->Target.part.width() + i;
  }
  double value(const Pass& pass, const SurfacePoint& point, std::uint32_t primitive, int k) const;
  void flush(PassMemory& memory) const;
  void store(const Pass& pass, const SampleBatch& batch, const PointBatch& points, int piece) const;
  void storeAttribute(
    const Pass& pass, const SampleBatch& batch, const PointBatch& points, int piece) const;
  template <typename ValueOf>
  void store(const Pass& pass, const SampleBatch& batch, int piece, const ValueOf& valueOf) const;

  const SurfacePoints& Points;
  const Image& Target;
};
}

#endif
