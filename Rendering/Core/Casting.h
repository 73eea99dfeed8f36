// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cast the rays of a cell at the triangles in its bins
 *
 * A triangle is brought into the camera's frame and tested with intersect()
 * against the rays of its box. That is the definition, and what castPlainly()
 * does. cast() collects triangles by the size of their boxes and leaves them to
 * the kernels of CastingKernel.h, which give the same bits.
 *
 * A triangle from a coarser cell is first tested against the cell as a whole: if
 * for all of its rays one edge function certainly has the other sign than the sum,
 * none of them can hit.
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
  Casting(const Mesh& mesh, const CameraFrame& frame, const CellGrid& grid, const Window& image)
    : Triangles(mesh)
    , Frame(frame)
    , Grid(grid)
    , Image(image)
  {
  }

  /// Offer to the rays of a cell what they meet on a page of a bin that it is in.
  void castPlainly(const BinPage& page, const CellGrid::Level& level, CellRays& rays) const;

  /// The same with kernels; some of it is left in the batches until flush().
  void cast(
    const BinPage& page, const CellGrid::Level& level, CellRays& rays, CastBatches& batches) const;
  void flush(CellRays& rays, CastBatches& batches) const;

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
    std::uint32_t number;
    const Surface* surface;
    std::uint64_t corners[3];
  };
  void fetch(const BinPage& page, Candidate* candidates) const;
  bool misses(const Triangle& triangle, const CellRays& rays, const Window& box) const;
  Window boxIn(const CellRays& rays, const CellGrid::Level& level, const BinEntry& entry) const;
  void test(
    const Triangle& triangle, std::uint32_t number, const Window& box, CellRays& rays) const;
  void addSmall(
    const Candidate& candidate, const Window& box, CellRays& rays, SmallBatch& batch) const;
  void addLarge(const Candidate& candidate, const Window& box, bool isBoxExact, CellRays& rays,
    LargeBatch& batch) const;

  const Mesh& Triangles;
  const CameraFrame& Frame;
  const CellGrid& Grid;
  const Window Image;
};
}

#endif
