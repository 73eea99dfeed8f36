// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Binning.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <limits>

namespace lambent
{
namespace
{
// The kernels number points in 32 bits.
constexpr std::size_t maximumPoints = std::numeric_limits<std::int32_t>::max();

// For fewer triangles, calling a kernel takes longer.
constexpr std::size_t fewTriangles = 8;

/// Does the same as addCorners().
bool addFewCorners(const IndexSpan& corners, std::size_t begin, std::size_t end,
  std::size_t pointCount, std::int32_t offset, LatticeBoxes& boxes)
{
  bool isSound = true;
  std::int32_t* out = boxes.corners + 3 * boxes.count;
  for (std::size_t corner = 3 * begin; corner < 3 * end; ++corner)
  {
    const std::uint64_t point = corners[corner];
    isSound = isSound && point < pointCount;
    *out++ = static_cast<std::int32_t>(point) + offset;
  }
  boxes.count += isSound ? static_cast<int>(end - begin) : 0;
  return isSound;
}

/// The nearness of a triangle whose depth is unknown. No triangle is nearer.
constexpr float anyNearness = std::numeric_limits<float>::infinity();

/// Copies the corners of the triangles [begin, end). The loop is short so that the processor can
/// fetch the points of several triangles at a time.
template <typename Coordinate>
void loadCorners(
  const SmallTriangles& small, int begin, int end, const Coordinate* points, CoverageBatch& batch)
{
  for (int k = begin; k < end; ++k)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const Coordinate* point =
        points + 3 * static_cast<std::size_t>(small.items[k].corners[corner]);
      batch.points[3 * corner][k] = point[0];
      batch.points[3 * corner + 1][k] = point[1];
      batch.points[3 * corner + 2][k] = point[2];
    }
  }
}

void loadCorners(
  const SmallTriangles& small, int begin, int end, const TupleSpan& points, CoverageBatch& batch)
{
  points.isDouble ? loadCorners(small, begin, end, static_cast<const double*>(points.data), batch)
                  : loadCorners(small, begin, end, static_cast<const float*>(points.data), batch);
}
}

void Binning::run(std::size_t begin, std::size_t end, BinningMemory& memory) const
{
  this->Mesh.mesh().forTriangles(begin, end,
    [&](const SceneMesh::Part& part, std::size_t partBegin, std::size_t partEnd)
    {
      while (partBegin < partEnd)
      {
        const auto room = static_cast<std::size_t>(LatticeBoxes::capacity - memory.boxes.count);
        const std::size_t next = std::min(partBegin + room, partEnd);
        this->add(part, partBegin, next, memory);
        partBegin = next;
      }
    });
  this->binBoxes(memory);
}

/// Adds triangles of a surface to the batch whose boxes are found next.
void Binning::add(
  const SceneMesh::Part& part, std::size_t begin, std::size_t end, BinningMemory& memory) const
{
  const std::size_t pointCount = part.pointCount();
  LatticeBoxes& boxes = memory.boxes;
  std::size_t offset =
    memory.parts.empty() ? 0 : part.firstPoint - memory.parts.front().part->firstPoint;
  if (offset + pointCount > maximumPoints)
  {
    this->binBoxes(memory);
    offset = 0;
  }
  const auto first = static_cast<std::uint32_t>(boxes.count);
  const auto offset32 = static_cast<std::int32_t>(offset);
  const bool isFew = end - begin < fewTriangles;
  if (!this->Kernels || pointCount == 0 || pointCount > maximumPoints ||
    !(isFew ? addFewCorners(part.corners(), begin, end, pointCount, offset32, boxes)
            : addCorners(part.corners(), begin, end, pointCount, offset32, boxes)))
  {
    for (std::size_t t = begin; t < end; ++t)
    {
      this->binPlainly(part, t, memory);
    }
    return;
  }
  memory.parts.push_back(
    { &part, begin, first, static_cast<std::uint32_t>(boxes.count), offset32 });
  if (boxes.count == LatticeBoxes::capacity)
  {
    this->binBoxes(memory);
  }
}

void Binning::binBoxes(BinningMemory& memory) const
{
  LatticeBoxes& boxes = memory.boxes;
  if (boxes.count == 0)
  {
    return;
  }
  findBoxes(this->Positions + memory.parts.front().part->firstPoint, boxes);
  memory.parts.size() == 1 ? this->binFound<true>(memory) : this->binFound<false>(memory);
  this->binUnplaced(memory);
  boxes.count = 0;
  memory.parts.clear();
}

/// What binFound() needs of a part, in local variables.
struct Binning::BoxedPartView
{
  const SceneMesh::Part* part;
  TupleSpan points;
  std::uint32_t first; ///< the triangle of place 0
  std::int32_t offset;
  bool isCulling;
};

Binning::BoxedPartView Binning::viewOf(const BoxedPart& boxed) const
{
  const SceneMesh::Part& part = *boxed.part;
  return { &part, part.points(),
    static_cast<std::uint32_t>(part.firstTriangle + boxed.begin - boxed.first), boxed.offset,
    part.isCulling() };
}

/// Calls body(place, view) for places in the batch, in order.
template <bool IsOnePart, typename Body>
void Binning::forPlaces(
  const std::uint32_t* places, int count, const BinningMemory& memory, const Body& body) const
{
  const BoxedPart* boxed = memory.parts.data();
  BoxedPartView view = this->viewOf(*boxed);
  for (int k = 0; k < count; ++k)
  {
    if (!IsOnePart && places[k] >= boxed->end)
    {
      while (places[k] >= boxed->end)
      {
        ++boxed;
      }
      view = this->viewOf(*boxed);
    }
    body(places[k], view);
  }
}

/// Bins the triangles that have a sample in their box.
template <bool IsOnePart>
void Binning::binFound(BinningMemory& memory) const
{
  const LatticeBoxes& boxes = memory.boxes;
  const SceneMesh::Part* part = memory.parts.front().part;
  memory.isMixed = memory.isMixed || !IsOnePart || (memory.part && memory.part != part);
  memory.part = part;
  const bool isUngrouped = this->Lattice.shift() == 0;
  std::uint32_t large[LatticeBoxes::capacity];
  int largeCount = 0;
  this->forPlaces<IsOnePart>(boxes.triangles, boxes.found, memory,
    [&](std::uint32_t place, const BoxedPartView& view)
    {
      std::int32_t corners[3];
      for (int corner = 0; corner < 3; ++corner)
      {
        corners[corner] = boxes.corners[3 * place + corner] - (IsOnePart ? 0 : view.offset);
        hwy::Prefetch(view.points.at(corners[corner])); // for flush() and insert()
      }
      const LatticePosition first = boxes.first[place], end = boxes.end[place];
      const int width = end.column - first.column, height = end.row - first.row;
      if (isUngrouped && boxes.isInexact[place] == 0 && !view.isCulling &&
        width <= SmallTriangles::side && height <= SmallTriangles::side)
      {
        this->addSmall({ view.first + place, { corners[0], corners[1], corners[2] }, first }, width,
          height, memory);
      }
      else
      {
        large[largeCount++] = place;
      }
    });
  this->forPlaces<IsOnePart>(large, largeCount, memory,
    [&](std::uint32_t place, const BoxedPartView& view) { this->insert(place, view, memory); });
}

void Binning::binUnplaced(BinningMemory& memory) const
{
  this->forPlaces<false>(memory.boxes.unplacedTriangles, memory.boxes.unplaced, memory,
    [&](std::uint32_t place, const BoxedPartView& view)
    { this->binPlainly(*view.part, view.first + place - view.part->firstTriangle, memory); });
}

/// Inserts a triangle that is not small, or whose box is not exact.
void Binning::insert(std::uint32_t place, const BoxedPartView& view, BinningMemory& memory) const
{
  const LatticeBoxes& boxes = memory.boxes;
  double nearest = std::numeric_limits<double>::infinity();
  bool isBound = true; // pixels are larger than smallestPixel, or the points would have no place
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const std::int32_t point = boxes.corners[3 * place + corner] - view.offset;
    const FramePoint p = this->Frame.toFrame(view.points[point]);
    nearest = std::min(nearest, p.z);
    isBound = isBound && isZeroOrOrdinary(p.x) && isZeroOrOrdinary(p.y);
  }
  memory.bins.insert(view.first + place,
    this->Lattice.samplesFrom(boxes.first[place], boxes.end[place]),
    this->Lattice.shift() == 0 && boxes.isInexact[place] == 0,
    isBound ? nearnessOf(nearest, this->Frame.parallel).high : anyNearness);
}

void Binning::addSmall(
  const SmallTriangle& triangle, int width, int height, BinningMemory& memory) const
{
  SmallTriangles& small = memory.small[height - 1][width - 1];
  small.items[small.count++] = triangle;
  if (small.count == SmallTriangles::capacity)
  {
    this->flush(width, height, memory);
  }
}

void Binning::flush(BinningMemory& memory) const
{
  for (int height = 1; height <= SmallTriangles::side; ++height)
  {
    for (int width = 1; width <= SmallTriangles::side; ++width)
    {
      if (memory.small[height - 1][width - 1].count > 0)
      {
        this->flush(width, height, memory);
      }
    }
  }
  memory.part = nullptr;
  memory.isMixed = false;
}

void Binning::load(int width, int height, BinningMemory& memory) const
{
  const SmallTriangles& small = memory.small[height - 1][width - 1];
  CoverageBatch& batch = memory.batch;
  batch.count = small.count;
  batch.width = width;
  batch.height = height;
  for (int k = 0; k < small.count; ++k)
  {
    batch.triangles[k] = small.items[k].number;
    batch.i[k] = small.items[k].first.column;
    batch.j[k] = small.items[k].first.row;
  }
  if (!memory.isMixed)
  {
    loadCorners(small, 0, small.count, memory.part->points(), batch);
    return;
  }
  for (int k = 0; k < small.count; ++k)
  {
    loadCorners(small, k, k + 1, this->Mesh.mesh().partOf(small.items[k].number).points(), batch);
  }
}

void Binning::flush(int width, int height, BinningMemory& memory) const
{
  SmallTriangles& small = memory.small[height - 1][width - 1];
  CoveredSamples& covered = memory.covered;
  this->load(width, height, memory);
  const CoverageBatch& batch = memory.batch;
  findCoverage(batch, this->Lattice, covered);
  small.count = 0;
  memory.bins.insertHits(covered.certain,
    [&](int k) -> Bins::SampleHit
    {
      const CoveredSample sample = covered.certainSamples[k];
      const int t = sample.triangle();
      return { batch.i[t] + sample.i(), batch.j[t] + sample.j(), batch.triangles[t],
        { covered.lows[t], covered.highs[t] } };
    });
  for (int k = 0; k < covered.uncertain; ++k)
  {
    const CoveredSample& sample = covered.uncertainSamples[k];
    const int t = sample.triangle();
    const std::uint32_t triangle = batch.triangles[t];
    const int i = batch.i[t] + sample.i(), j = batch.j[t] + sample.j();
    double depth;
    if (this->Mesh.hits(
          triangle, this->Frame.x(this->Part.i0 + i), this->Frame.y(this->Part.j0 + j), depth))
    {
      memory.bins.insertHit({ i, j, triangle, nearnessOf(depth, this->Frame.parallel) });
    }
  }
}

void Binning::binPlainly(const SceneMesh::Part& part, std::size_t t, BinningMemory& memory) const
{
  Bins& bins = memory.bins;
  MeshDefects& defects = memory.defects;
  const Surface& surface = *part.surface;
  const LatticePosition* positions = this->Positions + part.firstPoint;
  const auto triangle = static_cast<std::uint32_t>(part.firstTriangle + t);
  const std::uint64_t corners[3] = { surface.corners[3 * t], surface.corners[3 * t + 1],
    surface.corners[3 * t + 2] };
  if (std::max(corners[0], std::max(corners[1], corners[2])) >= surface.points.size)
  {
    defects.wrongCorner = std::min(defects.wrongCorner, triangle);
    return;
  }
  const LatticePosition a = positions[corners[0]];
  const LatticePosition b = positions[corners[1]];
  const LatticePosition c = positions[corners[2]];
  if (std::max(a.column, std::max(b.column, c.column)) < LatticePosition::notFinite)
  {
    const Window samples =
      this->Culling ? this->Lattice.samplesBetween(a, b, c) : this->Grid.whole();
    if (!samples.empty())
    {
      bins.insert(triangle, samples, this->Culling && this->Lattice.isExact(a, b, c), anyNearness);
    }
  }
  else if (a.column == LatticePosition::notFinite || b.column == LatticePosition::notFinite ||
    c.column == LatticePosition::notFinite)
  {
    // All triangles of such a cell get here; count it once.
    defects.notFinite += t == 0 || surface.cellOf(t) != surface.cellOf(t - 1);
    defects.firstNotFinite = std::min(defects.firstNotFinite, triangle);
  }
  else if (!this->Culling || !this->isBehindEye(surface.points, corners))
  {
    bins.insert(triangle, this->Grid.whole(), false, anyNearness);
  }
}

bool Binning::isBehindEye(const TupleSpan& points, const std::uint64_t corners[3]) const
{
  return !(this->Frame.toFrame(points[corners[0]]).z > 0.0 ||
    this->Frame.toFrame(points[corners[1]]).z > 0.0 ||
    this->Frame.toFrame(points[corners[2]]).z > 0.0);
}
}
