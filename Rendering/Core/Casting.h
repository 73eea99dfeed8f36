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
 * A triangle from a coarser cell is first tested against the cell as a whole: if
 * for all of its rays one edge function certainly has the other sign than the sum,
 * none of them can hit.
 *
 * Hits that are certain already come with a range of depths. Where two ranges do not
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

  /// Let the hits of known depth be the nearest of all. withDepths: and their depths
  /// right, too.
  void settle(CellRays& rays, bool withDepths) const;

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
  void add(std::uint32_t number, const Candidate& candidate, const Window& box, bool isBoxExact,
    CellRays& rays, CastBatch& batch) const;

  bool misses(const Triangle& triangle, const CellRays& rays, const Window& box) const;
  Window boxIn(const CellRays& rays, const CellGrid::Level& level, const BinEntry& entry) const;
  void test(
    const Triangle& triangle, std::uint32_t number, const Window& box, CellRays& rays) const;
  double depthAt(std::int64_t triangle, const CellRays& rays, std::size_t ray) const;

  const Mesh& Triangles;
  const CameraFrame& Frame;
  const CellGrid& Grid;
};
}

#endif
