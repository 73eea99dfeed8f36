// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cast the rays of a cell at the triangles in its bins
 *
 * A triangle is brought into the camera's frame and tested with intersect()
 * against the rays of its box. That is the definition, and what castPlainly()
 * does. cast() collects triangles and leaves them to the kernel of CastingKernel.h,
 * which gives the same bits.
 *
 * A hit comes with a range of nearness, or with its depth. Where two ranges do not
 * overlap they tell which hit is nearer; elsewhere both depths are computed.
 */
#ifndef lambent_Casting_h
#define lambent_Casting_h

#include "Bins.h"
#include "CastBatch.h"
#include "CellRays.h"
#include "Mesh.h"

namespace lambent
{
class Casting
{
public:
  Casting(const Mesh& mesh, const CameraFrame& frame, const CellGrid& grid)
    : Triangles(mesh)
    , Frame(frame)
    , Grid(grid)
  {
  }

  /// Offer to the rays of a cell what they meet of triangles in a bin that it is in, a
  /// page of them at the most.
  void castPlainly(
    const BinEntry* entries, int count, const CellGrid::Level& level, CellRays& rays) const;

  /// The same with the kernel; some of it is left in the batch until flush().
  void cast(const BinEntry* entries, int count, const CellGrid::Level& level, CellRays& rays,
    CastBatch& batch) const;
  void flush(CellRays& rays, CastBatch& batch) const;

  /// Offer hits that are certain.
  void addHits(const Fragment* hits, int count, CellRays& rays) const;

  /// Offer all hits of the same rays.
  void merge(const CellRays& from, CellRays& rays) const;

  /// The hit of the ray through (x, y) on a triangle, if there is one.
  bool hits(std::uint32_t triangle, double x, double y, double& depth) const;

private:
  struct Triangle
  {
    FramePoint a, b, c;
    bool cullFront, cullBack;
  };
  Triangle triangle(std::uint32_t number) const;

  /// A triangle whose points are on their way from memory.
  struct Candidate
  {
    const Surface* surface;
    std::uint64_t corners[3];
  };
  void fetch(const BinEntry* entries, int count, Candidate* candidates) const;
  void add(std::uint32_t number, const Candidate& candidate, const Window& box, CellRays& rays,
    CastBatch& batch) const;

  Window boxIn(const CellRays& rays, const CellGrid::Level& level, const BinEntry& entry) const;
  void test(
    const Triangle& triangle, std::uint32_t number, const Window& box, CellRays& rays) const;

  void offer(const Fragment& hit, CellRays& rays) const;
  void offer(std::size_t ray, double depth, std::uint32_t triangle, CellRays& rays) const;
  void findDepth(std::size_t ray, CellRays& rays) const;
  double depthAt(std::uint32_t triangle, const CellRays& rays, std::size_t ray) const;

  const Mesh& Triangles;
  const CameraFrame& Frame;
  const CellGrid& Grid;
};
}

#endif
