// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Binning.h"

namespace lambent
{
void Binning::run(std::size_t begin, std::size_t end, Bins& bins, MeshDefects& defects) const
{
  this->Triangles.forTriangles(
    begin, end, [&](const Mesh::Part& part, std::size_t partBegin, std::size_t partEnd) {
      this->runPart(part, partBegin, partEnd, bins, defects);
    });
}

void Binning::runPart(const Mesh::Part& part, std::size_t begin, std::size_t end, Bins& bins,
  MeshDefects& defects) const
{
  const Surface& surface = *part.surface;
  const std::size_t pointCount = surface.points.size;
  const LatticePosition* positions = this->Positions + part.firstPoint;
  for (std::size_t t = begin; t < end; ++t)
  {
    const auto triangle = static_cast<std::uint32_t>(part.firstTriangle + t);
    const std::uint64_t corners[3] = { surface.corners[3 * t], surface.corners[3 * t + 1],
      surface.corners[3 * t + 2] };
    if (corners[0] >= pointCount || corners[1] >= pointCount || corners[2] >= pointCount)
    {
      defects.wrongCorner = std::min(defects.wrongCorner, triangle);
      continue;
    }
    const LatticePosition a = positions[corners[0]];
    const LatticePosition b = positions[corners[1]];
    const LatticePosition c = positions[corners[2]];
    if (std::max(a.column, std::max(b.column, c.column)) < LatticePosition::notFinite)
    {
      const Window rays =
        this->Culling ? this->Lattice.raysBetween(a, b, c) : this->Grid.whole();
      if (!rays.empty())
      {
        bins.insert(triangle, rays, this->Culling && this->Lattice.isExact(a, b, c));
      }
    }
    else if (a.column == LatticePosition::notFinite || b.column == LatticePosition::notFinite ||
      c.column == LatticePosition::notFinite)
    {
      // All triangles of such a cell are; it counts once.
      defects.notFinite += t == 0 || surface.cellOf(t) != surface.cellOf(t - 1);
      defects.firstNotFinite = std::min(defects.firstNotFinite, triangle);
    }
    else if (!this->Culling || !this->isBehindEye(surface.points, corners))
    {
      bins.insert(triangle, this->Grid.whole(), false);
    }
  }
}

bool Binning::isBehindEye(const TupleSpan& points, const std::uint64_t corners[3]) const
{
  return !(this->Frame.toFrame(points[corners[0]]).z > 0.0 ||
    this->Frame.toFrame(points[corners[1]]).z > 0.0 ||
    this->Frame.toFrame(points[corners[2]]).z > 0.0);
}
}
