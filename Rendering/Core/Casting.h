// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cast the rays of a cell at the triangles in its bins
 *
 * Each triangle is brought into the camera's frame and tested with intersect()
 * against the rays of its box. Before that, one from a coarser cell is tested
 * against the cell as a whole: if for all rays of the cell one edge function
 * certainly has the other sign than the sum, none of them can hit.
 */
#ifndef lambent_Casting_h
#define lambent_Casting_h

#include "Bins.h"
#include "CameraFrame.h"
#include "Mesh.h"
#include "NearestHits.h"

namespace lambent
{
class Casting
{
public:
  /// origin: the image's pixel that pixel (0, 0) of the grid is.
  Casting(const Mesh& mesh, const CameraFrame& frame, const CellGrid& grid, const Window& image)
    : Triangles(mesh)
    , Frame(frame)
    , Grid(grid)
    , Image(image)
  {
  }

  /// Offer to the hits of a cell what its rays meet on a page of one of its bins,
  /// or of the cells above it. level: the one that the page's bin belongs to;
  /// (column, row): the bin's cell there.
  void run(const BinPage& page, const CellGrid::Level& level, int column, int row,
    NearestHits& hits) const;

private:
  struct Triangle
  {
    FramePoint a, b, c;
    bool cullFront, cullBack;
  };
  Triangle triangle(std::uint32_t number) const;
  bool misses(const Triangle& triangle, const Window& cell) const;
  void test(const Triangle& triangle, std::uint32_t number, const Window& rays,
    NearestHits& hits) const;

  const Mesh& Triangles;
  const CameraFrame& Frame;
  const CellGrid& Grid;
  const Window Image;
};
}

#endif
