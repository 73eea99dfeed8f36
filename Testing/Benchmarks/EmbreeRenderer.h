// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief render the same picture with Embree: build a tree, trace the rays, shade the hits
 *
 * Embree gets the best conditions:
 *
 * - Float points and 32-bit corners are prepared in advance, padded as Embree requires,
 *   and shared with it without a copy. The conversion is not timed.
 * - Trees of all three qualities (low is the Morton-code builder, high splits
 *   triangles), no robust flag, no compact trees, no filters.
 * - Rays are traced in tiles of 16 x 16 pixels: one at a time, in packets as wide as the
 *   machine's vectors (blocks of 16 or 8 pixels), or as streams of a whole tile. All are
 *   flagged coherent. Embree's own thread pool, TBB's, distributes the tiles.
 * - Denormals are flushed to zero, as Embree's manual recommends.
 * - Shading uses floats, for as many hits at a time as the vectors hold, and is compiled
 *   for this machine with -ffast-math. Several samples per pixel are averaged tile by tile.
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
  Packets,     ///< rtcIntersect16, or rtcIntersect8 for narrower vectors
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

  /// The seconds to build a tree from scratch. It replaces the last one of that quality.
  double build(TreeQuality quality);

  /// Free a tree.
  void release(TreeQuality quality);

  /// The seconds from that tree to the bytes of a newly allocated image, with samples x samples
  /// rays per pixel.
  double trace(TreeQuality quality, RayGrouping grouping, int samples = 1);

  /// The same with transparent surfaces: all hits of each ray, in packets. Another tree is built
  /// before, which calls a filter for each hit.
  double traceLayers(TreeQuality quality);

  vtkImageData* picture() { return this->Picture; }

  /// The number of rays in a packet.
  int raysAtOnce() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
  vtkSmartPointer<vtkImageData> Picture;
};

#endif
