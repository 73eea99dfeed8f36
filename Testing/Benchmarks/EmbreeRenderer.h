// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the same picture by Embree: build a tree, trace the rays, shade the hits
 *
 * What is done so that the peer is at its best:
 *
 * - Points as floats and corners as 32-bit integers lie ready, padded as Embree wants
 *   them, and are shared with it, not copied. Converting them is not timed.
 * - Trees of all three qualities (low is the Morton-code builder, high splits
 *   triangles), no robust flag, no compact trees, no filters.
 * - Rays go in tiles of 16 x 16 pixels; one at a time, in packets as wide as the
 *   machine's vectors (16 or 8 rays, blocks of pixels) or whole tiles as streams; all
 *   are said to be coherent. Tiles are shared out by Embree's own thread pool, TBB's.
 * - Denormals are flushed to zero, as Embree's manual advises.
 * - Shading in float, for as many hits at a time as the vectors hold, compiled for
 *   this very machine with -ffast-math.
 */
#ifndef EmbreeRenderer_h
#define EmbreeRenderer_h

#include "Scenes.h"

#include "vtkImageData.h"

#include <memory>

enum class TreeQuality
{
  Low,
  Medium,
  High
};

enum class RayGrouping
{
  Single,      ///< rtcIntersect1
  Packets,     ///< rtcIntersect16, or 8 where vectors are not that wide
  Stream,      ///< rtcIntersect1M, a tile at a time
  PacketStream ///< rtcIntersectNM, a tile of packets at a time
};

constexpr TreeQuality treeQualities[] = { TreeQuality::Low, TreeQuality::Medium,
  TreeQuality::High };
constexpr RayGrouping rayGroupings[] = { RayGrouping::Single, RayGrouping::Packets,
  RayGrouping::Stream, RayGrouping::PacketStream };
const char* nameOf(TreeQuality quality);
const char* nameOf(RayGrouping grouping);

class EmbreeRenderer
{
public:
  explicit EmbreeRenderer(const BenchmarkScene& scene);
  ~EmbreeRenderer();

  /// Seconds for a tree, from nothing. It replaces the last one of that quality.
  double build(TreeQuality quality);

  /// Forget a tree; give back its memory.
  void release(TreeQuality quality);

  /// Seconds from that tree to the bytes of a newly allocated image.
  double trace(TreeQuality quality, RayGrouping grouping);

  vtkImageData* picture() { return this->Picture; }

  /// Of a packet.
  int raysAtOnce() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
  vtkSmartPointer<vtkImageData> Picture;
};

#endif
