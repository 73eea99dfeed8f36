// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleBinning.h"

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
}

void TriangleBinning::add(const SceneMesh::Part& part, std::size_t begin, std::size_t end,
  TriangleBinningMemory& memory, BinningResult& result) const
{
  while (begin < end)
  {
    const auto room = static_cast<std::size_t>(LatticeBoxes::capacity - memory.boxes.count);
    const std::size_t next = std::min(begin + room, end);
    this->addBatch(part, begin, next, memory, result);
    begin = next;
  }
}

/// Adds triangles of a surface to the batch whose boxes are found next.
void TriangleBinning::addBatch(const SceneMesh::Part& part, std::size_t begin, std::size_t end,
  TriangleBinningMemory& memory, BinningResult& result) const
{
  const std::size_t pointCount = part.pointCount();
  LatticeBoxes& boxes = memory.boxes;
  std::size_t offset =
    memory.parts.empty() ? 0 : part.firstPoint - memory.parts.front().part->firstPoint;
  if (offset + pointCount > maximumPoints)
  {
    this->binBoxes(memory, result);
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
      this->binPlainly(part, t, result);
    }
    return;
  }
  memory.parts.push_back(
    { &part, begin, first, static_cast<std::uint32_t>(boxes.count), offset32 });
  if (boxes.count == LatticeBoxes::capacity)
  {
    this->binBoxes(memory, result);
  }
}

void TriangleBinning::binBoxes(TriangleBinningMemory& memory, BinningResult& result) const
{
  LatticeBoxes& boxes = memory.boxes;
  if (boxes.count == 0)
  {
    return;
  }
  findBoxes(this->Positions + memory.parts.front().part->firstPoint, boxes);
  memory.parts.size() == 1 ? this->binFound<true>(memory, result)
                           : this->binFound<false>(memory, result);
  this->binUnplaced(memory, result);
  boxes.count = 0;
  memory.parts.clear();
}

/// What binFound() needs of a part, in local variables.
struct TriangleBinning::BoxedPartView
{
  const SceneMesh::Part* part;
  TupleSpan points;
  std::uint32_t first; ///< the triangle of place 0
  std::int32_t offset;
  bool isCulling;
};

TriangleBinning::BoxedPartView TriangleBinning::viewOf(const BoxedPart& boxed) const
{
  const SceneMesh::Part& part = *boxed.part;
  return { &part, part.points(),
    static_cast<std::uint32_t>(part.firstPrimitive + boxed.begin - boxed.first), boxed.offset,
    part.isCulling() };
}

/// Calls body(place, view) for places in the batch, in order.
template <bool IsOnePart, typename Body>
void TriangleBinning::forPlaces(const std::uint32_t* places, int count,
  const TriangleBinningMemory& memory, const Body& body) const
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
void TriangleBinning::binFound(TriangleBinningMemory& memory, BinningResult& result) const
{
  const LatticeBoxes& boxes = memory.boxes;
  memory.small.begin(*memory.parts.front().part, IsOnePart);
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
        hwy::Prefetch(view.points.at(corners[corner])); // for Small and insert()
      }
      const LatticePosition first = boxes.first[place], end = boxes.end[place];
      const int width = end.column - first.column, height = end.row - first.row;
      if (isUngrouped && boxes.isInexact[place] == 0 && !view.isCulling &&
        width <= SmallTriangles::side && height <= SmallTriangles::side)
      {
        this->Small.add({ view.first + place, { corners[0], corners[1], corners[2] }, first },
          width, height, memory.small, result);
      }
      else
      {
        large[largeCount++] = place;
      }
    });
  this->forPlaces<IsOnePart>(large, largeCount, memory,
    [&](std::uint32_t place, const BoxedPartView& view)
    { this->insert(place, view, memory, result); });
}

void TriangleBinning::binUnplaced(TriangleBinningMemory& memory, BinningResult& result) const
{
  this->forPlaces<false>(memory.boxes.unplacedTriangles, memory.boxes.unplaced, memory,
    [&](std::uint32_t place, const BoxedPartView& view)
    { this->binPlainly(*view.part, view.first + place - view.part->firstPrimitive, result); });
}

/// Inserts a triangle that is not small, or whose box is not exact.
void TriangleBinning::insert(std::uint32_t place, const BoxedPartView& view,
  const TriangleBinningMemory& memory, BinningResult& result) const
{
  const LatticeBoxes& boxes = memory.boxes;
  const Window box = this->Lattice.samplesFrom(boxes.first[place], boxes.end[place]);
  result.shallowArea -= static_cast<std::int64_t>(box.width()) * box.height();
  result.bins.insert(view.first + place, box,
    this->Lattice.shift() == 0 && boxes.isInexact[place] == 0,
    result.shallowArea < 0 ? this->nearnessBound(place, view, boxes) : anyNearness);
}

/// At least the nearness of all hits of a triangle.
float TriangleBinning::nearnessBound(
  std::uint32_t place, const BoxedPartView& view, const LatticeBoxes& boxes) const
{
  double nearest = std::numeric_limits<double>::infinity();
  bool isBound = true; // pixels are larger than smallestPixel, or the points would have no place
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const std::int32_t point = boxes.corners[3 * place + corner] - view.offset;
    const FramePoint p = this->Frame.toFrame(view.points[point]);
    nearest = std::min(nearest, p.z);
    isBound = isBound && isZeroOrOrdinary(p.x) && isZeroOrOrdinary(p.y);
  }
  return isBound ? nearnessOf(nearest, this->Frame.parallel).high : anyNearness;
}

void TriangleBinning::binPlainly(
  const SceneMesh::Part& part, std::size_t t, BinningResult& result) const
{
  Bins& bins = result.bins;
  MeshDefects& defects = result.defects;
  const Surface& surface = *part.surface;
  const LatticePosition* positions = this->Positions + part.firstPoint;
  const auto triangle = static_cast<std::uint32_t>(part.firstPrimitive + t);
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

bool TriangleBinning::isBehindEye(const TupleSpan& points, const std::uint64_t corners[3]) const
{
  return !(this->Frame.toFrame(points[corners[0]]).z > 0.0 ||
    this->Frame.toFrame(points[corners[1]]).z > 0.0 ||
    this->Frame.toFrame(points[corners[2]]).z > 0.0);
}
}
